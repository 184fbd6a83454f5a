/// Several spans of a curve side by side, one in each lane of a vector.
#pragma once

#include <algorithm>
#include <array>

#include "core/curve/curve.h"

namespace batten::core {

inline constexpr std::size_t block_size = 8;

/// One number of every span.
struct alignas(64) LaneRow {
    std::array<double, block_size> lanes;

    double& operator[](std::size_t lane) { return lanes[lane]; }
    double operator[](std::size_t lane) const { return lanes[lane]; }
};

/// The most numbers that a TaylorPiece has.
inline constexpr std::size_t most_taylor_numbers = 4 + std::size_t{3} * max_degree;

/// What the curve over each span is made of, and where it is asked for. Every lane must be filled, one or the other may
/// be the same.
struct SpanBlock {
    std::size_t p;
    bool is_rational;
    LaneRow parameters;                                      ///< in the span's closed interval
    std::array<LaneRow, std::size_t{2} * max_degree> knots;  ///< u_{s-p+1}, ..., u_{s+p}
    std::array<LaneRow, max_degree + 1> x;                   ///< of control points s-p, ..., s
    std::array<LaneRow, max_degree + 1> y;                   ///< likewise
    std::array<LaneRow, max_degree + 1> weights;             ///< likewise, where rational

    // The rows are left as they are until they are filled.
    explicit SpanBlock(const Curve& curve)  // NOLINT(cppcoreguidelines-pro-type-member-init)
        : p(static_cast<std::size_t>(curve.degree())), is_rational(curve.is_rational()) {}

    /// Fills one lane by span `s`.
    void read(const Curve& curve, std::size_t s, std::size_t lane);

    /// Fills lane i by span s + i, for every i. Their control points do not go beyond the seam.
    void read_following(const Curve& curve, std::size_t s);
};

/// The points at the parameters, to the last digit or two; not finite where numbers are too large or too small.
void points_of(const SpanBlock& block, std::array<Point, block_size>& points);

/// The numbers of every TaylorPiece about the parameters, one row after the other. `scales` are those of the pieces,
/// which become zero where the sum would lose digits.
void expand(const SpanBlock& block, const LaneRow& scales, std::array<LaneRow, most_taylor_numbers>& numbers);

}  // namespace batten::core
