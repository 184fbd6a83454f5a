/// Commands on the list of curves of the document.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/document/document.h"

namespace batten::editor {

struct NewCurve {
    std::vector<core::Point> points;
    int degree = 3;  ///< lowered where there are too few points
    bool closed = false;
    static const CommandSpec& spec();
};

/// The uniform curve over these control points, clamped or periodic; an open one has a lower degree where there are too
/// few points.
core::Result<core::Curve> curve_of_control_points(std::vector<core::Point> points, int degree, bool closed);

struct DeleteCurve {
    std::size_t index;
    static const CommandSpec& spec();
};

struct DuplicateCurve {
    std::size_t index;
    double shift;  ///< to the right and down
    static const CommandSpec& spec();
};

struct RenameCurve {
    std::size_t index;
    std::string name;
    static const CommandSpec& spec();
};

struct SetCurveColor {
    std::size_t index;
    std::optional<core::DocumentColor> color;  ///< none: the theme's
    static const CommandSpec& spec();
};

struct SetCurveVisible {
    std::size_t index;
    bool visible;
    static const CommandSpec& spec();
};

struct SetCurveLocked {
    std::size_t index;
    bool locked;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
