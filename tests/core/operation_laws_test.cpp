/// Laws of the operations that keep the shape, on curves of every sort.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/degree.h"
#include "core/refine/join.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/knot_removal.h"
#include "core/refine/periodic.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"
#include "tests/core/law_curves.h"

namespace batten::core::laws {

namespace {

// Two evaluations of up to 4 units each (see the laws of shape), and some for the new control points, of which every
// one is a convex combination of old ones in up to p steps, each rounded.
double allowed_change(const Curve& curve) {
    return (16 + 2 * curve.degree()) * unit_of(curve);
}

template <class T>
T value_of(const Result<T>& result) {
    if (!result) RC_FAIL(describe(result.error()));
    return *result;
}

std::vector<double> draw_insertable_parameters(const Curve& curve, int count) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k) values.push_back(draw_insertable_parameter(curve));
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

TEST(OperationLaws, insertion_keeps_the_shape) {
    check_everywhere("insertion keeps the shape", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const double u = draw_insertable_parameter(curve);
        const int times = draw_whole(1, curve.degree() - curve.knots().multiplicity(u));
        const Curve refined = value_of(insert_knot(curve, u, times));
        RC_ASSERT(refined.knots().multiplicity(u) == curve.knots().multiplicity(u) + times);
        RC_ASSERT(largest_distance(refined, curve) <= allowed_change(curve));
    });
}

TEST(OperationLaws, refinement_keeps_the_shape) {
    check_everywhere("refinement keeps the shape", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const Curve refined = value_of(refine_knots(curve, draw_insertable_parameters(curve, draw_whole(1, 6))));
        RC_ASSERT(largest_distance(refined, curve) <= allowed_change(curve));
    });
}

TEST(OperationLaws, bezier_pieces_keep_the_shape) {
    check_everywhere("the Bézier pieces are the curve", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        for (const BezierPiece& piece : bezier_pieces(curve)) {
            CurveDefinition definition{.degree = curve.degree()};
            definition.knots.assign(piece.points.size(), piece.interval.lower);
            definition.knots.insert(definition.knots.end(), piece.points.size(), piece.interval.upper);
            for (const HomogeneousPoint& point : piece.points) {
                definition.points.push_back(project(point));
                definition.weights.push_back(point.z);
            }
            const Curve bezier = value_of(Curve::make(std::move(definition)));
            RC_ASSERT(largest_distance(bezier, curve) <= allowed_change(curve));
        }
    });
}

TEST(OperationLaws, elevation_keeps_the_shape) {
    check_everywhere("elevation keeps the shape", [](Setting setting) {
        const Curve curve = draw_curve(setting, {.most_degree = max_degree - 3});
        const int by = draw_whole(1, 3);
        const Curve elevated = value_of(elevate_degree(curve, by));
        RC_ASSERT(elevated.degree() == curve.degree() + by);
        RC_ASSERT(largest_distance(curve, elevated) <= allowed_change(curve));
    });
}

TEST(OperationLaws, clamping_keeps_the_shape) {
    check_everywhere("opening and clamping keep the shape", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const Curve clamped = value_of(to_clamped(curve));
        RC_ASSERT(is_clamped(clamped.knots()));
        RC_ASSERT(largest_distance(curve, clamped) <= allowed_change(curve));
    });
}

// Wrapping copies points, so it is exact; and back.
TEST(OperationLaws, wrapping_keeps_every_bit) {
    check_everywhere("wrapping keeps every bit, there and back", [](Setting setting) {
        if (setting == Setting::close_and_long) return;  // see draw_curve
        const Curve curve = draw_curve(setting, {.open = false});
        const Curve wrapped = value_of(to_wrapped(curve, 1e-9)).curve;
        RC_ASSERT(largest_distance(curve, wrapped) == 0.0);
        const Curve back = value_of(to_periodic(wrapped, 1e-9)).curve;
        RC_ASSERT(std::ranges::equal(back.control_points(), curve.control_points()));
        RC_ASSERT(std::ranges::equal(back.weights(), curve.weights()));
    });
}

TEST(OperationLaws, splitting_keeps_the_shape) {
    check_everywhere("the parts of a curve are the curve", [](Setting setting) {
        const Curve curve = draw_curve(setting, {.periodic = false});
        const double u = draw_parameter(curve);
        RC_PRE(curve.domain().lower < u && u < curve.domain().upper);
        const auto parts = value_of(split(curve, u));
        RC_ASSERT(parts.size() == 2u);
        RC_ASSERT(parts[0].domain() == (Interval{curve.domain().lower, u}));
        RC_ASSERT(parts[1].domain() == (Interval{u, curve.domain().upper}));
        RC_ASSERT(parts[0].control_points().back() == parts[1].control_points().front());
        RC_ASSERT(largest_distance(parts[0], curve) <= allowed_change(curve));
        RC_ASSERT(largest_distance(parts[1], curve) <= allowed_change(curve));
    });
}

TEST(OperationLaws, opening_keeps_the_shape) {
    check_everywhere("a closed curve that is opened anywhere is the same curve", [](Setting setting) {
        if (setting == Setting::close_and_long) return;
        const Curve curve = draw_curve(setting, {.open = false});
        const double u = draw_parameter(curve);
        const auto parts = value_of(split(curve, u));
        RC_ASSERT(parts.size() == 1u);
        RC_ASSERT(is_clamped(parts[0].knots()));
        RC_ASSERT(largest_distance(parts[0], curve) <= allowed_change(curve));
    });
}

