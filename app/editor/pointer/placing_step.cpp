#include "app/editor/pointer/placing_step.h"

#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/typed_place.h"

namespace batten::editor {
namespace {

/// Steps with `event` in place of that of `gesture`, and asks for what is to be shown of the place.
class PlacedStep {
  public:
    PlacedStep(const Gesture& gesture, const StepMode& step) : gesture_(gesture), step_(step) {}

    CanvasMode operator()(const CanvasMode& mode, const PointerEvent& event, const TypedPlace* typed = nullptr) {
        return step_(mode, Gesture{event, gesture_.state, gesture_.queue, typed, &place_});
    }

    /// After the last step, which led to `mode`.
    void show(const CanvasMode& mode, bool is_over) const {
        const Placing& shown = gesture_.state.placing;
        const bool is_done = is_at_rest(mode);
        if (!is_done && !place_) return;  // a release between two places
        const std::optional<ShownPlace> place = is_over && is_done ? std::nullopt : place_;
        if (place != shown.place || (!place && !shown.typed.is_empty())) gesture_.queue.change(ShowPlace{place});
        if (is_over && place && !shown.typed.is_empty()) gesture_.queue.change(TypePlace{});
    }

  private:
    const Gesture& gesture_;
    const StepMode& step_;
    std::optional<ShownPlace> place_;
};

PointerEvent event_as(const Gesture& gesture, PointerAction action) {
    PointerEvent event = gesture.event;
    event.action = action;
    if (action != PointerAction::move) event.button = PointerButton::left;
    return event;
}

CanvasMode step_typed(const CanvasMode& mode, const Gesture& gesture, const StepMode& step, const TypedPlace& typed) {
    gesture.queue.change(TypePlace{typed});
    PlacedStep placed(gesture, step);
    CanvasMode next = placed(mode, event_as(gesture, PointerAction::move), &typed);
    placed.show(next, false);
    return next;
}

CanvasMode accept_typed(const CanvasMode& mode, const Gesture& gesture, const StepMode& step) {
    const Placing& placing = gesture.state.placing;
    const std::string problem = typed_problem(placing, world_at_pointer(gesture), gesture.state.shown().units);
    if (!problem.empty()) {
        gesture.queue.change(ShowRefusal{problem});
        return mode;
    }
    PlacedStep placed(gesture, step);
    const CanvasMode pressed = placed(mode, event_as(gesture, PointerAction::press));
    CanvasMode next = placed(pressed, event_as(gesture, PointerAction::release));
    placed.show(next, true);
    return next;
}

/// Whether points follow a brush.
bool is_soft_move(const CanvasMode& mode) {
    const auto* brush = std::get_if<Brushing>(&mode);
    return brush != nullptr && brush->press_px && !brush->painted;
}

/// Whether a radius or a distance is dragged out.
bool is_joint_drag(const CanvasMode& mode) {
    const auto* picking = std::get_if<PickingJoint>(&mode);
    return picking != nullptr && picking->drag;
}

/// Whether a button holds something whose place may be typed.
bool is_place_dragged(const CanvasMode& mode) {
    return std::holds_alternative<DraggingPoints>(mode) || std::holds_alternative<DraggingCurvePoint>(mode) ||
           std::holds_alternative<DraggingFitPoint>(mode) || std::holds_alternative<DraggingFitHandle>(mode) ||
           std::holds_alternative<DraggingHandle>(mode) || std::holds_alternative<DraggingGuide>(mode) ||
           std::holds_alternative<DraggingTransform>(mode) || std::holds_alternative<DraggingHandlebar>(mode) ||
           std::holds_alternative<DraggingSelection>(mode) || is_soft_move(mode) || is_joint_drag(mode);
}

FirstLetters first_letters(const CanvasMode& mode) {
    return is_place_dragged(mode) ? FirstLetters::begin_numbers : FirstLetters::are_shortcuts;
}

std::optional<TypedPlace> typed_by(const PointerEvent& event, const TypedPlace& typed, FirstLetters letters) {
    return event.character != 0 ? typed_character(typed, event.character, letters) : typed_key(typed, event.key);
}

bool prints(Key key) {
    return (key >= Key::a && key <= Key::digit_9) || (key >= Key::space && key <= Key::right_bracket);
}

/// Keys whose character may begin a number, and that have shortcuts.
bool begins_a_number(Key key) {
    return (key >= Key::digit_0 && key <= Key::digit_9) || key == Key::x || key == Key::y || key == Key::plus ||
           key == Key::minus || key == Key::period;
}

bool ends_a_place(PointerAction action) {
    return action == PointerAction::press || action == PointerAction::double_click ||
           action == PointerAction::release || action == PointerAction::escape || action == PointerAction::leave;
}

}  // namespace

CanvasMode step_placing(const CanvasMode& mode, const Gesture& gesture, const StepMode& step) {
    const PointerEvent& event = gesture.event;
    const TypedPlace& typed = gesture.state.placing.typed;
    if (event.action == PointerAction::escape && !typed.is_empty())
        return step_typed(mode, gesture, step, TypedPlace{});
    if (event.action == PointerAction::key && takes_numbers(mode, gesture.state)) {
        if (const auto next = typed_by(event, typed, first_letters(mode)))
            return step_typed(mode, gesture, step, *next);
        if (event.key == Key::enter && !typed.is_empty()) return accept_typed(mode, gesture, step);
    }
    PlacedStep placed(gesture, step);
    CanvasMode next = placed(mode, event);
    const bool is_about_no_place = event.action == PointerAction::wheel || event.action == PointerAction::key ||
                                   (event.action == PointerAction::leave && !std::holds_alternative<CanvasIdle>(next));
    if (!is_about_no_place) placed.show(next, ends_a_place(event.action));
    return next;
}

bool places_points(Tool tool) {
    return tool == Tool::add_point || tool == Tool::draw_curve || tool == Tool::shape;
}

bool takes_numbers(const CanvasMode& mode, const EditorState& state) {
    const bool waits_for_place =
        std::holds_alternative<CanvasIdle>(mode) && (places_points(state.tool) || state.axis_pick.has_value());
    return is_place_dragged(mode) || waits_for_place || state.placing.place.has_value();
}

bool takes_key(const CanvasMode& mode, const EditorState& state, const PointerEvent& event) {
    if (std::holds_alternative<PickingJoint>(mode) && continuity_of_key(event)) return true;
    if (std::holds_alternative<Brushing>(mode) && brush_notches_of_key(event)) return true;
    const Modifiers& modifiers = event.modifiers;
    if (!takes_numbers(mode, state) || modifiers.ctrl || modifiers.alt) return false;
    const TypedPlace& typed = state.placing.typed;
    const bool may_begin = !std::holds_alternative<CanvasIdle>(mode);
    if (event.character != 0) {
        const bool is_sign = event.character == U'+' || event.character == U'-' || event.character == U'.' ||
                             event.character == U'x' || event.character == U'y';
        return typed_character(typed, event.character, first_letters(mode)) &&
               (may_begin || !typed.is_empty() || !is_sign);
    }
    if (typed.is_empty()) return may_begin && begins_a_number(event.key);
    return event.key == Key::enter || event.key == Key::tab || event.key == Key::backspace || prints(event.key);
}

}  // namespace batten::editor
