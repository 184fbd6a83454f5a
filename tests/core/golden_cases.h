/// Reads the reference results and measures how far an answer is from them; needs no test framework.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core::golden {

/// The cases of one file from the folder in the environment variable BATTEN_GOLDEN, else from tests/data/golden.
std::vector<nlohmann::json> cases(const std::string& file);

/// The curve whose members stand in `members`, which is a case or one of its results.
Curve curve_of(const nlohmann::json& members);

/// [[x, y], ...]
std::vector<Point> points_of(const nlohmann::json& points);

/// Whether degree or weights allow three digits less.
bool is_hard(const Curve& curve);

/// The largest |coordinate|, the measure of errors of points.
double largest_coordinate(std::span<const Point> points);

/// The largest |coordinate difference|.
double largest_difference(std::span<const Point> a, std::span<const Point> b);

/// The largest |difference|.
double largest_difference(std::span<const double> a, std::span<const double> b);

/// `error` in units of `scale`; where the scale is zero only zero is right.
double relative(double error, double scale);

}  // namespace batten::core::golden
