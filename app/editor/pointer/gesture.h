/// What all pointer modes share: clicks and drags told apart, round numbers.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/pointer/pointer.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// What a mode sees of one event.
struct Gesture {
    const PointerEvent& event;
    const EditorState& state;
    CommandQueue& queue;
    const TypedPlace* typed = nullptr;           ///< for the place that it is about, where not as in the state
    std::optional<ShownPlace>* place = nullptr;  ///< is told what place was asked for
};

inline constexpr double zoom_per_notch = 1.15;  ///< of the wheel
inline constexpr double pan_per_notch = 60.0;   ///< design pixels
inline constexpr double snap_reach = 8.0;       ///< design pixels

/// What is typed for the place that the gesture is about.
const TypedPlace& typed_for(const Gesture& gesture);

/// Whether numbers are typed for the place that the gesture is about.
bool is_typed(const Gesture& gesture);

/// A distance of `design_px` on this display, in pixels.
double pixels(const EditorState& state, double design_px);

/// The place in the plane of the curves under the pointer.
core::Point world_at_pointer(const Gesture& gesture);

/// Whether the pointer has moved from `press_px` to `position_px` by so much (3 design pixels) that a drag is meant,
/// not a click.
bool is_drag(const EditorState& state, glm::dvec2 press_px, glm::dvec2 position_px);

/// A press with the middle button, or with the left one while Space is held.
bool is_pan(const PointerEvent& event);

/// Moves the view with the pointer from such a press to the release, while `panned_px` is where the pointer was last.
/// Returns whether the event was about that.
bool step_pan(std::optional<glm::dvec2>& panned_px, const Gesture& gesture);

/// By how many pixels a turn of the wheel pans to the right: a sideways one, or one with Shift; none where it zooms.
std::optional<double> wheel_pan(const EditorState& state, const PointerEvent& event);

/// The committed active curve, which gestures start from; null without one.
const core::Curve* committed_curve(const EditorState& state);

/// The point of the committed active curve, which must be there, that is nearest to the pointer.
core::CurveSample nearest_to_pointer(const Gesture& gesture);

/// Whether the active curve is there, visible and not locked, so that a drag may begin.
bool can_edit_curve(const EditorState& state);

/// The same; where it is not, says why.
bool may_edit_curve(const Gesture& gesture);

/// The multiple of `step` nearest to `value`; for a step like 0.2, 0.05 or 0.001 the double nearest to the decimal
/// number.
double rounded_to_step(double value, double step);

/// The stored knot nearest to `u`, if that is within `reach` (>= 0, in parameter units).
std::optional<double> knot_near(const core::KnotVector& knots, double u, double reach);

/// The command that drags knot `index` to `u` as the mode that is chosen says; the distance counts where that is snap.
MoveKnot dragged_knot(const EditorState& state, std::size_t index, double u, double snap_distance);

/// The knot of the shown curve (an index in stored()) that moves when the committed knot `index` is dragged: the one of
/// its stack that the preview has elsewhere, else `index` itself.
std::size_t moving_knot(const EditorState& state, std::size_t index);

}  // namespace batten::editor
