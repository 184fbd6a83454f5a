#include "app/editor/pointer/point_drag.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "app/editor/pointer/grid_step.h"

namespace batten::editor {
namespace {

constexpr double pixels_per_half_decade = 100.0;

double grid_step(const EditorState& state) {
    return minor_grid_step(state.view.camera.scale / state.view.interface_scale);
}

double exact_offset(double start, double target) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double offset = target - start;
    for (const double candidate : {offset, std::nextafter(offset, -infinity), std::nextafter(offset, infinity)})
        if (start + candidate == target) return candidate;
    return offset;
}

}  // namespace

core::Point pointed_at(const Gesture& gesture) {
    const core::Point world = world_at_pointer(gesture);
    if (!gesture.event.modifiers.ctrl) return world;
    const double step = grid_step(gesture.state);
    return {rounded_to_step(world.x, step), rounded_to_step(world.y, step)};
}

core::Point dragged_position(const Gesture& gesture, core::Point start, glm::dvec2 press_px) {
    const glm::dvec2 moved_px = gesture.event.position_px - press_px;
    const Modifiers modifiers = gesture.event.modifiers;
    const bool is_horizontal = std::abs(moved_px.x) >= std::abs(moved_px.y);
    const bool x_changes = !modifiers.shift || is_horizontal;
    const bool y_changes = !modifiers.shift || !is_horizontal;
    const double step = grid_step(gesture.state);
    const auto placed = [&](double value) { return modifiers.ctrl ? rounded_to_step(value, step) : value; };

    const double scale = gesture.state.view.camera.scale;
    core::Point position = start;
    if (x_changes) position.x = placed(start.x + moved_px.x / scale);
    if (y_changes) position.y = placed(start.y - moved_px.y / scale);
    return position;
}

core::Vector exact_offset(core::Point start, core::Point target) {
    return {exact_offset(start.x, target.x), exact_offset(start.y, target.y)};
}

double with_two_digits(double weight) {
    const double units = std::pow(10.0, 1.0 - std::floor(std::log10(weight)));
    return std::round(weight * units) / units;
}

double dragged_weight(const Gesture& gesture, double start_weight, glm::dvec2 press_px) {
    const glm::dvec2 moved_px = gesture.event.position_px - press_px;
    const double half_decades = (moved_px.x - moved_px.y) / pixels(gesture.state, pixels_per_half_decade);
    // Through exp10 of a quotient, so that 200 pixels are exactly a factor of ten where the library's pow is.
    const double weight = dragged_weights.clamp(start_weight * std::pow(10.0, half_decades / 2.0));
    return gesture.event.modifiers.ctrl ? with_two_digits(weight) : weight;
}

}  // namespace batten::editor
