#include "app/editor/pointer/brush.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/brush_commands.h"
#include "app/editor/commands/fairing_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/pointer/point_drag.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {
namespace {

constexpr double target_reach = 9.0;     // design pixels, within which a control point or the curve is meant
constexpr std::size_t most_held = 4000;  // control points that are marked
constexpr double steps_per_reach = 8.0;
constexpr int most_steps = 500;          // to each side
constexpr int most_places_between = 32;  // of a stroke, between two events
constexpr double least_steps_in_domain = 64.0;
constexpr double size_step = 1.15;  // of the radius, for a notch of the wheel or a key

const core::NearParts& near_parts(const EditorState& state) {
    return *state.derived.near_parts(state.history.present().active_curve()->curve);
}

// The control point under the pointer, else the place of the curve there, else the pointer itself.
core::Point gripped_place(const Gesture& gesture) {
    const core::Point pointer = world_at_pointer(gesture);
    if (committed_curve(gesture.state) == nullptr) return pointer;
    const core::NearParts& parts = near_parts(gesture.state);
    const auto points = parts.curve().control_points();
    const double reach = pixels(gesture.state, target_reach) / gesture.state.view.camera.scale;
    Nearest<core::Point> nearest(reach);
    parts.visit_near(pointer, reach, [&](std::size_t i) {
        const core::Point point = points[i % points.size()];
        nearest.offer(point, core::distance(point, pointer));
    });
    if (nearest.found()) return *nearest.found();
    const auto sample = parts.nearest(pointer, reach);
    return sample ? sample->point : pointer;
}

// The nearest place of the curve that is under a brush at `center`, and what is around it.
std::optional<core::Interval> part_under(const Gesture& gesture, core::Point center) {
    const double reach = brush_reach(gesture.state);
    const core::NearParts& parts = near_parts(gesture.state);
    const auto sample = parts.nearest(center, reach);
    return sample ? part_within(parts.curve(), sample->u, center, reach) : std::nullopt;
}

// From where the pointer was to where it is; between far places there are others, so that the stroke has no gaps.
void paint(Brushing& mode, const Gesture& gesture) {
    const glm::dvec2 from = mode.position_px;
    const glm::dvec2 to = gesture.event.position_px;
    const double steps = std::ceil(glm::distance(from, to) / brush_radius_px(gesture.state));
    const int count = static_cast<int>(std::clamp(steps, 1.0, static_cast<double>(most_places_between)));
    const core::Curve& curve = *committed_curve(gesture.state);
    for (int k = 1; k <= count; ++k) {
        const glm::dvec2 place = glm::mix(from, to, static_cast<double>(k) / count);
        const auto part = part_under(gesture, core::Point(render::world_from_screen(gesture.state.view.camera, place)));
        if (part) mode.painted = mode.painted ? painted_over(curve, *mode.painted, *part) : *part;
    }
}

void ask_to_move_softly(const Brushing& mode, const Gesture& gesture, double reach, Phase phase) {
    const core::Point target = dragged_position(gesture, mode.center, *mode.press_px, {.is_curve = true});
    if (target == mode.center) return gesture.queue.cancel_preview();
    const core::Vector offset = exact_offset(mode.center, target);
    request(gesture, phase, SoftMove{.center = mode.center, .offset = offset, .radius = reach});
}

// What it would take hold of.
Brushing hovering(const Gesture& gesture) {
    Brushing mode{.position_px = gesture.event.position_px, .tool_changes = gesture.state.tool_changes};
    if (gesture.state.view.brush.kind == BrushKind::fair || !can_edit_curve(gesture.state)) return mode;
    mode.center = gripped_place(gesture);
    mode.held = held_points(gesture.state, mode.center);
    return mode;
}

Brushing pressed(const Gesture& gesture) {
    Brushing mode = hovering(gesture);
    if (!may_edit_curve(gesture)) return mode;
    mode.press_px = mode.position_px;
    if (gesture.state.view.brush.kind == BrushKind::fair) paint(mode, gesture);
    return mode;
}

Brushing dragged(Brushing mode, const Gesture& gesture) {
    mode.has_moved =
        mode.has_moved || is_typed(gesture) || is_drag(gesture.state, *mode.press_px, gesture.event.position_px);
    if (gesture.state.view.brush.kind == BrushKind::fair) {
        if (committed_curve(gesture.state) != nullptr) paint(mode, gesture);
    } else if (mode.has_moved) {
        ask_to_move_softly(mode, gesture, brush_reach(gesture.state), Phase::preview);
    }
    mode.position_px = gesture.event.position_px;
    return mode;
}

Brushing released(Brushing mode, const Gesture& gesture) {
    mode = dragged(std::move(mode), gesture);
    if (mode.painted)
        gesture.queue.run(FairPart{
            .from = mode.painted->lower, .to = mode.painted->upper, .distance = brush_distance(gesture.state)});
    else if (mode.has_moved && gesture.state.view.brush.kind == BrushKind::soft_move)
        ask_to_move_softly(mode, gesture, brush_reach(gesture.state), Phase::commit);
    return {.position_px = mode.position_px, .tool_changes = mode.tool_changes};
}

CanvasMode given_up(const Brushing& mode, const Gesture& gesture) {
    if (!mode.press_px) {
        gesture.queue.run(SetTool{.tool = Tool::select});
        return CanvasIdle{};
    }
    if (mode.has_moved && !mode.painted) gesture.queue.cancel_preview();
    return Brushing{.position_px = mode.position_px, .tool_changes = mode.tool_changes};
}

// The wheel and the keys make the brush larger, also while it moves points.
Brushing resized(Brushing mode, const Gesture& gesture, double notches) {
    const Brush& brush = gesture.state.view.brush;
    const double radius = brush_radii.clamp(brush.radius * std::pow(size_step, notches));
    gesture.queue.change(SetBrushRadius{radius});
    if (mode.has_moved && brush.kind == BrushKind::soft_move)
        ask_to_move_softly(mode, gesture, brush_reach(gesture.state) * radius / brush.radius, Phase::preview);
    return mode;
}

}  // namespace

