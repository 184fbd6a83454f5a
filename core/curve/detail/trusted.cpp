#include "core/curve/detail/trusted.h"

#include <cassert>

namespace batten::core {

namespace {

// What the checks say of a curve that was made without them.
[[maybe_unused]] bool is_what_make_makes(const Curve& curve) {
    return Curve::make(curve.definition()) == curve;
}

[[maybe_unused]] bool is_what_make_makes(const KnotVector& knots) {
    const std::vector<double> stored(knots.stored().begin(), knots.stored().end());
    return knots == (knots.is_periodic() ? KnotVector::make_periodic(knots.degree(), stored, knots.kind())
                                         : KnotVector::make(knots.degree(), stored, knots.kind(), Tears::allow));
}

}  // namespace

KnotVector Trusted::knots(int degree, bool is_periodic, KnotKind kind, std::vector<double> values) {
    KnotVector knots(degree, is_periodic, kind, SharedArray(std::move(values)));
    assert(is_what_make_makes(knots));
    return knots;
}

KnotVector Trusted::knots_of_kind_or_custom(int degree, bool is_periodic, KnotKind kind, SharedArray<double> values) {
    KnotVector knots = KnotVector::of_kind_or_custom(degree, is_periodic, kind, std::move(values));
    assert(is_what_make_makes(knots));
    return knots;
}

Curve Trusted::curve(KnotVector knots, std::vector<Point> points, std::vector<double> weights, bool is_rational) {
    return curve(std::move(knots), SharedArray(std::move(points)), SharedArray(std::move(weights)), is_rational);
}

Curve Trusted::curve(KnotVector knots, SharedArray<Point> points, SharedArray<double> weights, bool is_rational) {
    Curve curve(std::move(knots), std::move(points), std::move(weights), is_rational);
    assert(is_what_make_makes(curve));
    return curve;
}

Curve Trusted::with_points(const Curve& curve, std::vector<Point> points) {
    Curve changed(curve.knots_, SharedArray(std::move(points)), curve.weights_, curve.is_rational_);
    assert(is_what_make_makes(changed));
    return changed;
}

}  // namespace batten::core
