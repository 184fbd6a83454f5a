/// What the pointer snaps to.
#pragma once

#include <span>

#include "app/editor/state/state.h"

namespace batten::editor {

/// What of the committed document a gesture moves, and must not snap to.
struct Dragged {
    std::span<const std::size_t> points{};  ///< control points of the active curve, ascending
    bool is_curve = false;                  ///< all of the active curve
    std::optional<std::size_t> guide{};
    std::optional<core::Point> from{};      ///< what angles and lengths count from, if not from where it was
    std::span<const SelectedPart> parts{};  ///< of any curves, ascending by curve
};

struct SnapQuery {
    core::Point place{};                ///< where the pointer is
    std::optional<core::Point> from{};  ///< where the gesture began, for angles, perpendiculars and tangents
    Dragged dragged{};
};

/// How far the pointer may be from what it snaps to, in world units.
double snap_distance(const EditorState& state);

/// What is near `query.place`, of the kinds that the view has switched on: the nearest of control points, ends,
/// crossings, knots, midpoints, tangents, perpendiculars and crossings of guides; else the nearest of guides, curves
/// and directions; else the grid, however far. What is hidden or dragged does not count; locked curves do. Where very
/// many points of a curve are within reach, which cannot be told apart, only its ends and its nearest place count.
/// Cost: O(log n) for each curve, and that of what is near.
std::optional<Snap> snap_at(const EditorState& state, const SnapQuery& query);

/// The corner of the minor grid that is nearest to `place`.
core::Point grid_corner(const EditorState& state, core::Point place);

/// The place of a guide that is nearest to `place`; exact where the guide is level or upright.
core::Point nearest_on_guide(const core::Guide& guide, core::Point place);

}  // namespace batten::editor
