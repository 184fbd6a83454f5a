#include "core/measure/curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve/detail/span_range.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/cusps.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

// A zero of the curvature and a cusp nearer than this part of the cusp's span are one place.
constexpr double same_place = 1e-6;

using Forms = std::span<const Bernstein>;

// det(A, A^(i), A^(j)) of the homogeneous piece.
Bernstein determinant(Forms forms, std::size_t i, std::size_t j) {
    const auto minor = [&](std::size_t row, std::size_t other) {
        return difference(product(forms[3 * i + row], forms[3 * j + other]),
                          product(forms[3 * i + other], forms[3 * j + row]));
    };
    return sum(product(forms[0], minor(1, 2)), sum(product(forms[1], minor(2, 0)), product(forms[2], minor(0, 1))));
}

// det(A, A', A'') = W^3 det(C', C'').
Bernstein bend(Forms forms) {
    return determinant(forms, 1, 2);
}

// With N = det(A, A', A''), H the hodograph times W^2 and S = H . H the curvature is N W^3 / S^(3/2), so its derivative
// has the sign of (N' W + 3 N W') S - (3/2) N W S', where N' = det(A, A', A''') and S' / 2 = H . H'.
Bernstein change_of_curvature(Forms forms) {
    const Bernstein n = bend(forms);
    const Bernstein n_slope = determinant(forms, 1, 3);
    const Bernstein x = hodograph_x(forms);
    const Bernstein y = hodograph_y(forms);
    const Bernstein x_slope = difference(product(forms[6], forms[2]), product(forms[0], forms[8]));
    const Bernstein y_slope = difference(product(forms[7], forms[2]), product(forms[1], forms[8]));
    const Bernstein squared = sum(product(x, x), product(y, y));
    const Bernstein half_slope = sum(product(x, x_slope), product(y, y_slope));
    const Bernstein rise = sum(product(n_slope, forms[2]), scaled(product(n, forms[5]), 3.0));
    return difference(product(rise, squared), scaled(product(product(n, forms[2]), half_slope), 3.0));
}

// Intervals that can be asked whether one of them meets another interval. Cost of a question: one binary search.
class Places {
  public:
    explicit Places(std::vector<Interval> intervals) : intervals_(std::move(intervals)) {
        std::ranges::sort(intervals_, {}, &Interval::lower);
        double farthest = -std::numeric_limits<double>::infinity();
        for (const Interval& interval : intervals_) farthest_.push_back(farthest = std::max(farthest, interval.upper));
    }

    bool any_meets(Interval where) const {
        const auto behind = std::ranges::upper_bound(intervals_, where.upper, {}, &Interval::lower);
        const auto count = static_cast<std::size_t>(behind - intervals_.begin());
        return count > 0 && farthest_[count - 1] >= where.lower;
    }

  private:
    std::vector<Interval> intervals_;  // by their lower ends
    std::vector<double> farthest_;     // the greatest upper end up to each
};

// The corners, gaps and cusps, and the same a period later.
std::vector<Interval> rough_places(const Curve& curve, const std::vector<JointContinuity>& joints) {
    std::vector<Interval> places;
    for (const JointContinuity& joint : joints)
        if (joint.geometric < 1) places.push_back({joint.u, joint.u});
    for (const Cusp& cusp : cusps(curve)) {
        if (cusp.turn && std::abs(*cusp.turn) <= ContinuityTolerances{}.angle) continue;
        const std::size_t span = curve.knots().span_at(cusp.u);
        const double margin = same_place * (curve.knots()[span + 1] - curve.knots()[span]);
        places.push_back({cusp.where.lower - margin, cusp.where.upper + margin});
    }
    const double period = curve.domain().length();
    const std::size_t count = places.size();
    for (std::size_t i = 0; i < count; ++i) places.push_back({places[i].lower + period, places[i].upper + period});
    return places;
}

// What is known of a curve before its changes of bending are sought.
class Smoothness {
  public:
    explicit Smoothness(const Curve& curve)
        : curve_(curve), joints_(joint_continuity(curve)), rough_(rough_places(curve, joints_)) {
        for (const JointContinuity& joint : joints_)
            if (joint.geometric == 1 && joint.before && joint.after) jumps_.push_back(joint);
        std::ranges::stable_sort(jumps_, {}, &JointContinuity::u);
    }

    // Whether what is at the end goes on at the beginning without a corner.
    bool is_cyclic() const {
        return curve_.is_periodic() ||
               (!joints_.empty() && joints_.back().kind == JointKind::ends && joints_.back().geometric >= 1);
    }

    // Both one-sided curvatures where the curvature jumps.
    const JointContinuity* jump_at(double u) const {
        const auto jump = std::ranges::lower_bound(jumps_, u, {}, &JointContinuity::u);
        return jump != jumps_.end() && jump->u == u ? &*jump : nullptr;
    }

    double middle(Interval where) const {
        const double u = where.lower + 0.5 * where.length();
        return u > curve_.domain().upper ? u - curve_.domain().length() : u;
    }

