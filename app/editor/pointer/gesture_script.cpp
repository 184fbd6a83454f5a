#include "app/editor/pointer/gesture_script.h"

#include <cmath>
#include <numbers>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/pointer/plot_layout.h"
#include "render/camera.h"

namespace batten::editor {

namespace {

constexpr std::size_t frames_around = 48;    // the circle of a drag
constexpr std::size_t notches_one_way = 12;  // then the wheel turns back
constexpr double drag_radius_px = 24.0;
constexpr double wide_radius_px = 120.0;

glm::dvec2 point_start(const EditorState& state, const PicturePlaces& places) {
    const auto points = state.active_curve()->control_points();
    return places.canvas_origin_px + render::screen_from_world(state.view.camera, points[points.size() / 2]);
}

// The strip shows at least one knot, that of the middle of all that it shows.
glm::dvec2 knot_start(const EditorState& state, const PicturePlaces& places) {
    const std::vector<KnotMark> marks = knot_marks(state, plot_layout(state, places.plot_size_px));
    return places.plot_origin_px + marks[marks.size() / 2].center_px;
}

PointerEvent event_at(glm::dvec2 position_px, PointerAction action) {
    PointerEvent event;
    event.action = action;
    event.position_px = position_px;
    return event;
}

PointerEvent button_event(ScriptedGesture gesture, glm::dvec2 position_px, PointerAction action) {
    PointerEvent event = event_at(position_px, action);
    event.button = gesture == ScriptedGesture::pan ? PointerButton::middle : PointerButton::left;
    return event;
}

bool holds_button(ScriptedGesture gesture) {
    return gesture == ScriptedGesture::drag || gesture == ScriptedGesture::drag_knot || gesture == ScriptedGesture::pan;
}

// By whole pixels from the center, as a pointer moves.
glm::dvec2 on_circle(glm::dvec2 center_px, double radius_px, std::size_t step) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(step) / static_cast<double>(frames_around);
    return center_px + glm::round(radius_px * glm::dvec2(std::cos(angle), std::sin(angle)));
}

ScriptedFrame turned_wheel(glm::dvec2 position_px, std::size_t step) {
    PointerEvent event = event_at(position_px, PointerAction::wheel);
    event.wheel = (step / notches_one_way) % 2 == 0 ? 1.0 : -1.0;
    return {{event}, {}};
}

// A third of the way along the domain, where a knot can hardly be already.
Command inserted_knot(const core::Curve& curve) {
    const core::Interval domain = curve.domain();
    return InsertKnot{.u = domain.lower + domain.length() / 3.0};
}

// Frame `step` after the gesture began.
ScriptedFrame next_frame(ScriptedGesture gesture, std::size_t step, glm::dvec2 start_px, const EditorState& state) {
    switch (gesture) {
        case ScriptedGesture::drag:
        case ScriptedGesture::drag_knot:
            return {{event_at(on_circle(start_px, drag_radius_px, step), PointerAction::move)}, {}};
        case ScriptedGesture::hover:
        case ScriptedGesture::pan:
            return {{event_at(on_circle(start_px, wide_radius_px, step), PointerAction::move)}, {}};
        case ScriptedGesture::zoom:
            return turned_wheel(start_px, step);
        case ScriptedGesture::insert_knot:
            if (state.active_curve() == nullptr) return {};
            if (step % 2 == 1) return {{}, {Undo{}}};
            return {{}, {inserted_knot(*state.active_curve())}};
        case ScriptedGesture::play:
            return {};
    }
    return {};
}

}  // namespace

glm::dvec2 start_of(ScriptedGesture gesture, const EditorState& state, const PicturePlaces& places) {
    if (state.active_curve() != nullptr) {
        if (gesture == ScriptedGesture::drag) return point_start(state, places);
        if (gesture == ScriptedGesture::drag_knot) return knot_start(state, places);
    }
    return places.canvas_origin_px + 0.5 * state.view.camera.size_px;
}

ScriptedFrame scripted_frame(ScriptedGesture gesture, std::size_t frame, glm::dvec2 start_px,
                             const EditorState& state) {
    if (frame == 0) return {{event_at(start_px, PointerAction::move)}, {}};
    if (frame > 1) return next_frame(gesture, frame - 2, start_px, state);
    if (holds_button(gesture)) return {{button_event(gesture, start_px, PointerAction::press)}, {}};
    if (gesture == ScriptedGesture::play && state.active_curve() != nullptr) return {{}, {TogglePlay{}}};
    return {};
}

ScriptedFrame last_frame(ScriptedGesture gesture, glm::dvec2 start_px) {
    if (!holds_button(gesture)) return {};
    return {{button_event(gesture, start_px, PointerAction::release)}, {}};
}

bool is_under_way(ScriptedGesture gesture, const EditorState& state) {
    switch (gesture) {
        case ScriptedGesture::drag:
        case ScriptedGesture::drag_knot:
            return state.preview.has_value();
        case ScriptedGesture::insert_knot:
            return state.history.can_undo() || state.history.can_redo();
        case ScriptedGesture::play:
            return state.view.playback.is_playing;
        case ScriptedGesture::hover:
        case ScriptedGesture::pan:
        case ScriptedGesture::zoom:
            return true;
    }
    return true;
}

}  // namespace batten::editor
