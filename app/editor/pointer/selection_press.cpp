#include "app/editor/pointer/selection_press.h"

#include <algorithm>

#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/point_drag.h"
#include "core/evaluate/evaluate.h"
#include "render/pixel_box.h"

namespace batten::editor {
namespace {

using Indices = std::vector<std::size_t>;

// As plain points where they are of the active curve alone.
void select(const Gesture& gesture, const SelectedParts& parts) {
    if (parts == selected_parts(gesture.state)) return;
    const std::size_t active = gesture.state.history.present().active;
    const bool are_active = parts.size() == 1 && parts.front().curve == active && !parts.front().is_whole();
    if (parts.empty())
        gesture.queue.run(SelectNone{});
    else if (are_active)
        gesture.queue.run(SelectPoints{.points = parts.front().points});
    else
        gesture.queue.run(SelectParts{.parts = text_of_parts(parts)});
}

bool is_selected(const SelectedParts& parts, const SelectedPart& part) {
    const SelectedPart* own = part_of(parts, part.curve);
    if (own == nullptr || own->is_whole()) return own != nullptr;
    return !part.is_whole() && std::ranges::includes(own->points, part.points);
}

CanvasMode begin_selection_drag(const Gesture& gesture, SelectedPart grabbed, core::Point start, bool was_selected) {
    return DraggingSelection{start, std::move(grabbed), gesture.event.position_px, was_selected};
}

/// A point of any curve; none where the press is about the active curve alone.
std::optional<CanvasMode> press_point(const Gesture& gesture, const SelectedPart& point) {
    const core::Document& document = gesture.state.history.present();
    const SelectedParts parts = selected_parts(gesture.state);
    const bool was_selected = is_selected(parts, point);
    const bool is_active = point.curve == document.active;
    if (is_active && (!gesture.state.selection.is_over_curves() || !(was_selected || gesture.event.modifiers.shift)))
        return std::nullopt;
    const core::Point start = document.curves[point.curve].curve->control_points()[point.points.front()];
    if (was_selected) return begin_selection_drag(gesture, point, start, true);
    if (gesture.event.modifiers.shift) {
        select(gesture, with_part(parts, point));
        return begin_selection_drag(gesture, point, start, false);
    }
    gesture.queue.run(ActivateCurve{.index = point.curve});
    gesture.queue.run(SelectPoints{.points = point.points});
    return DraggingPoints{point.points.front(), point.points, gesture.event.position_px, false};
}

/// A curve as a whole.
std::optional<CanvasMode> press_curve(const Gesture& gesture, std::size_t curve, core::Point place) {
    if (gesture.event.modifiers.shift) return begin_box(gesture, curve);
    const SelectedParts parts = selected_parts(gesture.state);
    const SelectedPart* own = part_of(parts, curve);
    if (own == nullptr || !own->is_whole()) return std::nullopt;
    return begin_selection_drag(gesture, {curve}, place, true);
}

struct PressOverCurves {
    const Gesture& gesture;

    std::optional<CanvasMode> operator()(const HoveredPoint& hit) const {
        if (gesture.event.modifiers.alt) return std::nullopt;
        return press_point(gesture, {gesture.state.history.present().active, {hit.index}});
    }
    std::optional<CanvasMode> operator()(const HoveredOtherPoint& hit) const {
        return press_point(gesture, {hit.curve, {hit.index}});
    }
    std::optional<CanvasMode> operator()(const HoveredCurve& hit) const {
        const core::Document& document = gesture.state.history.present();
        return press_curve(gesture, document.active, core::point_at(*document.active_curve()->curve, hit.u));
    }
    std::optional<CanvasMode> operator()(const HoveredOtherCurve& hit) const {
        return press_curve(gesture, hit.index, world_at_pointer(gesture));
    }
    template <class Other>
    std::optional<CanvasMode> operator()(const Other&) const {
        return std::nullopt;
    }
};

SelectedParts with_wholes(SelectedParts parts, const Indices& curves) {
    for (const std::size_t i : curves) parts = with_part(std::move(parts), {i});
    return parts;
}

SelectedParts without_wholes(SelectedParts parts, const Indices& curves) {
    for (const std::size_t i : curves) parts = without_part(std::move(parts), {i});
    return parts;
}

/// Takes the curve and its group in or out. Where nothing was selected, the active curve is what a click chose before.
void toggle_curve(const Gesture& gesture, std::size_t curve) {
    const core::Document& document = gesture.state.history.present();
    const auto group_of = [&](std::size_t i) { return selectable(document, with_groups(document, {i})); };
    SelectedParts parts = selected_parts(gesture.state);
    const SelectedPart* own = part_of(parts, curve);
    if (curve >= document.curves.size()) return;  // it went while the button was held
    if (!can_be_selected(document.curves[curve])) {
        // Refused with the reason.
        gesture.queue.run(SelectParts{.parts = text_of_parts({{curve}})});
        return;
    }
    if (own != nullptr && own->is_whole()) return select(gesture, without_wholes(parts, group_of(curve)));
    if (parts.empty() && document.active < document.curves.size())
        parts = with_wholes(parts, group_of(document.active));
    select(gesture, with_wholes(std::move(parts), group_of(curve)));
}

class Box {
  public:
    Box(const BoxSelecting& mode, const Gesture& gesture)
        : camera_(gesture.state.view.camera),
          box_(render::PixelBox::between(mode.press_px, gesture.event.position_px)),
          shows_points_(gesture.state.view.overlays.is_shown(Overlay::polygon)) {}

