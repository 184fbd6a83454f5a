/// Commands that add curves through and near points.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "core/base/geometry.h"
#include "core/make/parametrization.h"

namespace batten::editor {

struct Interpolate {
    std::vector<core::Point> points;
    int degree;  ///< lowered where there are too few points
    core::Parametrization parametrization;
    static const CommandSpec& spec();
};

struct InterpolateClosed {
    std::vector<core::Point> points;
    int degree;
    core::Parametrization parametrization;
    static const CommandSpec& spec();
};

struct InterpolateNatural {
    std::vector<core::Point> points;
    int degree;
    core::Parametrization parametrization;
    static const CommandSpec& spec();
};

struct InterpolateTangents {
    std::optional<core::Vector> start;  ///< the derivative there; none leaves it free
    std::optional<core::Vector> end;
    std::vector<core::Point> points;
    int degree;
    core::Parametrization parametrization;
    static const CommandSpec& spec();
};

struct FitPoints {
    std::size_t count;  ///< of control points
    std::vector<core::Point> points;
    int degree = 3;
    bool closed = false;
    double smoothing = 0.0;
    std::optional<core::Vector> start{};  ///< the derivative there; none leaves it free
    std::optional<core::Vector> end{};
    bool natural = false;  ///< no second derivative at the ends
    static const CommandSpec& spec();
};

struct FitPointsWithin {
    double tolerance;
    std::vector<core::Point> points;
    int degree = 3;
    bool closed = false;
    double smoothing = 0.0;
    std::optional<core::Vector> start{};
    std::optional<core::Vector> end{};
    bool natural = false;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
