#include "core/evaluate/basis.h"

#include <cassert>

#include "core/curve/detail/bspline.h"
#include "core/curve/detail/known_degree.h"

namespace batten::core {

namespace {

// How much each local point has in the result. The triangle is read from its apex, where one point has all, back to its
// base, where the shares of the control points are the basis functions. Entries r..p count above level r.
template <class Degree>
using Shares = std::array<double, most_local_points<Degree>>;

// blend_level read backwards: what a point is given on level r is owed to the two points it is blended from.
template <class Degree>
void return_blend_level(Shares<Degree>& shares, const SpanKnots& at, Degree p, std::size_t r, double u) {
    for (std::size_t j = r; j <= p; ++j) {
        const Ratio ratio = at.ratio(j, r, u);
        shares[j - 1] += ratio.lower_share * shares[j];
        shares[j] *= ratio.upper_share;
    }
}

// differentiate_level read backwards.
template <class Degree>
void return_differentiate_level(Shares<Degree>& shares, const SpanKnots& at, Degree p, std::size_t r) {
    for (std::size_t j = r; j <= p; ++j) {
        shares[j] *= static_cast<double>(p - r + 1) / (at.upper(j, r) - at.lower(j));
        shares[j - 1] -= shares[j];
    }
}

template <class Degree>
void differentiate(BasisRow& row, Shares<Degree> shares, const SpanKnots& at, Degree p, std::size_t times) {
    for (std::size_t r = times; r >= 1; --r) return_differentiate_level(shares, at, p, r);
    row.assign(std::span<const double>(shares).first(p + 1));
}

// The k-th derivative differentiates on levels 1..k and blends on those above, which the lower derivatives share.
template <class Degree>
[[gnu::flatten]] BasisValues basis_of_degree(const SpanKnots& at, Degree p, double u, std::size_t count) {
    Shares<Degree> shares{};
    shares[p] = 1.0;
    BasisValues result{.span = at.s, .derivatives = ShortList<BasisRow, 1>(count + 1)};
    for_each_level(p, p, [&](auto level) {
        const std::size_t k = p + 1 - level;
        if (k <= count) differentiate(result.derivatives[k], shares, at, p, k);
        return_blend_level(shares, at, p, k, u);
    });
    differentiate(result.derivatives[0], shares, at, p, 0);
    for (std::size_t k = p + 1; k <= count; ++k) differentiate(result.derivatives[k], Shares<Degree>{}, at, p, 0);
    return result;
}

}  // namespace

BasisValues basis_functions(const KnotVector& knots, double u, int derivative_count, Side side) {
    assert(derivative_count >= 0);
    const auto [inside, at] = located(knots, u, side);
    return with_known_degree(at.p, [u = inside, &at = at, derivative_count](auto p) {
        return basis_of_degree(at, p, u, static_cast<std::size_t>(derivative_count));
    });
}

double basis_function(const KnotVector& knots, std::size_t i, double u) {
    assert(knots.is_periodic() || i < knots.control_point_count());
    if (!knots.is_periodic() && !knots.domain().contains(u)) return 0.0;
    const auto [inside, at] = located(knots, u, Side::right);
    // Only a periodic vector has more local points than it has control points to tell apart.
    const std::size_t n = knots.control_point_count();
    LocalPoints<double> points{};
    for (std::size_t j = 0; j <= at.p; ++j) points[j] = (at.s - at.p + j) % n == i % n ? 1.0 : 0.0;
    return de_boor(points, at, inside);
}

Interval basis_support(const KnotVector& knots, std::size_t i) {
    assert(knots.is_periodic() || i < knots.control_point_count());
    const auto p = static_cast<std::size_t>(knots.degree());
    const Interval domain = knots.domain();
    if (!knots.is_periodic()) return {domain.clamp(knots[i]), domain.clamp(knots[i + p + 1])};
    const std::size_t n = knots.control_point_count();
    std::size_t repetition = i % n;
    while (repetition < p) repetition += n;
    return {knots[repetition], knots[repetition + p + 1]};
}

}  // namespace batten::core
