#include "app/editor/lesson/check.h"

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/view_handle.h"
#include "app/editor/state/state.h"
#include "app/editor/words/continuity_words.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/bounds.h"
#include "core/measure/closing.h"
#include "core/measure/continuity.h"
#include "core/measure/nearest.h"
#include "core/refine/clamping.h"
#include "core/refine/join.h"

namespace batten::editor {

namespace {

using core::Curve;
using core::sentence;

constexpr int circle_samples = 200;
constexpr int digits = 6;  // of numbers that are compared and no small fractions

template <class Found>
CheckResult compared(bool holds, const char* yes, const char* no, Found found, Found wanted) {
    return {holds, holds ? sentence(yes, {{"found", found}}) : sentence(no, {{"found", found}, {"wanted", wanted}})};
}

std::string order_text(int continuity) {
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

bool has_order(const core::JointContinuity& joint, JointOrder order) {
    switch (order) {
        case JointOrder::C0:
            return joint.parametric >= 0;
        case JointOrder::C1:
            return joint.parametric >= 1;
        case JointOrder::C2:
            return joint.parametric >= 2;
        case JointOrder::G1:
            return joint.geometric >= 1;
        case JointOrder::G2:
            return joint.geometric >= 2;
    }
    return false;
}

CheckResult joint_result(const core::JointContinuity& joint, JointOrder order) {
    const std::string found = continuity_verdict(joint);
    if (has_order(joint, order)) return {true, found};
    return {false, sentence("{found}; it shall be {order}", {{"found", found}, {"order", core::title_of(order)}})};
}

core::ContinuityTolerances tolerances_of(double within) {
    return {within, within, within, within};
}

/// Points of the curve, as many for each of its spans; fewer where these are many.
std::vector<core::Point> points_along(const Curve& curve) {
    constexpr std::size_t most_points = 4000;
    constexpr std::size_t points_per_span = 50;
    const std::size_t count = std::min(most_points, points_per_span * core::segment_count(curve.knots()));
    const core::Interval domain = curve.domain();
    std::vector<core::Point> points;
    for (std::size_t k = 0; k <= count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(count);
        points.push_back(core::point_at(curve, domain.lower + share * domain.length()));
    }
    return points;
}

/// One case for each check; `curve` is the active one.
struct Checker {
    const EditorState& state;
    const core::Document& document;
    const Curve& curve;

    std::string number(double value) const { return exact_text(state.view.notation, value, digits); }
    std::string length_text(double world) const {
        return with_unit(document.units, exact_text(state.view.notation, in_units(document.units, world)));
    }
    std::string place_text(core::Point world) const {
        const core::Point place = in_units(document.units, world);
        return with_unit(document.units, sentence("({x}, {y})", {{"x", number(place.x)}, {"y", number(place.y)}}));
    }
    const core::DocumentCurve* curve_at(std::size_t index) const {
        return index < document.curves.size() ? &document.curves[index] : nullptr;
    }

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
            return {true,
                    sentence("the multiplicity of {knot} is {is}", {{"knot", number(check.knot)}, {"is", check.is}})};
        return {false, sentence("the multiplicity of {knot} is {found}, not yet {is}",
                                {{"knot", number(check.knot)}, {"found", found}, {"is", check.is}})};
    }
    CheckResult operator()(const ContinuityIs& check) const {
        const auto knots = core::distinct_knots(curve.knots());
        const core::DistinctKnot* knot = knot_at(knots, check.knot);
        if (knot == nullptr) return {false, sentence("{knot} is no knot", {{"knot", number(check.knot)}})};
        if (knot->continuity == check.is)
            return {true, sentence("the curve is {order} at {knot} by its knots",
                                   {{"order", order_text(check.is)}, {"knot", number(check.knot)}})};
        return {false, sentence("the curve is {found} at {knot} by its knots, not yet {order}",
                                {{"found", order_text(knot->continuity)},
                                 {"knot", number(check.knot)},
                                 {"order", order_text(check.is)}})};
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
                                {{"place", name}, {"distance", length_text(distance)}})};
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
        return {false, sentence("the curve leaves the circle by {distance}", {{"distance", length_text(worst)}})};
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
                                   {{"point", point_text(check.point)}, {"is", number(check.is)}})};
        return {false,
                sentence("the weight of {point} is {found}, not yet {is}",
                         {{"point", point_text(check.point)}, {"found", number(found)}, {"is", number(check.is)}})};
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
                        number(found), number(check.is));
    }
    CheckResult operator()(const OverlayIsShown& check) const {
        const bool holds = state.view.overlays.is_shown(check.overlay);
        return {holds, sentence(holds ? "the view '{view}' is shown" : "the view '{view}' is not shown yet",
                                {{"view", core::title_of(check.overlay)}})};
    }
    CheckResult operator()(const CurvesJoin& check) const;
    CheckResult operator()(const PointsAreCollinear& check) const;
    CheckResult operator()(const SmoothnessIs& check) const;
    CheckResult operator()(const IsClamped& check) const;
    CheckResult operator()(const CrossingsAre& check) const;
    CheckResult operator()(const IsConvex& check) const;
};

