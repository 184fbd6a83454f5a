/// Bézier points of one span after the other, for every point type.
#pragma once

#include <array>
#include <span>
#include <type_traits>

#include "core/base/degree_range.h"
#include "core/curve/detail/near_share.h"

namespace batten::core {

/// Room for the points of one span.
template <class Degree>
constexpr std::size_t capacity_for(Degree) {
    if constexpr (std::is_same_v<Degree, std::size_t>)
        return max_degree + 1;
    else
        return Degree::value + 1;
}

/// Goes along the knots from right to left and makes of the p+1 points of every span those of its piece. Before that
/// they are b(u_{s-p+j+1}, ..., u_s, b, ..., b), j = 0..p, over the span from u_s to b = u_{s+1}. `load(i)` gives
/// control point i of the unrolled curve. Cost: (p-m)(p-m+1)/2 combinations for a span whose left end has multiplicity
/// m. Source: The NURBS Book, A5.6.
template <class P, class Degree, class Load>
class Decomposition {
  public:
    Decomposition(Degree p, std::span<const double> knots, std::size_t last_span, Load load)
        : p_(p), knots_(knots), s_(last_span), load_(load) {
        load_until(p_ + 1);
        raise_right_end();
    }

    /// The index of the next piece's span.
    std::size_t span() const { return s_; }

    /// Hands the points of the next piece and the multiplicity of the knot at its left end to `emit_piece`.
    template <class Emit>
    void emit(bool is_first, Emit emit_piece) {
        const double a = knots_[s_];
        std::size_t multiplicity = 1;
        while (multiplicity <= p_ && multiplicity <= s_ && knots_[s_ - multiplicity] == a) ++multiplicity;
        if (multiplicity == 1)
            emit_with(std::integral_constant<std::size_t, 1>(), is_first, emit_piece);
        else
            emit_with(multiplicity, is_first, emit_piece);
    }

  private:
    using Points = std::array<P, capacity_for(Degree())>;

    void load_until(std::size_t end) {
        for (std::size_t j = 0; j < end; ++j) points_[j] = load_(s_ - p_ + j);
    }

    // On level r point j exchanges u_{s+1+j-r} for b.
    void raise_right_end() {
        const double b = knots_[s_ + 1];
        for (std::size_t r = 1; r <= p_; ++r)
            for (std::size_t j = p_; j >= r; --j) {
                const double upper = knots_[s_ + 1 + j - r];
                if (b < upper) points_[j] = near_share(knots_[s_ - p_ + j], upper, b).between(&points_[j - 1]);
            }
    }

    // The left end, a knot of multiplicity m, becomes one of p: on level r point k exchanges u_{s-p+k+r} for it, and
    // the first one is left to the next span: there it is number m+r.
    template <class Multiplicity, class Emit>
    void emit_with(Multiplicity m, bool is_first, Emit emit_piece) {
        std::array<NearShare, capacity_for(Degree())> shares;
        Points next;
        for (std::size_t i = 1; i + m <= p_; ++i)
            shares[i] = near_share(knots_[s_ - p_ + i], knots_[s_ + 1], knots_[s_]);
        if (m <= p_) next[m] = points_[0];
        for (std::size_t r = 1; r + m <= p_; ++r) {
            for (std::size_t k = 0; k + r + m <= p_; ++k) points_[k] = shares[k + r].between(&points_[k]);
            next[m + r] = points_[0];
        }
        emit_piece(points_, static_cast<std::size_t>(m));
        if (is_first) return;
        s_ -= m;
        for (std::size_t j = m; j <= p_; ++j) points_[j] = next[j];
        load_until(m);
    }

    Degree p_;
    std::span<const double> knots_;
    std::size_t s_;
    Load load_;
    Points points_;
};

}  // namespace batten::core