double brush_radius_px(const EditorState& state) {
    return pixels(state, state.view.brush.radius);
}

double brush_reach(const EditorState& state) {
    return brush_radius_px(state) / state.view.camera.scale;
}

std::vector<HeldPoint> held_points(const EditorState& state, core::Point center) {
    std::vector<HeldPoint> held;
    const core::DocumentCurve* active = state.history.present().active_curve();
    const double reach = brush_reach(state);
    if (active == nullptr || near_parts(state).is_crowded(center, reach, most_held)) return held;
    const auto points = active->curve->control_points();
    near_parts(state).visit_near(center, reach, [&](std::size_t i) {
        if (i >= points.size() || std::ranges::binary_search(active->pinned, i)) return;
        const double share = core::soft_share(points[i], center, reach);
        if (share > 0.0) held.push_back({i, share});
    });
    return held;
}

std::optional<core::Interval> part_within(const core::Curve& curve, double u, core::Point center, double reach) {
    const core::Interval domain = curve.domain();
    const auto is_within = [&](double at) {
        const double in_domain = curve.is_periodic() ? curve.knots().into_domain(at) : at;
        return core::distance(core::point_at(curve, in_domain), center) <= reach;
    };
    if (!is_within(u)) return std::nullopt;
    const double longest = domain.length() / least_steps_in_domain;
    const auto end_of = [&](double sign) {
        const double limit = curve.is_periodic() ? u + sign * domain.length() / 2.0
                             : sign > 0.0        ? domain.upper
                                                 : domain.lower;
        double at = u;
        for (int k = 0; k < most_steps && at != limit; ++k) {
            const double in_domain = curve.is_periodic() ? curve.knots().into_domain(at) : at;
            const double speed = core::length(core::derivatives_at(curve, in_domain, 1)[1]);
            const double step = speed > 0.0 ? std::min(reach / (steps_per_reach * speed), longest) : longest;
            const double next = sign > 0.0 ? std::min(at + step, limit) : std::max(at - step, limit);
            if (next == at || !is_within(next)) return at;
            at = next;
        }
        return at;
    };
    return core::Interval{end_of(-1.0), end_of(1.0)};
}