    // The changes of sign of `expression` at smooth places.
    std::vector<SignEvent> changes(int order, const Expression& expression) const {
        auto events = sign_events(sign_runs_along(curve_, order, expression), is_cyclic());
        std::erase_if(events,
                      [&](const SignEvent& event) { return !event.is_change() || rough_.any_meets(event.where); });
        return events;
    }

  private:
    const Curve& curve_;
    std::vector<JointContinuity> joints_;
    Places rough_;
    std::vector<JointContinuity> jumps_;
};

// The most extreme of the one-sided curvatures at the ends of `where` and in its middle.
std::optional<double> extreme_curvature(const Curve& curve, Interval where, double u, bool is_maximum) {
    std::optional<double> extreme;
    const Interval domain = curve.domain();
    const auto offer = [&](double parameter, Side side) {
        const auto found = curvature_at(curve, parameter, side);
        if (found && (!extreme || (is_maximum ? *found > *extreme : *found < *extreme))) extreme = found;
    };
    const double upper = where.upper > domain.upper ? where.upper - domain.length() : where.upper;
    const bool is_seam = where.lower == domain.lower && where.length() == 0.0;
    offer(is_seam ? domain.upper : where.lower, Side::left);
    offer(where.lower, Side::right);
    offer(u, Side::right);
    offer(upper, Side::left);
    return extreme;
}

// The non-empty span before or after `span`, itself where there is none in the domain.
std::size_t neighbor_before(const KnotVector& knots, std::size_t span) {
    const double u = knots[span];
    return u > knots.domain().lower ? knots.span_at(u, Side::left) : span;
}

std::size_t neighbor_after(const KnotVector& knots, std::size_t span) {
    const double u = knots[span + 1];
    return u < knots.domain().upper ? knots.span_at(u, Side::right) : span;
}

// What `find` finds within `range`: in the whole curve where it takes all of it, else in the spans around.
template <class Find>
auto found_within(const Curve& curve, Interval range, Find find) {
    const KnotVector& knots = curve.knots();
    const std::size_t first = neighbor_before(knots, knots.span_at(range.lower));
    const std::size_t last = neighbor_after(knots, knots.span_at(range.upper, Side::left));
    const bool is_all = knots[first] == knots.domain().lower && knots[last + 1] == knots.domain().upper;
    auto found = is_all ? find(curve) : find(curve_over_spans(curve, first, last));
    std::erase_if(found, [&](const auto& place) { return !range.contains(place.u); });
    return found;
}

}  // namespace

std::optional<Bending> bending_at(const Curve& curve, double u, Side side) {
    const auto curvature = curvature_at(curve, u, side);
    if (!curvature) return std::nullopt;
    const auto derivatives = derivatives_at(curve, u, 3, side);
    const double speed = robust_length(derivatives[1]);
    const Vector tangent = derivatives[1] / speed;
    const double change = (cross(tangent, derivatives[3]) -
                           3.0 * cross(tangent, derivatives[2]) * (dot(tangent, derivatives[2]) / speed)) /
                          speed / speed;
    if (!std::isfinite(change)) return std::nullopt;
    return Bending{*curvature, change, change / speed};
}

std::optional<OsculatingCircle> osculating_circle(const Curve& curve, double u, Side side) {
    const auto curvature = curvature_at(curve, u, side);
    if (!curvature || *curvature == 0.0) return std::nullopt;
    const Jet at = derivatives_at(curve, u, 1, side);
    const Vector normal = turned_left(at[1] / robust_length(at[1]));
    const Point center = at.point + normal / *curvature;
    if (!is_finite(center)) return std::nullopt;
    return OsculatingCircle{center, 1.0 / std::abs(*curvature)};
}

std::vector<Inflection> inflections(const Curve& curve) {
    const Smoothness smoothness(curve);
    std::vector<Inflection> result;
    for (const SignEvent& event : smoothness.changes(2, bend)) {
        const double u = smoothness.middle(event.where);
        const JointContinuity* jump = event.where.length() == 0.0 ? smoothness.jump_at(u) : nullptr;
        result.push_back({event.where, u, point_at(curve, u), jump != nullptr && *jump->before * *jump->after < 0.0});
    }
    return result;
}

std::vector<Inflection> inflections_within(const Curve& curve, Interval range) {
    return found_within(curve, range, inflections);
}

std::vector<CurvatureExtremum> curvature_extrema(const Curve& curve) {
    const Smoothness smoothness(curve);
    std::vector<CurvatureExtremum> result;
    for (const SignEvent& event : smoothness.changes(3, change_of_curvature)) {
        const double u = smoothness.middle(event.where);
        const bool is_maximum = event.before > 0;
        if (const auto curvature = extreme_curvature(curve, event.where, u, is_maximum))
            result.push_back({event.where, u, point_at(curve, u), *curvature, is_maximum});
    }
    return result;
}

std::vector<CurvatureExtremum> curvature_extrema_within(const Curve& curve, Interval range) {
    return found_within(curve, range, curvature_extrema);
}

}  // namespace batten::core
