#include "app/editor/lesson/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/editor/state/state.h"
#include "app/editor/words/formula.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/closing.h"
#include "core/measure/nearest.h"

namespace batten::editor {

namespace {

using core::Curve;
using core::sentence;
using core::shortest_text;

constexpr int circle_samples = 200;

template <class Found>
CheckResult compared(bool holds, const char* yes, const char* no, Found found, Found wanted) {
    return {holds, holds ? sentence(yes, {{"found", found}}) : sentence(no, {{"found", found}, {"wanted", wanted}})};
}

std::string place_text(core::Point place) {
    return sentence("({x}, {y})", {{"x", shortest_text(place.x)}, {"y", shortest_text(place.y)}});
}

std::string smoothness_text(int continuity) {
    return plain_text(continuity_text(continuity));
}

const core::DistinctKnot* knot_at(const std::vector<core::DistinctKnot>& knots, double value) {
    const auto found =
        std::find_if(knots.begin(), knots.end(), [&](const core::DistinctKnot& knot) { return knot.value == value; });
    return found == knots.end() ? nullptr : &*found;
}

CheckResult no_such_point(std::size_t index) {
    return {false, sentence("there is no control point {point}", {{"point", point_text(index)}})};
}

/// The circle through three places of the curve; none where they are on one line.
struct Circle {
    core::Point center;
    double radius = 0.0;
};

std::optional<Circle> circle_through(core::Point a, core::Point b, core::Point c) {
    const core::Vector u = b - a;
    const core::Vector v = c - a;
    const double cross = 2.0 * core::cross(u, v);
    if (std::abs(cross) <= 1e-12 * core::length(u) * core::length(v)) return std::nullopt;
    const double uu = core::dot(u, u);
    const double vv = core::dot(v, v);
    const core::Vector to_center{(v.y * uu - u.y * vv) / cross, (u.x * vv - v.x * uu) / cross};
    return Circle{a + to_center, core::length(to_center)};
}

/// Where a curve ends and how it goes on from there, outward.
struct End {
    core::Point point{};
    core::Vector derivative{};  ///< along the curve
    bool is_upper = false;
};

std::array<End, 2> ends_of(const Curve& curve) {
    const core::Interval domain = curve.domain();
    const auto lower = core::derivatives_at(curve, domain.lower, 1, core::Side::right);
    const auto upper = core::derivatives_at(curve, domain.upper, 1, core::Side::left);
    return {End{lower.point, lower[1], false}, End{upper.point, upper[1], true}};
}

/// One case for each check; `curve` is the active one.
struct Checker {
    const EditorState& state;
    const core::Document& document;
    const Curve& curve;