CheckResult Checker::operator()(const CurvesJoin& check) const {
    if (curve_at(check.first) == nullptr || curve_at(check.second) == nullptr)
        return {false, "there are not two curves"};
    const Curve& first = *curve_at(check.first)->curve;
    const Curve& second = *curve_at(check.second)->curve;
    if (first.is_periodic() || second.is_periodic()) return {false, "a closed curve has no ends"};
    core::Box box = core::control_box(first);
    for (const core::Point point : second.control_points()) box.include(point);
    const core::JointContinuity joint =
        core::continuity_between(first, second, core::nearest_ends(first, second), box, tolerances_of(check.within));
    if (joint.geometric < 0)
        return {false, sentence("the ends are {distance} apart", {{"distance", length_text(joint.position.size)}})};
    return joint_result(joint, check.order);
}

CheckResult Checker::operator()(const SmoothnessIs& check) const {
    const auto knots = core::distinct_knots(curve.knots());
    const core::DistinctKnot* knot = knot_at(knots, check.knot);
    if (knot == nullptr || !knot->is_interior)
        return {false, sentence("{knot} is no inner knot", {{"knot", number(check.knot)}})};
    return joint_result(core::joint_continuity_at(curve, *knot, core::control_box(curve), tolerances_of(check.within)),
                        check.order);
}

CheckResult Checker::operator()(const IsClamped& check) const {
    const bool holds = check.end ? core::is_clamped_at(curve.knots(), *check.end) : core::is_clamped(curve.knots());
    if (!check.end) return {holds, holds ? "the curve is clamped at both ends" : "the curve is not clamped yet"};
    return {holds, sentence(holds ? "the curve is clamped at its {end}" : "the curve is not clamped yet at its {end}",
                            {{"end", core::title_of(*check.end)}})};
}

CheckResult Checker::operator()(const CrossingsAre& check) const {
    const auto line = shown_probe_line(state);
    const auto found = line ? state.measured.crossings(curve, *line) : nullptr;
    if (!found) return {false, "there is no line to be crossed"};
    const bool holds = check.polygon.value_or(found->polygon_crossings) == found->polygon_crossings &&
                       check.curve.value_or(found->crossings) == found->crossings;
    return {holds, sentence("crossings of the line: {polygon} with the polygon, {curve} with the curve",
                            {{"polygon", found->polygon_crossings}, {"curve", found->crossings}})};
}

CheckResult Checker::operator()(const IsConvex& check) const {
    constexpr double rounding = 1e-6;  // radians, between points that are near to one another
    if (check.of == ConvexShape::polygon) {
        const bool holds = core::is_convex(curve.control_points());
        return {holds, holds ? "the polygon is convex" : "the polygon is not convex yet"};
    }
    const bool holds = core::is_convex(points_along(curve), rounding);
    return {holds, holds ? "the curve is convex" : "the curve is not convex yet"};
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
    return {false, sentence("a point is {distance} off the line", {{"distance", length_text(farthest)}})};
}

}  // namespace

CheckResult result_of(const LessonCheck& check, const EditorState& state) {
    const core::Document& document = state.history.present();
    const core::DocumentCurve* active = document.active_curve();
    if (active == nullptr) return {false, "there is no curve"};
    return std::visit(Checker{state, document, *active->curve}, check);
}

}  // namespace batten::editor
