#include "core/refine/detail/start_change.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>

#include "core/curve/detail/spline.h"
#include "core/refine/knot_refinement.h"

namespace batten::core {

namespace {

constexpr std::size_t most_values = 3;

// A value and its first two derivatives.
template <class P>
using Values = std::array<P, most_values>;

// The distances from a clamped start to the two knots behind it, of which the first two derivatives are made.
struct StartSpans {
    double p = 0.0;
    double one = 0.0;
    double two = 0.0;

    StartSpans(std::size_t degree, std::span<const double> knots)
        : p(static_cast<double>(degree)),
          one(knots[degree + 1] - knots[degree]),
          two(knots[degree + 2] - knots[degree]) {}
};

// Full multiplicity at the ends of the domain, and where the added spline changes its polynomial: as few places as keep
// two derivatives there.
std::vector<double> knots_of_change(const Curve& curve, std::size_t count, double until) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto [lower, upper] = curve.domain();
    const std::size_t most = p - 2;
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

Values<double> weight_derivatives(const Curve& curve) {
    const auto w = curve.weights();
    const StartSpans spans(static_cast<std::size_t>(curve.degree()), curve.knots().values());
    const double first = spans.p * (w[1] - w[0]) / spans.one;
    const double next = spans.p * (w[2] - w[1]) / spans.two;
    return {w[0], first, (spans.p - 1.0) * (next - first) / spans.one};
}

// What the numerator lacks: with A = w C, dA = w dC, dA' = w' dC + w dC', dA'' = w'' dC + 2 w' dC' + w dC''.
Values<Vector> missing_in_numerator(const Curve& curve, const Jet& wanted) {
    const Jet found = derivatives_at(curve, curve.domain().lower, static_cast<int>(wanted.derivatives.size()));
    Values<Vector> missing{wanted.point - found.point};
    for (std::size_t k = 1; k <= wanted.derivatives.size(); ++k) missing[k] = wanted[k] - found[k];
    const auto w = weight_derivatives(curve);
    return {w[0] * missing[0], w[1] * missing[0] + w[0] * missing[1],
            w[2] * missing[0] + 2.0 * w[1] * missing[1] + w[0] * missing[2]};
}

// The spline with these values at its start whose further control points are 0.
Spline<Vector> change_with(const Values<Vector>& values, std::size_t count, std::vector<double> knots, std::size_t p) {
    const StartSpans spans(p, knots);
    const Vector first_step = values[1] / spans.p;
    const Vector second_step = first_step + values[2] * (spans.one / (spans.p * (spans.p - 1.0)));
    const Values<Vector> points{values[0], values[0] + spans.one * first_step,
                                values[0] + spans.one * first_step + spans.two * second_step};
    Spline<Vector> change{.p = p, .knots = std::move(knots)};
    change.points.assign(change.knots.size() - p - 1, Vector{});
    std::copy_n(points.begin(), count, change.points.begin());
    return change;
}

}  // namespace

Result<Curve> with_start(const Curve& curve, const Jet& wanted, double until) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t count = wanted.derivatives.size() + 1;
    assert(p >= 3 && count <= most_values && curve.domain().lower < until && until <= curve.domain().upper);
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
