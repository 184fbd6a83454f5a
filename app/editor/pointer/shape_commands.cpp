#include "app/editor/pointer/shape_commands.h"

#include <cassert>
#include <cmath>

#include "app/editor/commands/making_commands.h"
#include "app/editor/pointer/direction.h"

namespace batten::editor {
namespace {

constexpr double whole_turn = 360.0;

/// From one direction to another, in [0, 360).
double turn_between(core::Vector from, core::Vector to) {
    const double turn = std::fmod(degrees_of(to) - degrees_of(from), whole_turn);
    return turn < 0.0 ? turn + whole_turn : turn;
}

/// The distance, or what was typed for it.
double radius_of(core::Point center, core::Point place, const ShapeHints& hints) {
    constexpr double rounding = 1e-12;
    const double distance = core::robust_length(place - center);
    const double typed = std::abs(hints.length.value_or(distance));
    return std::abs(typed - distance) <= rounding * distance ? typed : distance;
}

Outcome<core::Point> center_through(const std::vector<core::Point>& p) {
    constexpr double least_sine = 1e-12;
    const core::Vector a = p[1] - p[0];
    const core::Vector b = p[2] - p[0];
    const double area = core::cross(a, b);
    if (!(std::abs(area) > least_sine * core::robust_length(a) * core::robust_length(b)))
        return tl::make_unexpected("the three places lie on one line, so no circle passes through them");
    const core::Vector c = (core::dot(a, a) * core::turned_left(b) - core::dot(b, b) * core::turned_left(a));
    return p[0] - (0.5 / area) * c;
}

Outcome<Command> circle_through(const std::vector<core::Point>& places) {
    const auto center = center_through(places);
    if (!center) return tl::make_unexpected(center.error());
    return AddCircle{
        .center = *center, .radius = core::robust_length(places[0] - *center), .polygon = core::CirclePolygon::square};
}

Outcome<Command> arc_around(const std::vector<core::Point>& places, double turned, double radius) {
    const core::Vector start = places[1] - places[0];
    const double turn = turn_between(start, places[2] - places[0]);
    const double sweep = turned < 0.0 ? turn - whole_turn : turn;
    if (sweep == 0.0) return tl::make_unexpected("the arc ends where it begins");
    return AddArc{.center = places[0], .radius = radius, .start = degrees_of(start), .sweep = sweep};
}

/// From the first to the second place, by the third one.
Outcome<Command> arc_through(const std::vector<core::Point>& places) {
    const auto center = center_through(places);
    if (!center) return tl::make_unexpected(center.error());
    const bool is_left = core::cross(places[1] - places[0], places[2] - places[0]) < 0.0;
    return arc_around({*center, places[0], places[1]}, is_left ? 1.0 : -1.0, core::robust_length(places[0] - *center));
}

Outcome<Command> rectangle_between(core::Point a, core::Point b) {
    if (a.x == b.x || a.y == b.y) return tl::make_unexpected("the rectangle has no width or no height");
    return AddPolyline{.points = {a, {b.x, a.y}, b, {a.x, b.y}}, .closed = true};
}

Outcome<Command> ellipse_of(const std::vector<core::Point>& places, const ShapeHints& hints) {
    const core::Vector first = places[1] - places[0];
    const double length = core::robust_length(first);
    const double reach = core::cross(first / length, places[2] - places[0]);
    const double second = std::abs(hints.length.value_or(reach));
    if (!(length > 0.0) || second == 0.0) return tl::make_unexpected("the ellipse has no width or no height");
    return AddEllipse{.center = places[0], .first_axis = length, .second_axis = second, .rotation = degrees_of(first)};
}

/// Start, end, corner, and a place as far from the chord as the conic is to be: in the middle of it, w / (1 + w) of the
/// way to the corner.
Outcome<Command> conic_of(const std::vector<core::Point>& places) {
    const core::Point middle = core::middle(places[0], places[1]);
    const core::Vector way = places[2] - middle;
    const double share = core::dot(places[3] - middle, way) / core::dot(way, way);
    if (!(share > 0.0 && share < 1.0))
        return tl::make_unexpected("the conic must pass between the line of its ends and its corner");
    return AddConic{.points = {places[0], places[2], places[1]}, .weight = share / (1.0 - share)};
}

Outcome<Command> polygon_of(core::Point center, core::Point corner, const ShapeHints& hints) {
    return AddPolygon{.center = center,
                      .radius = radius_of(center, corner, hints),
                      .sides = hints.sides,
                      .start = degrees_of(corner - center)};
}

}  // namespace

std::size_t place_count(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::line:
        case ShapeKind::rectangle:
        case ShapeKind::polygon:
        case ShapeKind::circle:
            return 2;
        case ShapeKind::conic:
            return 4;
        default:
            return 3;
    }
}

Outcome<Command> shape_command(ShapeKind kind, const std::vector<core::Point>& places, const ShapeHints& hints) {
    assert(places.size() == place_count(kind));
    if (places[0] == places[1]) return tl::make_unexpected("the two places are the same");
    switch (kind) {
        case ShapeKind::line:
            return AddLine{.from = places[0], .to = places[1]};
        case ShapeKind::rectangle:
            return rectangle_between(places[0], places[1]);
        case ShapeKind::polygon:
            return polygon_of(places[0], places[1], hints);
        case ShapeKind::circle:
            return AddCircle{.center = places[0],
                             .radius = radius_of(places[0], places[1], hints),
                             .polygon = core::CirclePolygon::square};
        case ShapeKind::circle_through_points:
            return circle_through(places);
        case ShapeKind::arc:
            return arc_around(places, hints.turned, core::robust_length(places[1] - places[0]));
        case ShapeKind::arc_through_points:
            return arc_through(places);
        case ShapeKind::ellipse:
            return ellipse_of(places, hints);
        case ShapeKind::conic:
            break;
    }
    return conic_of(places);
}

}  // namespace batten::editor
