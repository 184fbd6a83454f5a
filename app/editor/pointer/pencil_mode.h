/// A stroke of the pencil: the smooth line is shown while the pen moves, and released it becomes a curve or a new part
/// of one.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

struct Gesture;

/// A stroke under way. Escape gives it up, and so does a change of the tool.
struct PencilStroke {
    std::vector<core::Point> samples;    ///< all of them
    std::vector<core::Point> settled{};  ///< the smooth line up to sample `settled_samples`, which stays as it is
    std::vector<core::Point> line{};     ///< from there to the pointer
    std::size_t settled_samples = 0;
    double pixel = 1.0;            ///< in the plane of the curves
    bool redraws = false;          ///< began on the active curve
    std::size_t tool_changes = 0;  ///< of the state when it began
};

/// The stroke that a press begins. With Alt it does not draw a part of a curve anew.
PencilStroke begin_stroke(const Gesture& gesture);

/// The pointer has moved on. The cost is bounded, however long the stroke is, but for the copying of its samples.
void draw_on(PencilStroke& stroke, const Gesture& gesture);

/// Asks for what the stroke means; for nothing where the pointer has not been dragged.
void finish_stroke(const PencilStroke& stroke, const Gesture& gesture);

}  // namespace batten::editor
