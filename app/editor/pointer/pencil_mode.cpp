#include "app/editor/pointer/pencil_mode.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/stroke_commands.h"
#include "app/editor/pointer/gesture.h"
#include "core/make/fit_stroke.h"
#include "core/measure/continuity.h"
#include "core/measure/meeting.h"

namespace batten::editor {

namespace {

// Samples that are fitted anew with each move, at most; then the line through the earlier half of them stays. So many
// before them are looked at, too, so that the line goes on smoothly.
constexpr std::size_t most_unsettled = 256;
constexpr std::size_t samples_before = 64;

bool is_on_curve(const Gesture& gesture) {
    if (!can_edit_curve(gesture.state)) return false;
    const glm::dvec2 nearest_px =
        render::screen_from_world(gesture.state.view.camera, nearest_to_pointer(gesture).point);
    return glm::distance(nearest_px, gesture.event.position_px) <= pixels(gesture.state, snap_reach);
}

// Whether the pointer is beyond an end of the active curve, within 45 degrees of where the curve would go on. A stroke
// that began at this end is another one that begins there.
bool is_beyond_end(const Gesture& gesture, core::Point start) {
    const auto& entry = *gesture.state.history.present().active_curve();
    const core::Curve& curve = *entry.curve;
    if (core::is_closed(curve)) return false;
    const auto parts = gesture.state.derived.near_parts(entry.curve);
    const core::CurveSample foot = parts->nearest(world_at_pointer(gesture)).value();
    const bool is_start = foot.u == curve.domain().lower;
    const bool is_end = foot.u == curve.domain().upper;
    if ((!is_start && !is_end) || parts->nearest(start)->u == foot.u) return false;
    const core::Passing beyond = core::passing_beyond(curve, is_start ? core::CurveEnd::start : core::CurveEnd::end);
    const core::Vector way = world_at_pointer(gesture) - foot.point;
    return beyond.direction && core::dot(*beyond.direction, way) >= std::sqrt(0.5) * core::length(way);
}

// The smooth line from the settled samples to sample `to`.
std::vector<core::Point> line_up_to(const PencilStroke& stroke, std::size_t to) {
    const std::size_t first = stroke.settled_samples - std::min(stroke.settled_samples, samples_before);
    return core::smooth_line(std::span(stroke.samples).subspan(first), stroke.pixel, stroke.settled_samples - first,
                             to - first);
}

void settle(PencilStroke& stroke) {
    const std::size_t unsettled = stroke.samples.size() - stroke.settled_samples;
    if (unsettled <= most_unsettled) return;
    const std::size_t to = stroke.settled_samples + unsettled / 2;
    const std::vector<core::Point> line = line_up_to(stroke, to);
    stroke.settled.insert(stroke.settled.end(), line.begin(), line.end());
    stroke.settled_samples = to;
}

}  // namespace

PencilStroke begin_stroke(const Gesture& gesture) {
    const EditorState& state = gesture.state;
    return {.samples = {world_at_pointer(gesture)},
            .pixel = pixels(state, 1.0) / state.view.camera.scale,
            .redraws = !gesture.event.modifiers.alt && is_on_curve(gesture),
            .tool_changes = state.tool_changes};
}

void draw_on(PencilStroke& stroke, const Gesture& gesture) {
    const core::Point place = world_at_pointer(gesture);
    if (place == stroke.samples.back()) return;
    stroke.samples.push_back(place);
    settle(stroke);
    stroke.line = line_up_to(stroke, stroke.samples.size() - 1);
}

void finish_stroke(const PencilStroke& stroke, const Gesture& gesture) {
    core::Box box;
    for (const core::Point& sample : stroke.samples) box.include(sample);
    constexpr double least_size = 3.0;  // design pixels, as of a drag
    if (std::max(box.size().x, box.size().y) < least_size * stroke.pixel) return;
    const int smoothness = gesture.state.view.smoothness;
    if (stroke.redraws && (is_on_curve(gesture) || is_beyond_end(gesture, stroke.samples.front())))
        gesture.queue.run(Redraw{.points = stroke.samples, .smoothness = smoothness, .pixel = stroke.pixel});
    else
        gesture.queue.run(FitStroke{.points = stroke.samples, .smoothness = smoothness, .pixel = stroke.pixel});
}

}  // namespace batten::editor
