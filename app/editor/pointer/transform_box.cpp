#include "app/editor/pointer/transform_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/editor/commands/map_selected.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {
namespace {

// Design pixels.
constexpr double box_margin = 12.0;     ///< from the control points to the box that is drawn
constexpr double turn_distance = 15.0;  ///< of the handles that turn, beyond the corners, along x and y
constexpr double grip_reach = 9.0;
constexpr double side_reach = 6.0;

constexpr std::array<std::array<int, 2>, 8> directions{
    {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};

bool is_corner(TransformGrip grip) {
    return grip.x != 0 && grip.y != 0;
}

/// The middle of an interval, or one of its ends.
double place_between(double lower, double upper, int direction) {
    if (direction == 0) return core::middle({lower, 0.0}, {upper, 0.0}).x;
    return direction < 0 ? lower : upper;
}

struct PixelFrame {
    glm::dvec2 lower;  ///< the upper left corner
    glm::dvec2 upper;

    glm::dvec2 at(TransformGrip grip) const {
        return {place_between(lower.x, upper.x, grip.x), place_between(lower.y, upper.y, -grip.y)};
    }
    bool contains(glm::dvec2 p) const { return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y; }
};

PixelFrame frame_of(const EditorState& state, const core::Box& box) {
    const glm::dvec2 margin(pixels(state, box_margin));
    const glm::dvec2 a = shown_place(state.view.camera, box.lower);
    const glm::dvec2 b = shown_place(state.view.camera, box.upper);
    return {glm::min(a, b) - margin, glm::max(a, b) + margin};
}

double distance_to_side(const PixelFrame& frame, TransformGrip side, glm::dvec2 p) {
    const glm::dvec2 place = frame.at(side);
    const bool is_upright = side.x != 0;
    const bool is_beside =
        is_upright ? frame.lower.y <= p.y && p.y <= frame.upper.y : frame.lower.x <= p.x && p.x <= frame.upper.x;
    if (!is_beside) return HUGE_VAL;
    return is_upright ? std::abs(p.x - place.x) : std::abs(p.y - place.y);
}

std::optional<TransformGrip> handle_at(const EditorState& state, const TransformBox& box, glm::dvec2 position_px) {
    Nearest<TransformGrip> nearest(pixels(state, grip_reach));
    for (const TransformGrip grip : visible_grips(box))
        nearest.offer(grip, glm::distance(grip_place(state, box, grip), position_px));
    return nearest.found();
}

std::optional<TransformGrip> side_at(const EditorState& state, const TransformBox& box, glm::dvec2 position_px) {
    const PixelFrame frame = frame_of(state, box.box);
    for (const auto& [x, y] : directions) {
        const TransformGrip side{GripKind::shear, x, y};
        if (!is_corner(side) && has_grip(box, side) &&
            distance_to_side(frame, side, position_px) <= pixels(state, side_reach))
            return side;
    }
    return std::nullopt;
}

}  // namespace

std::optional<TransformBox> transform_box(const EditorState& state) {
    TransformBox box;
    box.selected = selected_box(state);
    if (!box.is_of_active_curve()) {
        if (nothing_to_map(state)) return std::nullopt;
        box.what = MapTarget::selection;
        box.box = box.selected->box;
    } else {
        if (!can_edit_curve(state)) return std::nullopt;
        box.box = state.derived.of(*committed_curve(state))->control_box;
    }
    box.pivot = core::middle(box.box.lower, box.box.upper);
    const auto& pivot = state.pivot;
    box.has_own_pivot = pivot && pivot->curve == state.history.present().active && pivot->selected == state.selection;
    if (box.has_own_pivot) box.pivot = pivot->point;
    return box;
}

bool has_grip(const TransformBox& box, TransformGrip grip) {
    const core::Vector size = box.box.size();
    const bool has_width = size.x > 0.0;
    const bool has_height = size.y > 0.0;
    switch (grip.kind) {
        case GripKind::scale:
            return (grip.x == 0 || has_width) && (grip.y == 0 || has_height);
        case GripKind::shear:
            // A side goes along itself, the farther the farther it is from the opposite one.
            return grip.x != 0 ? has_width : has_height;
        case GripKind::pivot:
            // It would lie on all that can be dragged.
        case GripKind::turn:
            return has_width || has_height || box.has_own_pivot;
        case GripKind::inside:
            break;
    }
    return true;
}

std::vector<TransformGrip> visible_grips(const TransformBox& box) {
    const TransformGrip pivot{GripKind::pivot, 0, 0};
    std::vector<TransformGrip> grips;
    if (has_grip(box, pivot)) grips.push_back(pivot);
    for (const GripKind kind : {GripKind::scale, GripKind::turn})
        for (const auto& [x, y] : directions) {
            const TransformGrip grip{kind, x, y};
            if (has_grip(box, grip) && (kind == GripKind::scale || is_corner(grip))) grips.push_back(grip);
        }
    return grips;
}

core::Point grip_point(const TransformBox& box, TransformGrip grip) {
    if (grip.kind == GripKind::pivot) return box.pivot;
    return {place_between(box.box.lower.x, box.box.upper.x, grip.x),
            place_between(box.box.lower.y, box.box.upper.y, grip.y)};
}

glm::dvec2 grip_place(const EditorState& state, const TransformBox& box, TransformGrip grip) {
    if (grip.kind == GripKind::pivot) return shown_place(state.view.camera, box.pivot);
    const glm::dvec2 place = frame_of(state, box.box).at(grip);
    if (grip.kind != GripKind::turn) return place;
    return place + pixels(state, turn_distance) * glm::dvec2(grip.x, -grip.y);
}

std::vector<glm::dvec2> box_corners_px(const EditorState& state, const TransformBox& box) {
    const PixelFrame frame = frame_of(state, box.box);
    return {frame.lower, {frame.upper.x, frame.lower.y}, frame.upper, {frame.lower.x, frame.upper.y}};
}

std::optional<TransformGrip> grip_at(const EditorState& state, glm::dvec2 position_px) {
    const auto box = transform_box(state);
    if (!box) return std::nullopt;
    if (const auto handle = handle_at(state, *box, position_px)) return handle;
    if (const auto side = side_at(state, *box, position_px)) return side;
    if (frame_of(state, box->box).contains(position_px)) return TransformGrip{};
    return std::nullopt;
}

Hover hit_for_transform(const EditorState& state, glm::dvec2 position_px) {
    const auto grip = grip_at(state, position_px);
    if (grip && grip->kind != GripKind::inside) return HoveredGrip{*grip};
    Hover hit = hit_canvas(state, position_px);
    return grip && !is_selected_by_press(state, hit) ? Hover(HoveredGrip{*grip}) : hit;
}

bool is_selected_by_press(const EditorState& state, const Hover& hit) {
    if (std::holds_alternative<HoveredPoint>(hit)) return true;
    const auto* other = std::get_if<HoveredOtherCurve>(&hit);
    return other != nullptr && part_of(selected_box(state)->parts, other->index) == nullptr;
}

}  // namespace batten::editor
