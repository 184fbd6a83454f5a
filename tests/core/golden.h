/// Reads the reference results and compares answers with them.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/curve.h"

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

/// Collects the errors of one file. When destroyed it prints one line, "golden FILE: N cases, worst error E (allowed
/// A)".
class Tally {
  public:
    explicit Tally(std::string file) : file_(std::move(file)) {}
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;
    ~Tally();

    void count_case() { ++case_count_; }

    /// Records one relative error and fails the test, naming `name`, where it is above what is allowed.
    void add(const std::string& quantity, double error, double allowed, const std::string& name);

  private:
    struct Worst {
        double error = 0.0;
        double allowed = 0.0;
    };

    std::string file_;
    int case_count_ = 0;
    std::vector<std::string> quantities_;
    std::map<std::string, Worst> worst_;
};

}  // namespace batten::core::golden