core::Interval painted_over(const core::Curve& curve, core::Interval painted, core::Interval added) {
    const double period = curve.domain().length();
    const auto touches = [&](const core::Interval& part) {
        return part.lower <= painted.upper && painted.lower <= part.upper;
    };
    for (const double shift : {0.0, -period, period}) {
        if (shift != 0.0 && !curve.is_periodic()) break;
        const core::Interval part{added.lower + shift, added.upper + shift};
        if (!touches(part)) continue;
        painted = {std::min(painted.lower, part.lower), std::max(painted.upper, part.upper)};
        break;
    }
    if (!curve.is_periodic()) return painted;
    // It begins within the domain, and is no more than a period.
    const double start = curve.knots().into_domain(painted.lower);
    return {start, start + std::min(painted.length(), period)};
}

std::string brush_hint(const EditorState& state, const Brushing& mode) {
    const bool fairs = state.view.brush.kind == BrushKind::fair;
    if (mode.press_px)
        return fairs ? "Paint over the part to fair · release to fair it · Escape gives up"
                     : "Points follow, the less the farther they are · wheel, [ and ] resize · Escape restores";
    return fairs
               ? "Paint over the part to fair (changes the shape) · wheel, [ and ] resize, Ctrl+wheel zooms · Escape "
                 "leaves the tool"
               : "Drag to move the points within softly (changes the shape) · wheel, [ and ] resize, Ctrl+wheel zooms "
                 "· Escape leaves the tool";
}

CanvasMode begin_brush(const Gesture& gesture) {
    return is_press(gesture) ? pressed(gesture) : hovering(gesture);
}

std::optional<double> brush_notches_of_key(const PointerEvent& event) {
    if (event.modifiers.ctrl || event.modifiers.alt) return std::nullopt;
    if (event.character == U'[' || event.key == Key::left_bracket) return -1.0;
    if (event.character == U']' || event.key == Key::right_bracket) return 1.0;
    return std::nullopt;
}

CanvasMode step(const Brushing& mode, const Gesture& gesture) {
    // A ruler or an inset under the pointer, or an axis that is clicked, is no matter of the brush.
    const bool is_move_or_press = is_move(gesture) || is_press(gesture);
    if (is_move_or_press && !mode.press_px && !is_about_tool(gesture)) return step_mode(CanvasIdle{}, gesture);
    switch (gesture.event.action) {
        case PointerAction::move:
            return mode.press_px ? dragged(mode, gesture) : hovering(gesture);
        case PointerAction::press:
        case PointerAction::double_click:
            if (mode.press_px) return mode;
            if (is_pan(gesture.event)) return Panning{gesture.event.position_px};
            return gesture.event.button == PointerButton::left ? pressed(gesture) : mode;
        case PointerAction::release:
            return is_release(gesture) && mode.press_px ? released(mode, gesture) : mode;
        case PointerAction::escape:
            return given_up(mode, gesture);
        case PointerAction::wheel:
            if (!gesture.event.modifiers.ctrl && !wheel_pan(gesture.state, gesture.event))
                return resized(mode, gesture, gesture.event.wheel);
            turn_canvas_wheel(gesture);
            return mode;
        case PointerAction::key:
            if (const auto notches = brush_notches_of_key(gesture.event)) return resized(mode, gesture, *notches);
            return mode;
        case PointerAction::leave:
            return mode.press_px ? CanvasMode(mode) : CanvasMode(CanvasIdle{});
        case PointerAction::take_back:
        case PointerAction::finish:
            break;
    }
    return mode;
}

}  // namespace batten::editor
