/// Commands that map selected control points, the active curve or all curves: affinely or projectively.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// What is mapped.
enum class MapTarget { selection, curve, all };

/// Where a pivot may be given, none is the middle of the box around the control points that are mapped.
using Pivot = std::optional<core::Point>;

struct Move {
    core::Vector offset;
    MapTarget what;
    static const CommandSpec& spec();
};

struct Rotate {
    double angle;  ///< in degrees, counterclockwise
    MapTarget what;
    Pivot pivot{};
    static const CommandSpec& spec();
};

struct Scale {
    double factor;
    MapTarget what;
    Pivot pivot{};
    static const CommandSpec& spec();
};

struct Stretch {
    double along_x;
    double along_y;
    MapTarget what;
    Pivot pivot{};
    static const CommandSpec& spec();
};

/// The axis along which a shear moves points.
enum class ShearAxis { x, y };

struct Shear {
    ShearAxis axis;
    double factor;  ///< how far for each unit across the axis
    MapTarget what;
    Pivot pivot{};
    static const CommandSpec& spec();
};

struct Mirror {
    double angle;  ///< of the line through the pivot, in degrees
    MapTarget what;
    Pivot pivot{};
    static const CommandSpec& spec();
};

struct MapAffinely {
    std::vector<double> x_row;  ///< x' = a x + b y + c
    std::vector<double> y_row;
    MapTarget what;
    static const CommandSpec& spec();
};

struct MapProjectively {
    std::vector<double> x_row;
    std::vector<double> y_row;
    std::vector<double> w_row;  ///< by which both are divided
    MapTarget what;
    static const CommandSpec& spec();
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::MapTarget> {
    using enum editor::MapTarget;
    static constexpr std::array table{Named{selection, "selection", "what is selected"},
                                      Named{curve, "curve", "the curve"}, Named{all, "all", "all curves"}};
};

template <>
struct Names<editor::ShearAxis> {
    using enum editor::ShearAxis;
    static constexpr std::array table{Named{x, "x", "along x"}, Named{y, "y", "along y"}};
};

}  // namespace batten::core
