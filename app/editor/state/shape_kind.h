/// What the shape tool draws.
#pragma once

#include <cstddef>

#include "core/base/names.h"

namespace batten::editor {

enum class ShapeKind {
    line,                   ///< from end to end
    rectangle,              ///< from corner to corner
    polygon,                ///< from the center to a corner
    circle,                 ///< from the center to the circle
    circle_through_points,  ///< three
    arc,                    ///< center, start, end
    arc_through_points,     ///< start, end, a place between
    ellipse,                ///< center, end of one axis, a place on the other side
    conic                   ///< start, end, corner of the tangents
};

inline constexpr std::size_t shape_kind_count = 9;

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::ShapeKind> {
    using enum editor::ShapeKind;
    static constexpr std::array table{Named{line, "line", "line"},
                                      Named{rectangle, "rectangle", "rectangle"},
                                      Named{polygon, "polygon", "regular polygon"},
                                      Named{circle, "circle", "circle"},
                                      Named{circle_through_points, "circle-3", "circle through three points"},
                                      Named{arc, "arc", "arc by its center"},
                                      Named{arc_through_points, "arc-3", "arc through three points"},
                                      Named{ellipse, "ellipse", "ellipse"},
                                      Named{conic, "conic", "conic"}};
};

}  // namespace batten::core
