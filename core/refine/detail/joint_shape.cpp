#include "core/refine/detail/joint_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/curve/control_box.h"
#include "core/evaluate/tangent.h"
#include "core/measure/continuity.h"

namespace batten::core {

namespace {

// The part that is changed, relative to the length of the curve and to the gap.
constexpr double least_share_of_length = 0.25;
constexpr double gaps_along = 3.0;
// A turn by a right angle or more takes so much more of the length, and of the speed where that is free.
constexpr double further_share_of_length = 0.25;
constexpr double further_share_of_speed = 0.5;
// Up to this degree so many inserted knots bend as much of the curve; in higher ones they act nearer to the start.
constexpr double even_degree = 5.0;
// The part ends before another velocity led away by its length times this, and before another acceleration changed the
// velocity by itself times this, if they stayed.
constexpr double lengths_astray = 2.0;
constexpr double velocities_astray = 2.0;
// A start is slow below this share of the speed of the curve.
constexpr double slow = 0.75;
// No part is shorter than this share of the domain, nor than so many units in the last place of its parameters.
constexpr double least_share = 1e-10;
constexpr double least_units = 256.0;

CurveError no_direction(double u) {
    return {.code = CurveErrorCode::curve_stands_still, .value = u};
}

bool is_geometric(JoinContinuity continuity) {
    return continuity == JoinContinuity::g1 || continuity == JoinContinuity::g2 || continuity == JoinContinuity::g3;
}

// Chords from the start on, by the parameter at their ends.
struct Walk {
    std::vector<double> parameters{};
    std::vector<double> lengths{};  // of all chords up to there

    explicit Walk(const Curve& curve) {
        const auto p = static_cast<std::size_t>(curve.degree());
        const KnotVector& knots = curve.knots();
        Point last = point_at(curve, curve.domain().lower);
        add(curve.domain().lower, 0.0);
        for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
            if (knots[s] == knots[s + 1]) continue;
            const std::size_t chords = 2 * p + 2;
            for (std::size_t k = 1; k <= chords; ++k) {
                const double share = static_cast<double>(k) / static_cast<double>(chords);
                const double u = k == chords ? knots[s + 1] : knots[s] + share * (knots[s + 1] - knots[s]);
                const Point next = point_at(curve, u);
                add(u, lengths.back() + distance(last, next));
                last = next;
            }
        }
    }

    double length() const { return lengths.back(); }

