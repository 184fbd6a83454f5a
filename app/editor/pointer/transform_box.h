/// The box around what is selected, with the grips by which it is scaled, turned, sheared and moved.
#pragma once

#include <memory>
#include <optional>

#include "app/editor/commands/transform_commands.h"
#include "app/editor/state/selected_parts.h"
#include "app/editor/state/state.h"
#include "app/editor/state/transform_grip.h"

namespace batten::editor {

/// What the transform tool acts on.
struct TransformBox {
    MapTarget what = MapTarget::curve;
    core::Box box;               ///< around its control points
    core::Point pivot{};         ///< what stays when it is turned: the middle of the box, if none was chosen
    bool has_own_pivot = false;  ///< one was chosen, which stays whatever is done
    std::shared_ptr<const SelectedBox> selected{};  ///< what is selected; no parts for the active curve

    bool is_of_active_curve() const { return selected->parts.empty(); }
};

/// That of what is selected, over several curves, in the committed document, else that of the active curve; none where
/// it must not be edited. Cost that of selected_box().
std::optional<TransformBox> transform_box(const EditorState& state);

/// Whether dragging the grip can do anything: a box without width has no grips that scale along x, and one without any
/// size no pivot, unless that was chosen.
bool has_grip(const TransformBox& box, TransformGrip grip);

/// All but the inside and the sides, for those who draw them.
std::vector<TransformGrip> visible_grips(const TransformBox& box);

/// The place of the box, in the world, that a grip stands for: a corner, the middle of a side, or the pivot.
core::Point grip_point(const TransformBox& box, TransformGrip grip);

/// Where the grip is in the picture: the grips stand a little outside of the box, so that no control point lies below.
glm::dvec2 grip_place(const EditorState& state, const TransformBox& box, TransformGrip grip);

/// The corners of the box that is drawn around that in the picture, in order.
std::vector<glm::dvec2> box_corners_px(const EditorState& state, const TransformBox& box);

/// The grip at a place of the picture: the pivot and handles within 9 design pixels, sides within 6, else the inside.
std::optional<TransformGrip> grip_at(const EditorState& state, glm::dvec2 position_px);

/// What is under the pointer for the transform tool: grips, then as hit_canvas(), then the inside of the box.
Hover hit_for_transform(const EditorState& state, glm::dvec2 position_px);

/// Whether a press on what is in the box is about that alone: a control point, or a curve that is not selected.
bool is_selected_by_press(const EditorState& state, const Hover& hit);

}  // namespace batten::editor
