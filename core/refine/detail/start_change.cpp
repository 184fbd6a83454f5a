#include "core/refine/detail/start_change.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>

#include "core/base/detail/binomial.h"
#include "core/curve/detail/spline.h"
#include "core/refine/knot_refinement.h"

namespace batten::core {

namespace {

constexpr std::size_t most_values = 4;

// A value and its first three derivatives.
template <class P>
using Values = std::array<P, most_values>;

// How many derivatives stay equal where the added spline changes its polynomial.
std::size_t kept_derivatives(std::size_t count) {
    return std::max<std::size_t>(2, count - 1);
}

// Full multiplicity at the ends of the domain, and where the added spline changes its polynomial: as few places as keep
// these derivatives there.
std::vector<double> knots_of_change(const Curve& curve, std::size_t count, double until) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto [lower, upper] = curve.domain();
    const std::size_t most = p - kept_derivatives(count);
    const std::size_t places = (count + most - 1) / most;
    std::vector<double> knots(p + 1, lower);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = places - (count - 1 - i) / most;
        const double share = static_cast<double>(place) / static_cast<double>(places);
        const double u = place == places ? until : lower + share * (until - lower);
        if (u < upper) knots.push_back(u);
    }
    knots.insert(knots.end(), p + 1, upper);
    return knots;
}

// The factor of point i of derivative r, of a spline of degree p that begins clamped: its next derivative there is the
// factor times the difference of the points i and i + 1.
double step_factor(std::size_t p, std::span<const double> knots, std::size_t r, std::size_t i) {
    return static_cast<double>(p - r) / (knots[i + p + 1] - knots[i + r + 1]);
}

// The value and the derivatives at the start of the first `count` control points, and those of such values.
template <class P>
Values<P> derivatives_of(Values<P> points, std::size_t count, std::size_t p, std::span<const double> knots) {
    for (std::size_t r = 0; r + 1 < count; ++r)
        for (std::size_t i = count - 1; i > r; --i)
            points[i] = step_factor(p, knots, r, i - r - 1) * (points[i] - points[i - 1]);
    return points;
}
template <class P>
Values<P> points_with(Values<P> derivatives, std::size_t count, std::size_t p, std::span<const double> knots) {
    for (std::size_t r = count - 1; r-- > 0;)
        for (std::size_t i = r + 1; i < count; ++i)
            derivatives[i] = derivatives[i - 1] + derivatives[i] / step_factor(p, knots, r, i - r - 1);
    return derivatives;
}

Values<double> weight_derivatives(const Curve& curve, std::size_t count) {
    Values<double> weights{};
    std::copy_n(curve.weights().begin(), count, weights.begin());
    return derivatives_of(weights, count, static_cast<std::size_t>(curve.degree()), curve.knots().values());
}

// What the numerator A = w C lacks: dA^(k) = sum of binomial(k, j) w^(k-j) dC^(j).
Values<Vector> missing_in_numerator(const Curve& curve, const Jet& wanted) {
    const std::size_t count = wanted.derivatives.size() + 1;
    const Jet found = derivatives_at(curve, curve.domain().lower, static_cast<int>(wanted.derivatives.size()));
    Values<Vector> missing{wanted.point - found.point};
    for (std::size_t k = 1; k < count; ++k) missing[k] = wanted[k] - found[k];
    const auto w = weight_derivatives(curve, count);
    Values<Vector> numerator{};
    for (std::size_t k = 0; k < count; ++k) {
        double binomial = 1.0;
        for (std::size_t j = 0; j <= k; ++j) {
            if (j > 0) binomial = next_binomial(binomial, k, j);
            numerator[k] += binomial * w[k - j] * missing[j];
        }
    }
    return numerator;
}

// The spline with these values at its start whose further control points are 0.
Spline<Vector> change_with(const Values<Vector>& values, std::size_t count, std::vector<double> knots, std::size_t p) {
    const Values<Vector> points = points_with(values, count, p, knots);
    Spline<Vector> change{.p = p, .knots = std::move(knots)};
    change.points.assign(change.knots.size() - p - 1, Vector{});
    std::copy_n(points.begin(), count, change.points.begin());
    return change;
}

}  // namespace

Result<Curve> with_start(const Curve& curve, const Jet& wanted, double until) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t count = wanted.derivatives.size() + 1;
    assert(curve.degree() >= least_degree_of_change(wanted.derivatives.size()) && count <= most_values);
    assert(curve.domain().lower < until && until <= curve.domain().upper);
    const std::vector<double> own = knots_of_change(curve, count, until);
    std::vector<double> all;
    std::ranges::set_union(own, curve.knots().values(), std::back_inserter(all));
    Result<Curve> result = refine_knots(curve, missing_knots(all, curve.knots().values()));
    // The second time for what rounding left of the first.
    for (int pass = 0; pass < 2 && result; ++pass) {
        Spline<Vector> change = change_with(missing_in_numerator(*result, wanted), count, own, p);
        insert_ascending<Vector>(change, missing_knots(all, own));
        CurveDefinition definition = result->definition();
        for (std::size_t i = 0; i < change.points.size(); ++i)
            definition.points[i] += change.points[i] / definition.weights[i];
        definition.points.front() = wanted.point;
        result = Curve::make(std::move(definition));
    }
    return result;
}

}  // namespace batten::core
