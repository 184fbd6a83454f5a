#include "core/refine/join.h"

#include <cmath>
#include <utility>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/deviation.h"
#include "core/refine/bezier_form.h"
#include "core/refine/clamping.h"
#include "core/refine/degree.h"
#include "core/refine/knot_removal.h"
#include "core/refine/reparametrize.h"

namespace batten::core {

namespace {

// How many derivatives must agree.
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
    }
    return 0;
}

bool is_geometric(JoinContinuity continuity) {
    return continuity == JoinContinuity::g1 || continuity == JoinContinuity::g2;
}

// Both clamped where they meet, of equal degree, their domains one after the other.
struct Pair {
    Curve first;
    Curve second;
};

Result<Pair> prepared(const Curve& first, const Curve& second, int order) {
    auto a = clamp(first, CurveEnd::end);
    auto b = clamp_ends(second);
    const auto needs_points = static_cast<std::size_t>(order) + 2;
    const auto raise_to = [](Result<Curve>& curve, int degree) {
        if (curve && curve->degree() < degree) curve = elevate_degree(*curve, degree - curve->degree());
    };
    if (a && b) {
        raise_to(b, std::max(a->degree(), order));
        while (b && b->control_points().size() < needs_points) raise_to(b, b->degree() + 1);
        if (b) raise_to(a, b->degree());
    }
    if (a && b) b = shift_domain(*b, a->domain().upper);
    if (!a) return refuse(a.error());
    if (!b) return refuse(b.error());
    return Pair{*std::move(a), *std::move(b)};
}

// The first control points of a clamped curve, as seen from its first one, and what its derivatives there are made of.
class Beginning {
  public:
    explicit Beginning(const Curve& curve)
        : p_(static_cast<double>(curve.degree())), weights_(curve.weights()), knots_(curve.knots()) {
        const auto p = static_cast<std::size_t>(curve.degree());
        first_span_ = knots_[p + 1] - knots_[p];
        two_spans_ = knots_[p + 2] - knots_[p];
    }

    // P1 - P0 for the velocity C', and back.
    Vector leg_of(Vector velocity) const { return velocity * (first_span_ * weights_[0] / (p_ * weights_[1])); }
    Vector velocity_of(Vector leg) const { return leg * (p_ * weights_[1] / (first_span_ * weights_[0])); }

    // P2 - P0 for the acceleration C'', given P1 - P0: with A = w (C - P0), w0 C'' = A'' - 2 w' C' and
    // A'' = p (p-1) / u_1 ((A2 - A1) / u_2 - A1 / u_1).
    Vector second_of(Vector acceleration, Vector leg) const {
        const Vector lifted_leg = weights_[1] * leg;
        const Vector lifted = weights_[0] * acceleration + 2.0 * weight_rate() * velocity_of(leg);
        const Vector step = lifted * (first_span_ / (p_ * (p_ - 1.0))) + lifted_leg / first_span_;
        return (lifted_leg + two_spans_ * step) / weights_[2];
    }
    Vector acceleration_of(Vector second, Vector leg) const {
        const Vector lifted_leg = weights_[1] * leg;
        const Vector step = (weights_[2] * second - lifted_leg) / two_spans_ - lifted_leg / first_span_;
        return (step * (p_ * (p_ - 1.0) / first_span_) - 2.0 * weight_rate() * velocity_of(leg)) / weights_[0];
    }

  private:
    double weight_rate() const { return p_ * (weights_[1] - weights_[0]) / first_span_; }

    double p_;
    std::span<const double> weights_;
    const KnotVector& knots_;
    double first_span_ = 0.0;
    double two_spans_ = 0.0;
};

CurveError stands_still(double u) {
    return {.code = CurveErrorCode::curve_stands_still, .value = u};
}

// Moves P1 and P2 for C1 and C2.
void match_derivatives(std::vector<Point>& points, const Pair& pair, int order) {
    const Beginning beginning(pair.second);
    const auto derivatives = derivatives_at(pair.first, pair.first.domain().upper, order, Side::left);
    if (order < 1) return;
    const Vector leg = beginning.leg_of(derivatives[1]);
    points[1] = points[0] + leg;
    if (order == 2) points[2] = points[0] + beginning.second_of(derivatives[2], leg);
}

// Moves P1 and P2 for G1 and G2.
Result<void> match_geometry(std::vector<Point>& points, const Pair& pair, int order) {
    const double joint = pair.first.domain().upper;
    const Beginning beginning(pair.second);
    const auto tangent = tangent_at(pair.first, joint, Side::left);
    const auto old = pair.second.control_points();
    const double leg_length = distance(old[0], old[1]);
    if (!tangent || leg_length == 0.0) return refuse(stands_still(joint));
    const Vector leg = leg_length * *tangent;
    points[1] = points[0] + leg;
    if (order < 2) return {};
    const auto curvature = curvature_at(pair.first, joint, Side::left);
    if (!curvature) return refuse(stands_still(joint));
    const Vector normal = turned_left(*tangent);
    const double speed = length(beginning.velocity_of(leg));
    const Vector found = beginning.acceleration_of(points[2] - points[0], leg);
    const double missing = *curvature * speed * speed - dot(found, normal);
    points[2] = points[0] + beginning.second_of(found + missing * normal, leg);
    return {};
}

Result<Curve> matched(const Pair& pair, JoinContinuity continuity) {
    CurveDefinition definition = pair.second.definition();
    definition.points[0] = pair.first.control_points().back();
    const int order = order_of(continuity);
    if (is_geometric(continuity)) {
        if (const auto done = match_geometry(definition.points, pair, order); !done) return refuse(done.error());
    } else {
        match_derivatives(definition.points, pair, order);
    }
    return Curve::make(std::move(definition));
}

// What rounding may leave in the points of a curve.
double rounding_of(const Curve& curve) {
    const Box box = control_box(curve);
    const double size = std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x),
                                  std::abs(box.upper.y), std::numeric_limits<double>::min()});
    return 1e-13 * size;
}

Result<Curve> smoothed(const Curve& curve, double joint, int times) {
    if (times == 0) return curve;
    return remove_knot(curve, joint, times, rounding_of(curve)).map([](const KnotRemoval& removal) {
        return removal.curve;
    });
}

}  // namespace

Result<JoinedCurve> join(const Curve& first, const Curve& second, JoinContinuity continuity) {
    const int order = order_of(continuity);
    const auto pair = prepared(first, second, order);
    if (!pair) return refuse(pair.error());
    const auto changed = matched(*pair, continuity);
    if (!changed) return refuse(changed.error());
    const double error = largest_deviation(pair->second, *changed);
    return Curve::make(concatenated(pair->first.definition(), changed->definition()))
        .and_then([&](const Curve& joined) {
            return smoothed(joined, pair->first.domain().upper, is_geometric(continuity) ? 0 : order);
        })
        .map([&](const Curve& joined) {
            return JoinedCurve{joined, error};
        });
}

}  // namespace batten::core
