#include "core/evaluate/basis_triangle.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace batten::core {

namespace {

using BasisLevel = std::vector<BasisCell>;

// The line that is 0 at one knot and 1 at the other.
BasisRamp ramp(double zero_at, double one_at, double u) {
    if (zero_at == one_at) return {.value = 0.0, .is_void = true};
    return {.value = (u - zero_at) / (one_at - zero_at)};
}

// Far beyond a short support a ramp may be infinite, where the function is zero.
double product(BasisRamp ramp, const BasisCell& cell) {
    return cell.value == 0.0 ? 0.0 : ramp.value * cell.value;
}

BasisLevel first_level(std::size_t i, std::size_t count, std::optional<std::size_t> span) {
    BasisLevel level;
    for (std::size_t j = i; j < i + count; ++j) level.push_back({.index = j, .value = j == span ? 1.0 : 0.0});
    return level;
}

BasisLevel next_level(std::span<const double> u_, const BasisLevel& below, std::size_t k, double u) {
    BasisLevel level;
    for (std::size_t j = 0; j + 1 < below.size(); ++j) {
        const std::size_t i = below[j].index;
        const BasisRamp rising = ramp(u_[i], u_[i + k], u);
        const BasisRamp falling = ramp(u_[i + k + 1], u_[i + 1], u);
        level.push_back({.index = i,
                         .value = product(rising, below[j]) + product(falling, below[j + 1]),
                         .rising = rising,
                         .falling = falling});
    }
    return level;
}

}  // namespace

std::optional<std::size_t> span_of_all(const KnotVector& knots, double u, Side side) {
    if (knots.domain().contains(u)) return knots.span_at(u, side);
    const std::span<const double> values = knots.values();
    if (!(values.front() <= u && u <= values.back())) return std::nullopt;
    const bool from_left = u == values.back() || (side == Side::left && u > values.front());
    const auto upper = from_left ? std::ranges::lower_bound(values, u) : std::ranges::upper_bound(values, u);
    return static_cast<std::size_t>(upper - values.begin()) - 1;
}

BasisTriangle basis_triangle(const KnotVector& knots, std::size_t i, double u, Side side) {
    const auto p = static_cast<std::size_t>(knots.degree());
    assert(i + p + 1 < knots.size() && std::isfinite(u));
    BasisTriangle triangle{.u = u, .levels = {first_level(i, p + 1, span_of_all(knots, u, side))}};
    for (std::size_t k = 1; k <= p; ++k)
        triangle.levels.push_back(next_level(knots.values(), triangle.levels.back(), k, u));
    return triangle;
}

double lower_basis_function(const KnotVector& knots, std::size_t i, int k, double u, Side side) {
    assert(0 <= k && k <= knots.degree() && i + static_cast<std::size_t>(k) + 1 < knots.size());
    const auto top = static_cast<std::size_t>(k);
    BasisLevel level = first_level(i, top + 1, span_of_all(knots, u, side));
    for (std::size_t r = 1; r <= top; ++r) level = next_level(knots.values(), level, r, u);
    return level.front().value;
}

}  // namespace batten::core
