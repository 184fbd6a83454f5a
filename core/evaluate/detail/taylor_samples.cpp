#include "core/evaluate/detail/taylor_samples.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/detail/taylor_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Compiled once for each kind of processor.
HWY_BEFORE_NAMESPACE();
namespace batten::core::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Lanes = hn::Vec<Doubles>;

HWY_INLINE Lanes all(double value) {
    return hn::Set(Doubles(), value);
}

// So many vectors at once, as a sum waits for the one before it.
constexpr std::size_t vectors_at_once = 2;

template <std::size_t Count>
using Vectors = std::array<Lanes, Count>;

template <std::size_t Count>
struct PointLanes {
    Vectors<Count> x;
    Vectors<Count> y;
};

template <std::size_t Count>
HWY_INLINE void multiply_add(Vectors<Count>& sums, const Vectors<Count>& factors, double term) {
    for (std::size_t i = 0; i < Count; ++i) sums[i] = hn::MulAdd(sums[i], factors[i], all(term));
}

template <std::size_t Count>
HWY_INLINE Vectors<Count> copies_of(double value) {
    Vectors<Count> copies;
    copies.fill(all(value));
    return copies;
}

// By Horner's rule. A degree known to the compiler unrolls the loop.
template <std::size_t Count, class Degree>
HWY_INLINE PointLanes<Count> polynomial_points(const TaylorPiece& piece, Degree p, const Vectors<Count>& t) {
    const double* c = piece.point() + 2 * p;
    PointLanes<Count> sum{copies_of<Count>(c[0]), copies_of<Count>(c[1])};
    for (std::size_t k = p; k-- > 0;) {
        c -= 2;
        multiply_add(sum.x, t, c[0]);
        multiply_add(sum.y, t, c[1]);
    }
    return sum;
}

template <std::size_t Count, class Degree>
HWY_INLINE PointLanes<Count> rational_points(const TaylorPiece& piece, Degree p, const Vectors<Count>& t) {
    const double* c = piece.terms() + 3 * (p - 1);
    PointLanes<Count> sum{copies_of<Count>(c[0]), copies_of<Count>(c[1])};
    Vectors<Count> weight = copies_of<Count>(c[2]);
    for (std::size_t k = p; k-- > 1;) {
        c -= 3;
        multiply_add(sum.x, t, c[0]);
        multiply_add(sum.y, t, c[1]);
        multiply_add(weight, t, c[2]);
    }
    multiply_add(weight, t, 1.0);
    for (std::size_t i = 0; i < Count; ++i) weight[i] = hn::Div(t[i], weight[i]);
    multiply_add(sum.x, weight, piece.point()[0]);
    multiply_add(sum.y, weight, piece.point()[1]);
    return sum;
}

// How many of the first lanes of `u` lie in the interval.
HWY_INLINE std::size_t count_inside(Lanes u, Interval interval) {
    const auto is_inside = hn::And(hn::Ge(u, all(interval.lower)), hn::Lt(u, all(interval.upper)));
    const intptr_t first_outside = hn::FindFirstTrue(Doubles(), hn::Not(is_inside));
    return first_outside < 0 ? hn::Lanes(Doubles()) : static_cast<std::size_t>(first_outside);
}

// Goes along the parameters of one piece.
template <class Degree>
class PieceSampler {
  public:
    HWY_INLINE PieceSampler(const TaylorPiece& piece, Degree p, const Samples& samples)
        : piece_(piece), p_(p), samples_(samples) {}

    HWY_INLINE std::size_t sample() const {
        const std::size_t lanes = hn::Lanes(Doubles());
        const std::size_t count = samples_.parameters.size();
        std::size_t i = 0;
        for (; i + vectors_at_once * lanes <= count; i += vectors_at_once * lanes)
            if (const std::size_t inside = sample_vectors<vectors_at_once>(parameters() + i, coordinates() + 2 * i);
                inside < vectors_at_once * lanes)
                return i + inside;
        for (; i + lanes <= count; i += lanes)
            if (const std::size_t inside = sample_vectors<1>(parameters() + i, coordinates() + 2 * i); inside < lanes)
                return i + inside;
        return i == count ? i : i + sample_rest(i);
    }

  private:
    const double* parameters() const { return samples_.parameters.data(); }
    double* coordinates() const { return reinterpret_cast<double*>(samples_.points.data()); }

    // Writes the points of all, and counts the first ones that lie on the piece.
    template <std::size_t Count>
    HWY_INLINE std::size_t sample_vectors(const double* parameters, double* coordinates) const {
        const Doubles d;
        const std::size_t lanes = hn::Lanes(d);
        Vectors<Count> t;
        for (std::size_t i = 0; i < Count; ++i)
            t[i] = hn::Mul(hn::Sub(hn::LoadU(d, parameters + i * lanes), all(piece_.middle())), all(piece_.scale()));
        const PointLanes<Count> found =
            piece_.is_rational ? rational_points<Count>(piece_, p_, t) : polynomial_points<Count>(piece_, p_, t);
        for (std::size_t i = 0; i < Count; ++i)
            hn::StoreInterleaved2(found.x[i], found.y[i], d, coordinates + 2 * lanes * i);
        for (std::size_t i = 0; i < Count; ++i)
            if (const std::size_t inside = count_inside(hn::LoadU(d, parameters + i * lanes), samples_.interval);
                inside < lanes)
                return i * lanes + inside;
        return Count * lanes;
    }

    // The rest too in lanes, so that it gets the same bits.
    HWY_INLINE std::size_t sample_rest(std::size_t first) const {
        std::array<double, hn::MaxLanes(Doubles())> rest;
        std::array<double, 2 * hn::MaxLanes(Doubles())> found;
        rest.fill(samples_.interval.upper);
        std::copy(samples_.parameters.begin() + static_cast<std::ptrdiff_t>(first), samples_.parameters.end(),
                  rest.begin());
        const std::size_t inside = sample_vectors<1>(rest.data(), found.data());
        std::copy_n(found.begin(), 2 * (samples_.parameters.size() - first), coordinates() + 2 * first);
        return inside;
    }

    const TaylorPiece& piece_;
    Degree p_;
    const Samples& samples_;
};

template <class Degree>
std::size_t sample_of_degree(const TaylorPiece& piece, Degree p, const Samples& samples) {
    return PieceSampler<Degree>(piece, p, samples).sample();
}

template <std::size_t P>
using Known = std::integral_constant<std::size_t, P>;

// A degree up to `Most` becomes known.
template <std::size_t Most>
std::size_t sample_up_to(const TaylorPiece& piece, const Samples& samples) {
    if constexpr (Most == 0)
        return sample_of_degree(piece, piece.p, samples);
    else
        return piece.p == Most ? sample_of_degree(piece, Known<Most>(), samples)
                               : sample_up_to<Most - 1>(piece, samples);
}

std::size_t sample_lanes(const TaylorPiece& piece, const Samples& samples) {
    return sample_up_to<5>(piece, samples);
}

}  // namespace
}  // namespace batten::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace batten::core {

HWY_EXPORT(sample_lanes);

std::size_t sample_piece(const TaylorPiece& piece, const Samples& samples) {
    static_assert(sizeof(Point) == 2 * sizeof(double));
    return HWY_DYNAMIC_DISPATCH(sample_lanes)(piece, samples);
}

}  // namespace batten::core
#endif