    double parameter_at(double length) const {
        const auto found = std::ranges::lower_bound(lengths, length);
        if (found == lengths.end() || found == lengths.begin()) return parameters.back();
        const auto i = static_cast<std::size_t>(found - lengths.begin());
        const double share = (length - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
        return parameters[i - 1] + share * (parameters[i] - parameters[i - 1]);
    }

  private:
    void add(double u, double length) {
        parameters.push_back(u);
        lengths.push_back(length);
    }
};

// How far a turn between these directions is on the way to a right angle, at most 1.
double severity(Vector before, Vector after) {
    if (robust_length(before) == 0.0 || robust_length(after) == 0.0) return 0.0;
    return std::min(1.0, std::abs(angle_between(before, after)) / (0.5 * std::numbers::pi));
}

double wanted_length(const Walk& walk, double gap, double severity) {
    const double share = least_share_of_length + further_share_of_length * severity;
    return std::min(walk.length(), std::max(share * walk.length(), gaps_along * gap));
}

// The first joint that is smoother by its shape than by its derivatives: only they survive a change.
std::optional<double> first_geometric_joint(const Curve& curve) {
    for (const JointContinuity& joint : joint_continuity(curve))
        if (joint.kind == JointKind::knot && joint.geometric > joint.parametric) return joint.u;
    return std::nullopt;
}

// The speed of the start; of one that stands still the mean of the part that is changed.
double speed_of_start(const Curve& curve, double speed) {
    if (speed > 0.0) return speed;
    const Walk walk(curve);
    const double length = wanted_length(walk, 0.0, 0.0);
    return length / (walk.parameter_at(length) - curve.domain().lower);
}

// Where the part ends that is as long as wanted.
double end_by_length(const Curve& second, const Walk& walk, double length, double gap) {
    const double end = walk.parameter_at(length);
    const auto joint = first_geometric_joint(second);
    if (!joint || *joint >= end) return end;
    const auto place = std::ranges::lower_bound(walk.parameters, *joint) - walk.parameters.begin();
    return walk.lengths[static_cast<std::size_t>(place)] >= gaps_along * gap ? *joint : end;
}

double least_reach(Interval domain) {
    constexpr double unit = least_units * std::numeric_limits<double>::epsilon();
    return std::max({least_share * domain.length(), unit * std::abs(domain.lower), unit * std::abs(domain.upper)});
}

// A start that is slower than the curve would turn at once if only its velocity were given: so it bends as the first
// curve does.
void bend_slow_start(const Curve& first, const Curve& second, Jet& wanted) {
    const double speed = robust_length(wanted[1]);
    const auto curvature = curvature_at(first, first.domain().upper, Side::left);
    const double own_speed = robust_length(derivatives_at(second, second.domain().lower, 1)[1]);
    if (!curvature || speed >= slow * own_speed) return;
    wanted.derivatives.push_back(*curvature * speed * turned_left(wanted[1]));
}

}  // namespace

int order_of(JoinContinuity continuity) {
    switch (continuity) {
        case JoinContinuity::c0:
            return 0;
        case JoinContinuity::c1:
        case JoinContinuity::g1:
            return 1;
        case JoinContinuity::c2:
        case JoinContinuity::g2:
            return 2;
        case JoinContinuity::g3:
            return 3;
    }
    return 0;
}

// With v = |C'|, its derivatives a and b, the unit tangent t and its normal n: C' = v t, C'' = a t + k v^2 n,
// C''' = (b - k^2 v^3) t + (3 k v a + k' v^3) n for the curvature k and k' = dk/ds.
Result<Jet> start_after(const Passing& side, const Curve& second, int order) {
    Jet wanted{side.point, {}};
    if (order == 0) return wanted;
    const double start = second.domain().lower;
    const auto own_tangent = tangent_at(second, start, Side::right);
    if (!side.direction || !own_tangent) return refuse(no_direction(start));
    const Vector tangent = *side.direction;
    const Vector normal = turned_left(tangent);
    const Jet own = derivatives_at(second, start, order);
    const double own_speed = robust_length(own[1]);
    const double speed =
        speed_of_start(second, own_speed) * (1.0 + further_share_of_speed * severity(*own_tangent, tangent));
    wanted.derivatives.push_back(speed * tangent);
    if (order < 2) return wanted;
    if (!side.curvature) return refuse(no_direction(start));
    const double bend = *side.curvature * speed;
    const double along = dot(own[2], *own_tangent);
    wanted.derivatives.push_back(along * tangent + bend * speed * normal);
    if (order < 3) return wanted;
    if (!side.change) return refuse(no_direction(start));
    const double own_bend = curvature_at(second, start, Side::right).value_or(0.0) * own_speed;
    const double third = dot(own[3], *own_tangent) + own_bend * own_bend * own_speed;
    wanted.derivatives.push_back((third - bend * bend * speed) * tangent +
                                 (3.0 * bend * along + *side.change * speed * speed * speed) * normal);
    return wanted;
}

Result<Jet> wanted_start(const Curve& first, const Curve& second, JoinContinuity continuity) {
    const int order = order_of(continuity);
    if (is_geometric(continuity)) {
        Passing side = passing_at(first, CurveEnd::end);
        side.point = first.control_points().back();
        return start_after(side, second, order);
    }
    Jet wanted = derivatives_at(first, first.domain().upper, order, Side::left);
    wanted.point = first.control_points().back();
    if (continuity == JoinContinuity::c1) bend_slow_start(first, second, wanted);
    return wanted;
}

bool begins_as(const Curve& second, const Jet& wanted) {
    const auto p = static_cast<double>(second.degree());
    const double start = second.domain().lower;
    const KnotVector& knots = second.knots();
    const double span = knots[knots.span_at(start) + 1] - start;
    const Jet found = derivatives_at(second, start, static_cast<int>(wanted.derivatives.size()));
    double missing = distance(found.point, wanted.point);
    double share = 1.0;
    for (std::size_t k = 1; k <= wanted.derivatives.size(); ++k) {
        share *= span / p;
        missing = std::max(missing, share * robust_length(wanted[k] - found[k]));
    }
    double largest = 0.0;
    for (const Point& point : second.control_points())
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
    return missing <= rounding * largest;
}

double end_of_change(const Curve& second, const Jet& wanted) {
    const auto [lower, upper] = second.domain();
    const Walk walk(second);
    const std::size_t order = wanted.derivatives.size();
    const Jet found = derivatives_at(second, lower, static_cast<int>(order));
    const double gap = robust_length(wanted.point - found.point);
    const double length = wanted_length(walk, gap, order >= 1 ? severity(found[1], wanted[1]) : 0.0);
    double reach = end_by_length(second, walk, length, gap) - lower;
    if (order >= 1) {
        const double turn = robust_length(wanted[1] - found[1]);
        if (turn > 0.0) reach = std::min(reach, lengths_astray * length / turn);
    }
    if (order >= 2) {
        const double bend = robust_length(wanted[2] - found[2]);
        const double speed = std::max(robust_length(wanted[1]), robust_length(found[1]));
        if (bend > 0.0 && speed > 0.0) reach = std::min(reach, velocities_astray * speed / bend);
    }
    if (order >= 3) {
        const double jerk = robust_length(wanted[3] - found[3]);
        const double speed = std::max(robust_length(wanted[1]), robust_length(found[1]));
        if (jerk > 0.0 && speed > 0.0) reach = std::min(reach, std::sqrt(2.0 * velocities_astray * speed / jerk));
    }
    reach *= std::max(1.0, static_cast<double>(second.degree()) / even_degree);
    return std::min(upper, lower + std::max(reach, least_reach(second.domain())));
}

}  // namespace batten::core