    CheckResult operator()(const DegreeIs& check) const {
        return compared(curve.degree() == check.is, "the degree is {found}", "the degree is {found}, not yet {wanted}",
                        curve.degree(), check.is);
    }
    CheckResult operator()(const PointCountIs& check) const {
        const std::size_t found = curve.control_points().size();
        return compared(found == check.is, "there are {found} control points",
                        "there are {found} control points, not yet {wanted}", found, check.is);
    }
    CheckResult operator()(const SegmentCountIs& check) const {
        const std::size_t found = core::segment_count(curve.knots());
        return compared(found == check.is, "the number of segments is {found}",
                        "the number of segments is {found}, not yet {wanted}", found, check.is);
    }
    CheckResult operator()(const CurveCountIs& check) const {
        return compared(document.curves.size() == check.is, "the number of curves is {found}",
                        "the number of curves is {found}, not yet {wanted}", document.curves.size(), check.is);
    }
    CheckResult operator()(const MultiplicityIs& check) const {
        const auto knots = core::distinct_knots(curve.knots());
        const core::DistinctKnot* knot = knot_at(knots, check.knot);
        const int found = knot == nullptr ? 0 : knot->multiplicity;
        if (found == check.is)
            return {true, sentence("the multiplicity of {knot} is {is}",
                                   {{"knot", shortest_text(check.knot)}, {"is", check.is}})};
        return {false, sentence("the multiplicity of {knot} is {found}, not yet {is}",
                                {{"knot", shortest_text(check.knot)}, {"found", found}, {"is", check.is}})};
    }
    CheckResult operator()(const ContinuityIs& check) const {
        const auto knots = core::distinct_knots(curve.knots());
        const core::DistinctKnot* knot = knot_at(knots, check.knot);
        if (knot == nullptr) return {false, sentence("{knot} is no knot", {{"knot", shortest_text(check.knot)}})};
        if (knot->continuity == check.is)
            return {true, sentence("the curve is {order} at {knot} by its knots",
                                   {{"order", smoothness_text(check.is)}, {"knot", shortest_text(check.knot)}})};
        return {false, sentence("the curve is {found} at {knot} by its knots, not yet {order}",
                                {{"found", smoothness_text(knot->continuity)},
                                 {"knot", shortest_text(check.knot)},
                                 {"order", smoothness_text(check.is)}})};
    }
    CheckResult operator()(const NoInteriorKnot&) const {
        const auto knots = core::distinct_knots(curve.knots());
        const auto found = static_cast<std::size_t>(
            std::count_if(knots.begin(), knots.end(), [](const core::DistinctKnot& knot) { return knot.is_interior; }));
        return {found == 0, sentence({.one = "there still is one interior knot",
                                      .many = "there still are {count} interior knots",
                                      .none = "there is no interior knot"},
                                     found)};
    }
    CheckResult operator()(const KindIs& check) const {
        const core::KnotKind found = core::kind_by_values(curve.knots());
        return compared<std::string_view>(found == check.is, "the knots are {found}",
                                          "the knots are {found}, not yet {wanted}", core::title_of(found),
                                          core::title_of(check.is));
    }
    CheckResult operator()(const PassesThrough& check) const {
        if (check.point && *check.point >= curve.control_points().size()) return no_such_point(*check.point);
        const core::Point place = check.point ? curve.control_points()[*check.point] : check.at;
        const double distance = core::distance(core::nearest_point(curve, place).point, place);
        const std::string name =
            check.point ? sentence("{point}", {{"point", point_text(*check.point)}}) : place_text(place);
        if (distance <= check.within) return {true, sentence("the curve passes through {place}", {{"place", name}})};
        return {false, sentence("the curve passes {place} at a distance of {distance}",
                                {{"place", name}, {"distance", shortest_text(distance)}})};
    }
    CheckResult operator()(const IsCircle& check) const {
        const core::Interval domain = curve.domain();
        const auto at = [&](double share) { return core::point_at(curve, domain.lower + share * domain.length()); };
        const auto circle = circle_through(at(0.0), at(0.37), at(0.71));
        if (!circle) return {false, "the curve is straight"};
        double worst = 0.0;
        for (int k = 0; k <= circle_samples; ++k)
            worst = std::max(
                worst,
                std::abs(core::distance(at(k / static_cast<double>(circle_samples)), circle->center) - circle->radius));
        if (worst <= check.within * circle->radius) return {true, "the curve lies on a circle"};
        return {false, sentence("the curve leaves the circle by {distance}", {{"distance", shortest_text(worst)}})};
    }
    CheckResult operator()(const ConicIs& check) const {
        const core::BezierPieces pieces = core::bezier_pieces(curve);
        if (curve.degree() != 2 || pieces.size() != 1) return {false, "the curve is not one piece of degree 2"};
        const auto form = core::conic_form(pieces.front());
        if (!form) return {false, "the curve is straight"};
        return compared<std::string_view>(form->type == check.is, "the conic is of the kind {found}",
                                          "the conic is of the kind {found}, not yet {wanted}",
                                          core::title_of(form->type), core::title_of(check.is));
    }
    CheckResult operator()(const IsClosed&) const {
        const bool holds = core::closing_of(curve).closing != core::Closing::open;
        return {holds, holds ? "the curve is closed" : "the curve is still open"};
    }
    CheckResult operator()(const IsRational& check) const {
        const bool holds = curve.is_rational() == check.is;
        return {holds, curve.is_rational() ? "the weights differ" : "all weights are equal"};
    }
    CheckResult operator()(const WeightIs& check) const {
        if (check.point >= curve.control_points().size()) return no_such_point(check.point);
        const double found = curve.weights()[check.point];
        if (std::abs(found - check.is) <= check.within)
            return {true, sentence("the weight of {point} is {is}",
                                   {{"point", point_text(check.point)}, {"is", shortest_text(check.is)}})};
        return {false, sentence("the weight of {point} is {found}, not yet {is}", {{"point", point_text(check.point)},
                                                                                   {"found", shortest_text(found)},
                                                                                   {"is", shortest_text(check.is)}})};
    }
    CheckResult operator()(const PointIsAt& check) const {
        if (check.point >= curve.control_points().size()) return no_such_point(check.point);
        const core::Point found = curve.control_points()[check.point];
        if (core::distance(found, check.at) <= check.within)
            return {true,
                    sentence("{point} is at {at}", {{"point", point_text(check.point)}, {"at", place_text(check.at)}})};
        return {false, sentence("{point} is at {found}, not yet at {at}", {{"point", point_text(check.point)},
                                                                           {"found", place_text(found)},
                                                                           {"at", place_text(check.at)}})};
    }
    CheckResult operator()(const ParameterIs& check) const {
        const double found = state.parameter();
        return compared(std::abs(found - check.is) <= check.within, "u is {found}", "u is {found}, not yet {wanted}",
                        shortest_text(found), shortest_text(check.is));
    }
    CheckResult operator()(const OverlayIsShown& check) const {
        const bool holds = state.view.overlays.is_shown(check.overlay);
        return {holds, sentence(holds ? "the view '{view}' is shown" : "the view '{view}' is not shown yet",
                                {{"view", core::title_of(check.overlay)}})};
    }
    CheckResult operator()(const CurvesJoin& check) const;
    CheckResult operator()(const PointsAreCollinear& check) const;
};

CheckResult Checker::operator()(const CurvesJoin& check) const {
    if (check.first >= document.curves.size() || check.second >= document.curves.size())
        return {false, "there are not two curves"};
    const Curve& a = *document.curves[check.first].curve;
    const Curve& b = *document.curves[check.second].curve;
    End from;
    End to;
    double gap = std::numeric_limits<double>::infinity();
    for (const End& one : ends_of(a))
        for (const End& other : ends_of(b))
            if (const double distance = core::distance(one.point, other.point); distance < gap) {
                gap = distance;
                from = one;
                to = other;
            }
    const double size = std::max(state.derived.of(a)->size, state.derived.of(b)->size);
    if (gap > check.within * size)
        return {false, sentence("the ends are {distance} apart", {{"distance", shortest_text(gap)}})};
    if (check.order == JointOrder::C0) return {true, "the curves meet: C⁰"};
    // Along the joined curve, whichever way each of them runs.
    const core::Vector before = from.is_upper ? from.derivative : -from.derivative;
    const core::Vector after = to.is_upper ? -to.derivative : to.derivative;
    const double scale = std::max(core::length(before), core::length(after));
    const double turn = std::abs(core::cross(before, after));
    const bool is_smooth =
        core::dot(before, after) > 0.0 && turn <= check.within * core::length(before) * core::length(after);
    if (!is_smooth) return {false, "the curves meet with a corner: C⁰ only"};
    if (check.order == JointOrder::G1) return {true, "the curves have one tangent where they meet: G¹"};
    if (core::length(after - before) <= check.within * scale)
        return {true, "the derivatives agree where the curves meet: C¹"};
    return {false,
            sentence("the tangents agree, but the derivatives are {before} and {after} long: G¹ only",
                     {{"before", shortest_text(core::length(before))}, {"after", shortest_text(core::length(after))}})};
}

CheckResult Checker::operator()(const PointsAreCollinear& check) const {
    const auto points = curve.control_points();
    for (const std::size_t index : check.points)
        if (index >= points.size()) return no_such_point(index);
    if (check.points.size() < 3) return {true, "two points always are on one line"};
    core::Point a = points[check.points.front()];
    core::Point b = a;
    for (const std::size_t i : check.points)
        for (const std::size_t j : check.points)
            if (core::distance(points[i], points[j]) > core::distance(a, b)) {
                a = points[i];
                b = points[j];
            }
    const core::Vector line = b - a;
    const double length = core::length(line);
    double farthest = 0.0;
    for (const std::size_t i : check.points) {
        const core::Vector off = points[i] - a;
        if (length > 0.0) farthest = std::max(farthest, std::abs(core::cross(line, off)) / length);
    }
    if (farthest <= check.within * length) return {true, "the points are on one line"};
    return {false, sentence("a point is {distance} off the line", {{"distance", shortest_text(farthest)}})};
}

}  // namespace

CheckResult result_of(const LessonCheck& check, const EditorState& state) {
    const core::Document& document = state.history.present();
    const core::DocumentCurve* active = document.active_curve();
    if (active == nullptr) return {false, "there is no curve"};
    return std::visit(Checker{state, document, *active->curve}, check);
}

}  // namespace batten::editor
