/// The brush: which control points it holds and how much, and which part of the curve it paints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/pointer/brush_mode.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The radius of the brush in pixels of the picture, and in the plane of the curves.
double brush_radius_px(const EditorState& state);
double brush_reach(const EditorState& state);

/// The control points of the committed active curve that a soft move around `center` takes along, ascending; none
/// where there are more than a few thousand, which cannot be told apart. Cost O(log n) and what is found.
std::vector<HeldPoint> held_points(const EditorState& state, core::Point center);

/// What of the curve around C(u) is within `reach` of `center`, as one interval around u; of a periodic curve it may
/// go on beyond the domain, and is at most one period. The curve is followed by steps of an eighth of the reach, at
/// most a thousand. None where C(u) is not within reach.
std::optional<core::Interval> part_within(const core::Curve& curve, double u, core::Point center, double reach);

/// Both parts as one where they touch, else `painted`; of a periodic curve whichever period `added` is in.
core::Interval painted_over(const core::Curve& curve, core::Interval painted, core::Interval added);

/// What the brush does, for the status bar.
std::string brush_hint(const EditorState& state, const Brushing& mode);

}  // namespace batten::editor
