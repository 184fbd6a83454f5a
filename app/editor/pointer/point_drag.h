/// Where a dragged control point goes, and how a dragged weight grows.
#pragma once

#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/snap.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// What a weight can be dragged to.
inline constexpr core::Interval dragged_weights{1e-6, 1e6};

/// The world point under the pointer, or what it snaps to there; with Ctrl the nearest corner of the minor grid, with
/// Alt the point itself. `from` is what typed lengths and angles are measured from, and with Shift the axes too. What
/// is typed for the place rules. The gesture is told of it, for the picture.
core::Point pointed_at(const Gesture& gesture, std::optional<core::Point> from = std::nullopt);

/// Where a point that was at `start` when the pointer was pressed at `press_px` is to be now: Shift keeps it on the
/// axis along which the pointer moved farther, Ctrl puts the coordinates that may change on the minor grid. Else it
/// snaps, but not to what is `dragged`; Alt bypasses that. What is typed for the place rules. Axes, lengths and angles
/// count from `start` or what `dragged` says.
core::Point dragged_position(const Gesture& gesture, core::Point start, glm::dvec2 press_px,
                             const Dragged& dragged = {});

/// Where the tip of a handle that begins at `from` goes: likewise, but lengths, angles and axes are those of the
/// handle.
core::Point dragged_tip(const Gesture& gesture, core::Point from, core::Point start, glm::dvec2 press_px,
                        const Dragged& dragged = {});

/// An offset such that start + offset is `target` to the last bit, as far as there is one; that with the fewest digits,
/// by which what is typed for several points moves all of them.
core::Vector exact_offset(core::Point start, core::Point target);

/// `start_weight` after the pointer moved from `press_px` to the event's position; see DraggingWeight.
double dragged_weight(const Gesture& gesture, double start_weight, glm::dvec2 press_px);

}  // namespace batten::editor
