#include "core/refine/detail/curve_arrays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>

#include "core/curve/detail/known_degree.h"
#include "core/curve/detail/near_share.h"

namespace batten::core {

namespace {

// All of them before the first point changes, so that the compiler may divide several at once.
template <class Count>
std::array<NearShare, max_degree> shares_between(Count count, const double* lower, const double* upper, double u) {
    std::array<NearShare, max_degree> shares;
    for (std::size_t j = 0; j < count; ++j) shares[j] = near_share(lower[j], upper[j], u);
    return shares;
}

// Points whose weights are equal: in the plane.
struct PlanePoints {
    const Point* from;
    Point* to;

    [[gnu::always_inline]] void copy(std::size_t first, std::size_t end, std::size_t place) const {
        copy_run(from, first, end, to, place);
    }
    void repeat(std::size_t i) const { to[i - 1] = to[i]; }
    template <class Count>
    void blend(std::size_t i, Count count, const double* lower, const double* upper, double u) const {
        const auto shares = shares_between(count, lower, upper, u);
        for (std::size_t j = 0; j < count; ++j) to[i - 1 + j] = shares[j].between(&to[i - 1 + j]);
    }
};

// Rational points where they are, with their weights: the shadow of a blend of homogeneous points lies on the leg
// between their shadows, where the weights say.
struct WeightedPoints {
    const Point* from;
    const double* from_weights;
    Point* to;
    double* weights;

    void copy(std::size_t first, std::size_t end, std::size_t place) const {
        copy_run(from, first, end, to, place);
        copy_run(from_weights, first, end, weights, place);
    }
    void repeat(std::size_t i) const {
        to[i - 1] = to[i];
        weights[i - 1] = weights[i];
    }
    template <class Count>
    void blend(std::size_t i, Count count, const double* lower, const double* upper, double u) const {
        const auto shares = shares_between(count, lower, upper, u);
        for (std::size_t j = 0; j < count; ++j) {
            const std::size_t k = i - 1 + j;
            const std::array<WeightedPoint, 2> pair{WeightedPoint{to[k], weights[k]},
                                                    WeightedPoint{to[k + 1], weights[k + 1]}};
            const WeightedPoint point = shares[j].between(pair.data());
            to[k] = point.point;
            weights[k] = point.weight;
        }
    }
};

}  // namespace

CurveArrays arrays_of(const Curve& curve) {
    assert(!curve.is_periodic());
    return {static_cast<std::size_t>(curve.degree()), curve.knots().values(), curve.control_points(), curve.weights(),
            curve.is_rational()};
}

NewCurveArrays refined(const CurveArrays& arrays, std::span<const double> added) {
    assert(std::is_sorted(added.begin(), added.end()));
    assert(added.empty() || (arrays.domain().contains(added.front()) && arrays.domain().contains(added.back())));
    NewCurveArrays to{NewArray<double>(arrays.knots.size() + added.size()),
                      NewArray<Point>(arrays.points.size() + added.size()),
                      NewArray<double>(arrays.points.size() + added.size())};
    to.changed = with_known_degree(arrays.p, [&](auto p) {
        if (arrays.is_rational)
            return insert_ascending(
                p, arrays.knots, added, to.knots.data(),
                WeightedPoints{arrays.points.data(), arrays.weights.data(), to.points.data(), to.weights.data()});
        return insert_ascending(p, arrays.knots, added, to.knots.data(),
                                PlanePoints{arrays.points.data(), to.points.data()});
    });
    if (!arrays.is_rational) std::fill_n(to.weights.data(), to.weights.size(), arrays.weights.front());
    return to;
}

bool are_equal(std::span<const double> weights) {
    return std::adjacent_find(weights.begin(), weights.end(), std::not_equal_to<>()) == weights.end();
}

}  // namespace batten::core
