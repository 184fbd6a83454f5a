#include "exchange/dxf/dxf_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/edit/transform.h"
#include "core/make/conics.h"
#include "core/make/interpolate.h"
#include "core/make/shapes.h"
#include "core/measure/closing.h"
#include "core/refine/periodic.h"
#include "exchange/dxf/bulged_polyline.h"

namespace batten::exchange {

namespace {

using core::Curve;
using core::Point;

constexpr double whole_turn = 360.0;

tl::unexpected<std::string> because(std::string reason) {
    return tl::unexpected(std::move(reason));
}

// Which way the plane of an entity is seen; none where it is tilted.
enum class Facing { up, down };

std::optional<Facing> facing_of(const DxfEntity& entity) {
    constexpr double negligible = 1e-9;
    const double z = entity.number(230, 1.0);
    const double aside = std::hypot(entity.number(210, 0.0), entity.number(220, 0.0));
    if (!(aside <= negligible * std::abs(z)) || z == 0.0) return std::nullopt;
    return z > 0.0 ? Facing::up : Facing::down;
}

// Seen from below, coordinates of the entity run to the left.
MadeCurve seen_from_above(const DxfEntity& entity, const core::Result<Curve>& made) {
    const std::optional<Facing> facing = facing_of(entity);
    if (!facing) return because("its plane is tilted; it must lie in the plane of x and y");
    if (!made || *facing == Facing::up) return in_words(made);
    return in_words(core::transform(*made, core::scaling(-1.0, 1.0, {0.0, 0.0})));
}

MadeCurve line_curve(const DxfEntity& entity) {
    const std::vector<Point> from = entity.points(10, 20);
    const std::vector<Point> to = entity.points(11, 21);
    if (from.empty() || to.empty()) return because("it has no two ends");
    return in_words(core::line(from.back(), to.back()));
}

// From one angle on to the other, in degrees; a whole turn where they are equal, or would be but for rounding.
core::ArcAngles turn_between(double start, double end) {
    constexpr double negligible = 1e-8;
    double sweep = std::fmod(end - start, whole_turn);
    if (sweep <= negligible) sweep += whole_turn;
    if (sweep > whole_turn - negligible) sweep = whole_turn;
    return {std::fmod(start, whole_turn), sweep};
}

MadeCurve round_curve(const DxfEntity& entity, core::ArcAngles angles) {
    const std::vector<Point> center = entity.points(10, 20);
    if (center.empty()) return because("it has no center");
    return seen_from_above(entity, core::circular_arc(center.back(), entity.number(40, 0.0), angles));
}

MadeCurve circle_curve(const DxfEntity& entity) {
    return round_curve(entity, {});
}

MadeCurve arc_curve(const DxfEntity& entity) {
    return round_curve(entity, turn_between(entity.number(50, 0.0), entity.number(51, whole_turn)));
}

// The part of the unit circle, mapped: so every number of the file counts as it is.
MadeCurve ellipse_curve(const DxfEntity& entity) {
    constexpr double degrees = 180.0 / std::numbers::pi;
    constexpr double rounding_of_six_digits = 1e-5;  // some programs write 6.28319 for a whole turn
    const std::vector<Point> center = entity.points(10, 20);
    const std::vector<Point> axis = entity.points(11, 21);
    if (center.empty() || axis.empty()) return because("it has no center or no axis");
    const std::optional<Facing> facing = facing_of(entity);
    if (!facing || entity.number(31, 0.0) != 0.0)
        return because("its plane is tilted; it must lie in the plane of x and y");
    const double ratio = entity.number(40, 1.0);
    if (axis.back() == Point{0.0, 0.0}) return because("its first axis has no length");
    if (ratio == 0.0) return because("its second axis has no length, since the ratio of its axes is 0");
    const double start = entity.number(41, 0.0);
    const double end = entity.number(42, 2.0 * std::numbers::pi);
    const bool is_whole = std::abs(end - start - 2.0 * std::numbers::pi) <= rounding_of_six_digits;
    const core::ArcAngles angles = is_whole ? core::ArcAngles{std::fmod(degrees * start, whole_turn)}
                                            : turn_between(degrees * start, degrees * end);
    const core::Vector major = core::vector_to(axis.back());
    const core::Vector minor = (*facing == Facing::up ? 1.0 : -1.0) * ratio * core::turned_left(major);
    const core::PlaneMap map{
        {{{major.x, minor.x, center.back().x}, {major.y, minor.y, center.back().y}, {0.0, 0.0, 1.0}}}};
    return in_words(core::circular_arc({0.0, 0.0}, 1.0, angles).and_then([&](const Curve& unit) {
        return core::transform(unit, map);
    }));
}

MadeCurve polyline_curve(const DxfEntity& entity) {
    const std::vector<Point> points = entity.points(10, 20);
    constexpr unsigned closed = 1;
    return seen_from_above(entity, bulged_polyline(points, entity.bulges(), entity.has_bit(70, closed)));
}

// Weights that are all -1 stand for none; one of them among others is wrong.
std::vector<double> weights_of(const DxfEntity& entity) {
    const std::span<const double> found = entity.numbers(41);
    constexpr double absent = -1.0;
    if (std::ranges::all_of(found, [](double w) { return w == absent; })) return {};
    return {found.begin(), found.end()};
}

// What repeats its points and knots, and says so, is taken for the closed curve that it draws.
Curve closed_if_wrapped(const DxfEntity& entity, Curve curve) {
    constexpr unsigned closed_or_periodic = 3;
    constexpr double exactly = 1e-15;
    if (!entity.has_bit(70, closed_or_periodic)) return curve;
    if (core::closing_of(curve, exactly).closing != core::Closing::wrapped) return curve;
    const auto periodic = core::to_periodic(curve, core::absolute_tolerance(curve, exactly));
    return periodic && periodic->error == 0.0 ? periodic->curve : curve;
}

bool is_closed_through_points(const DxfEntity& entity) {
    constexpr unsigned closed = 1;
    constexpr std::size_t least_closed = 4;
    return entity.has_bit(70, closed) && entity.points(11, 21).size() >= least_closed;
}

// The file has directions alone. The length of the polygon is that of a derivative over [0, 1].
core::EndTangents end_tangents(const DxfEntity& entity, std::span<const Point> points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += core::robust_length(points[i] - points[i - 1]);
    const auto with_length = [&](core::Vector direction) {
        const double size = std::max(std::abs(direction.x), std::abs(direction.y));
        const core::Vector moderate{direction.x / size, direction.y / size};
        return length / core::length(moderate) * moderate;
    };
    const auto tangent = [&](int x_code, int y_code) {
        const std::optional<core::Vector> direction = entity.vector(x_code, y_code);
        return direction ? std::optional(with_length(*direction)) : std::nullopt;
    };
    return {tangent(12, 22), tangent(13, 23)};
}

MadeCurve through_fit_points(const DxfEntity& entity) {
    std::vector<Point> points = entity.points(11, 21);
    constexpr std::size_t cubic = 3;
    std::size_t conditions = points.size();
    core::InterpolationRequest request;
    if (is_closed_through_points(entity)) {
        if (points.front() == points.back()) points.pop_back();
        request.ends = core::ClosedEnds{};
    } else if (!entity.defect_of_tangents().empty()) {
        return because(entity.defect_of_tangents());
    } else if (has_end_tangents(entity)) {
        const core::EndTangents tangents = end_tangents(entity, points);
        conditions += (tangents.start ? 1U : 0U) + (tangents.end ? 1U : 0U);
        request.ends = tangents;
    }
    request.degree = static_cast<int>(std::clamp(conditions, std::size_t{2}, cubic + 1) - 1);
    auto found = core::interpolate(points, request);
    if (!found) return because(core::describe(found.error()));
    return std::move(found->curve);
}

MadeCurve spline_curve(const DxfEntity& entity) {
    if (has_fit_points_alone(entity)) return through_fit_points(entity);
    const double degree = entity.number(71, 0.0);
    const std::span<const double> knots = entity.numbers(40);
    if (!(degree >= core::min_degree && degree <= core::max_degree && std::trunc(degree) == degree))
        return because(core::sentence(
            "its degree is {found}, but it must be a whole number from {least} to {most}",
            {{"found", core::shortest_text(degree)}, {"least", core::min_degree}, {"most", core::max_degree}}));
    return make_curve({.degree = static_cast<int>(degree),
                       .knots = {knots.begin(), knots.end()},
                       .points = entity.points(10, 20),
                       .weights = weights_of(entity)})
        .map([&](Curve curve) { return closed_if_wrapped(entity, std::move(curve)); });
}

}  // namespace

DxfCurveMaker dxf_curve_maker(std::string_view name) {
    if (name == "SPLINE") return spline_curve;
    if (name == "LWPOLYLINE" || name == "POLYLINE") return polyline_curve;
    if (name == "LINE") return line_curve;
    if (name == "ARC") return arc_curve;
    if (name == "CIRCLE") return circle_curve;
    if (name == "ELLIPSE") return ellipse_curve;
    return nullptr;
}

bool has_fit_points_alone(const DxfEntity& entity) {
    return entity.numbers(10).empty() && !entity.numbers(11).empty();
}

bool has_end_tangents(const DxfEntity& entity) {
    return !is_closed_through_points(entity) && (entity.vector(12, 22) || entity.vector(13, 23));
}

bool is_mesh(const DxfEntity& entity) {
    constexpr unsigned mesh_or_polyface = 16 + 64;
    return entity.has_bit(70, mesh_or_polyface);
}

bool is_on_polyline(const DxfEntity& entity) {
    constexpr unsigned control_point_of_frame = 16;
    return !entity.has_bit(70, control_point_of_frame);
}

}  // namespace batten::exchange
