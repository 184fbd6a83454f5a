#include "core/measure/detail/one_side.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve/control_box.h"
#include "core/curve/detail/bspline.h"
#include "core/evaluate/tangent.h"

namespace batten::core {

namespace {

// The points' rounding of a few units, carried through the derivatives.
JetNoise noise_of_derivatives(const Curve& curve, double rounding, double u, Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    LocalPoints<double> errors{};
    LocalPoints<double> weights{};
    for (std::size_t j = 0; j <= at.p; ++j) {
        weights[j] = curve.weights()[(at.s - at.p + j) % curve.weights().size()];
        errors[j] = rounding * weights[j];
    }
    const double weight = de_boor(weights, at, inside);
    JetNoise noise{rounding};
    for (std::size_t r = 1; r <= std::min<std::size_t>(derivatives_of_side, at.p); ++r) {
        const auto factor = static_cast<double>(at.p - r + 1);
        for (std::size_t j = at.p; j >= r; --j)
            errors[j] = factor / (at.upper(j, r) - at.lower(j)) * (errors[j] + errors[j - 1]);
        noise[r] = *std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(r),
                                     errors.begin() + static_cast<std::ptrdiff_t>(at.p) + 1) /
                   weight;
    }
    return noise;
}

// The piece of the span in which `u` lies alone: what lies elsewhere costs nothing.
Curve piece_at(const Curve& curve, double u, Side side) {
    const SpanKnots at = located(curve.knots(), u, side).at;
    const auto knots = at.knots.subspan(at.s - at.p, 2 * at.p + 2);
    std::vector<Point> points;
    std::vector<double> weights;
    for (std::size_t i = at.s - at.p; i <= at.s; ++i) {
        points.push_back(curve.control_points()[i % curve.control_points().size()]);
        weights.push_back(curve.weights()[i % curve.weights().size()]);
    }
    return Curve::make({.degree = curve.degree(),
                        .knots = {knots.begin(), knots.end()},
                        .points = std::move(points),
                        .weights = std::move(weights),
                        .tears = Tears::allow})
        .value();
}

}  // namespace

double rounding_in(const Box& box) {
    return 2.0 * std::numeric_limits<double>::epsilon() *
           std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
}

OneSide look_at_side(const Curve& curve, double u, Side side, Point origin, double rounding) {
    const Curve piece = seen_from(piece_at(curve, u, side), origin);
    const double inside = curve.knots().into_domain(u, side);
    return {.jet = derivatives_at(piece, inside, derivatives_of_side, side),
            .noise = noise_of_derivatives(piece, rounding, inside, side),
            .tangent = tangent_at(piece, inside, side),
            .curvature = curvature_at(piece, inside, side)};
}

}  // namespace batten::core