TEST(OperationLaws, reversing_twice_is_the_identity) {
    check_everywhere("reversing twice gives every bit back", [](Setting setting) {
        const Curve curve = draw_curve(setting);
        const auto reversed = reverse(curve);
        // Knots so close that their mirror images are one number cannot be reversed.
        RC_PRE(reversed.has_value());
        const Curve back = value_of(reverse(*reversed));
        RC_ASSERT(std::ranges::equal(back.control_points(), curve.control_points()));
        RC_ASSERT(std::ranges::equal(back.weights(), curve.weights()));
        if (setting != Setting::close_knots && setting != Setting::close_and_long)
            RC_ASSERT(std::ranges::equal(back.knots().values(), curve.knots().values()));
    });
}

// Going back from the inserted points to those before divides by shares of 1/2 and more, p/2 times for each knot; what
// rounding did to the inserted ones grows by up to 2 with each division.
TEST(OperationLaws, insert_then_remove_restores) {
    check_everywhere("inserting a knot and removing it gives the points back", [](Setting setting) {
        const Curve curve = draw_curve(setting, {.most_degree = 9});
        const double u = draw_insertable_parameter(curve);
        RC_PRE(curve.domain().lower < u && u < curve.domain().upper);
        const int times = draw_whole(1, std::min(3, curve.degree() - curve.knots().multiplicity(u)));
        const Curve refined = value_of(insert_knot(curve, u, times));
        const double allowed = std::ldexp(allowed_change(curve), curve.degree() / 2 + times);
        RC_PRE(allowed > 0.0);
        const KnotRemoval back = value_of(remove_knot(refined, u, times, allowed));
        RC_ASSERT(back.count == times);
        RC_ASSERT(std::ranges::equal(back.curve.knots().values(), curve.knots().values()));
        RC_ASSERT(largest_distance(curve, back.curve) <= allowed);
    });
}

namespace {

// What both sides of a joint say about its derivatives, and how large a derivative of each order may be there, given
// the size of the control points and the shorter of the two spans.
struct Joint {
    Jet before;
    Jet after;
    std::vector<double> scales;
    double rounding = 0.0;
};

Joint joint_at(const Curve& curve, double u, int order) {
    const KnotVector& knots = curve.knots();
    Joint joint{derivatives_at(curve, u, order, Side::left), derivatives_at(curve, u, order, Side::right), {}, 0.0};
    const double span = std::min(knots[knots.span_at(u) + 1] - u, u - knots[knots.span_at(u, Side::left)]);
    joint.scales.push_back(std::ldexp(unit_of(curve), 53));
    for (int r = 0; r < order; ++r) joint.scales.push_back(joint.scales.back() * curve.degree() / span);
    joint.rounding = std::ldexp(64.0 * curve.degree(), -53);
    return joint;
}

}  // namespace

TEST(OperationLaws, joined_curves_have_equal_derivatives) {
    check_everywhere("curves joined with C0, C1, C2 have equal derivatives", [](Setting setting) {
        const Sort sort{.most_degree = 9, .periodic = false};
        const Curve first = draw_curve(setting, sort);
        const Curve second = draw_curve(setting, sort);
        const int order = draw_whole(0, 2);
        const auto joined = join(
            first, second,
            std::array{JoinContinuity::c0, JoinContinuity::c1, JoinContinuity::c2}[static_cast<std::size_t>(order)],
            JoinedEnds{});
        RC_PRE(joined.has_value());
        const Joint joint = joint_at(joined->curve, first.domain().upper, order);
        RC_ASSERT(distance(joint.before.point, joint.after.point) <= joint.rounding * joint.scales[0]);
        for (std::size_t r = 1; r <= joint.before.derivatives.size(); ++r)
            RC_ASSERT(robust_length(joint.before[r] - joint.after[r]) <= joint.rounding * joint.scales[r]);
    });
}

TEST(OperationLaws, joined_curves_have_equal_tangents_and_curvatures) {
    check_everywhere("curves joined with G1, G2 have equal tangents and curvatures", [](Setting setting) {
        const Sort sort{.most_degree = 9, .periodic = false};
        const Curve first = draw_curve(setting, sort);
        const Curve second = draw_curve(setting, sort);
        const bool bends_alike = draw_whole(0, 1) == 1;
        const auto joined = join(first, second, bends_alike ? JoinContinuity::g2 : JoinContinuity::g1, JoinedEnds{});
        RC_PRE(joined.has_value());
        const double u = first.domain().upper;
        const Joint joint = joint_at(joined->curve, u, 2);
        const double slower = std::min(robust_length(joint.before[1]), robust_length(joint.after[1]));
        // Slow ends have no direction that rounding leaves alone.
        RC_PRE(slower > 1e-6 * joint.scales[1]);
        const double angle = joint.rounding * joint.scales[1] / slower;
        RC_ASSERT(robust_length(joint.before[1] / robust_length(joint.before[1]) -
                                joint.after[1] / robust_length(joint.after[1])) <= angle);
        if (!bends_alike) return;
        const auto before = curvature_at(joined->curve, u, Side::left);
        const auto after = curvature_at(joined->curve, u, Side::right);
        RC_ASSERT(before.has_value() && after.has_value());
        RC_ASSERT(std::abs(*before - *after) <= angle * joint.scales[2] / (slower * slower));
    });
}

}  // namespace batten::core::laws
