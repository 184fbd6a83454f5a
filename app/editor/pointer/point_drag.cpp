#include "app/editor/pointer/point_drag.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "app/editor/pointer/grid_step.h"
#include "app/editor/pointer/typed_place.h"

namespace batten::editor {
namespace {

constexpr double pixels_per_half_decade = 100.0;

/// Where a gesture may go: along one axis from where it began, or everywhere.
struct Freedom {
    bool x = true;
    bool y = true;

    core::Point kept(core::Point start, core::Point target) const {
        return {x ? target.x : start.x, y ? target.y : start.y};
    }
};

/// With Shift only along the axis on which it is farther away.
Freedom freedom_of(const Gesture& gesture, glm::dvec2 moved) {
    if (!gesture.event.modifiers.shift) return {};
    const bool is_horizontal = std::abs(moved.x) >= std::abs(moved.y);
    return {is_horizontal, !is_horizontal};
}

std::optional<Snap> snap_for(const Gesture& gesture, const SnapQuery& query) {
    if (gesture.event.modifiers.ctrl) {
        const core::Point corner = grid_corner(gesture.state, query.place);
        return Snap{corner, SnapKind::grid, "grid", "Snaps to the grid", {}};
    }
    return gesture.event.modifiers.alt ? std::nullopt : snap_at(gesture.state, query);
}

/// The place for the pointer at `query.place`.
core::Point placed(const Gesture& gesture, const SnapQuery& query, Freedom freedom) {
    std::optional<Snap> snap = snap_for(gesture, query);
    const core::Point start = query.from.value_or(query.place);
    core::Point position = freedom.kept(start, snap ? snap->position : query.place);
    const TypedPlace& typed = typed_for(gesture);
    if (!typed.is_empty()) {
        const core::Point free = position;
        position = place_typed(typed, query.from, free, gesture.state.shown().units).value_or(free);
        if (position != free) snap.reset();
    }
    if (gesture.place != nullptr) *gesture.place = ShownPlace{position, query.from, std::move(snap)};
    return position;
}

double rounded_to_digits(double value, int digits) {
    std::array<char, 32> text{};
    const auto* const end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1).ptr;
    double rounded = value;
    std::from_chars(text.data(), end, rounded);
    return rounded;
}

/// That with the fewest digits, which is what was typed: what else is dragged moves by it, too.
double exact_step(double start, double target) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double offset = target - start;
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits)
        if (const double candidate = rounded_to_digits(offset, digits); start + candidate == target) return candidate;
    for (const double candidate : {std::nextafter(offset, -infinity), std::nextafter(offset, infinity)})
        if (start + candidate == target) return candidate;
    return offset;
}

}  // namespace

core::Point pointed_at(const Gesture& gesture, std::optional<core::Point> from) {
    const core::Point world = world_at_pointer(gesture);
    const Freedom freedom = from ? freedom_of(gesture, glm::dvec2(world - *from)) : Freedom{};
    return placed(gesture, {.place = freedom.kept(from.value_or(world), world), .from = from}, freedom);
}

core::Point dragged_position(const Gesture& gesture, core::Point start, glm::dvec2 press_px, const Dragged& dragged) {
    const glm::dvec2 moved_px = gesture.event.position_px - press_px;
    const double scale = gesture.state.view.camera.scale;
    const core::Point from = dragged.from.value_or(start);
    const core::Point pointed{start.x + moved_px.x / scale, start.y - moved_px.y / scale};
    const Freedom freedom = freedom_of(gesture, dragged.from ? glm::dvec2(pointed - from) : moved_px);
    return placed(gesture, {.place = freedom.kept(from, pointed), .from = from, .dragged = dragged}, freedom);
}

core::Point dragged_tip(const Gesture& gesture, core::Point from, core::Point start, glm::dvec2 press_px,
                        const Dragged& dragged) {
    const glm::dvec2 moved_px = gesture.event.position_px - press_px;
    if (moved_px == glm::dvec2(0.0) && typed_for(gesture).is_empty()) return start;
    const double scale = gesture.state.view.camera.scale;
    const core::Point free(start.x + moved_px.x / scale, start.y - moved_px.y / scale);
    const Freedom freedom = freedom_of(gesture, glm::dvec2(free - from));
    return placed(gesture, {.place = freedom.kept(from, free), .from = from, .dragged = dragged}, freedom);
}

core::Vector exact_offset(core::Point start, core::Point target) {
    return {exact_step(start.x, target.x), exact_step(start.y, target.y)};
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