    Indices points_of(const core::DocumentCurve& entry) const {
        Indices points;
        const std::span<const core::Point> all = entry.curve->control_points();
        for (std::size_t i = 0; i < all.size(); ++i)
            if (box_.contains(render::screen_from_world(camera_, all[i]))) points.push_back(i);
        return points;
    }

    /// All of the curve where it lies inside with all its points; else those inside, where points are shown.
    std::optional<SelectedPart> part_of_curve(const core::Document& document, std::size_t curve) const {
        const core::DocumentCurve& entry = document.curves[curve];
        if (!can_be_selected(entry)) return std::nullopt;
        Indices points = points_of(entry);
        if (points.size() == entry.curve->control_points().size()) return SelectedPart{curve};
        if (points.empty() || entry.fit != nullptr || !shows_points_) return std::nullopt;
        return SelectedPart{curve, std::move(points)};
    }

    /// Of the active curve, of which a box selects points alone.
    Indices points_of_active(const core::Document& document) const {
        const core::DocumentCurve* active = document.active_curve();
        if (active == nullptr || !active->visible || !shows_points_ || active->fit != nullptr) return {};
        return points_of(*active);
    }

  private:
    const render::Camera& camera_;
    render::PixelBox box_;
    bool shows_points_;
};

SelectedParts parts_in_box(const BoxSelecting& mode, const Gesture& gesture) {
    const core::Document& document = gesture.state.history.present();
    const Box box(mode, gesture);
    SelectedParts parts = mode.before;
    if (mode.takes_all_curves) {
        for (std::size_t i = 0; i < document.curves.size(); ++i)
            if (const auto part = box.part_of_curve(document, i)) parts = with_part(std::move(parts), *part);
    } else if (Indices points = box.points_of_active(document); !points.empty()) {
        parts = with_part(std::move(parts), {document.active, std::move(points)});
    }
    return parts;
}

void ask_to_move(const DraggingSelection& mode, const Gesture& gesture, Phase phase) {
    const auto selected = selected_box(gesture.state);
    const core::Point target = dragged_position(gesture, mode.start, mode.press_px, {.parts = selected->parts});
    if (target == mode.start)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, Move{.offset = exact_offset(mode.start, target), .what = MapTarget::selection});
}

/// A click on one thing of several selects it alone, or with Shift takes it out.
void click(const DraggingSelection& mode, const Gesture& gesture) {
    if (!mode.was_selected) return;
    const SelectedPart& part = mode.grabbed;
    if (gesture.event.modifiers.shift) return select(gesture, without_part(selected_parts(gesture.state), part));
    const bool is_active = part.curve == gesture.state.history.present().active;
    if (!is_active) gesture.queue.run(ActivateCurve{.index = part.curve});
    if (part.is_whole()) {
        if (is_active) gesture.queue.run(SelectNone{});
    } else {
        gesture.queue.run(SelectPoints{.points = part.points});
    }
}

}  // namespace

std::optional<CanvasMode> press_over_curves(const Gesture& gesture, const Hover& hit) {
    return std::visit(PressOverCurves{gesture}, hit);
}

CanvasMode begin_box(const Gesture& gesture, std::optional<std::size_t> curve) {
    BoxSelecting box{gesture.event.position_px, gesture.event.position_px, {}, curve, gesture.event.modifiers.ctrl};
    if (gesture.event.modifiers.shift) box.before = selected_parts(gesture.state);
    return box;
}

void finish_box(const BoxSelecting& mode, const Gesture& gesture) {
    if (is_drag(gesture.state, mode.press_px, gesture.event.position_px)) {
        const SelectedParts parts = parts_in_box(mode, gesture);
        if (parts.empty() && gesture.state.selection.points.empty() && !gesture.state.selection.is_over_curves())
            return;
        select(gesture, parts);
    } else if (mode.curve && gesture.event.modifiers.shift) {
        toggle_curve(gesture, *mode.curve);
    } else if (!gesture.event.modifiers.shift && gesture.state.selection != Selection{}) {
        gesture.queue.run(SelectNone{});
    }
}

CanvasMode step(const DraggingSelection& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move, click);
}

}  // namespace batten::editor
