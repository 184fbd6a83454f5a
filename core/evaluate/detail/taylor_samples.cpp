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

struct PointLanes {
    Lanes x;
    Lanes y;
};

Lanes all(double value) {
    return hn::Set(Doubles(), value);
}

// By Horner's rule. A degree known to the compiler unrolls the loop.
template <class Degree>
HWY_INLINE PointLanes polynomial_points(const TaylorPiece& piece, Degree p, Lanes t) {
    const double* c = piece.point() + 2 * p;
    PointLanes sum{all(c[0]), all(c[1])};
    for (std::size_t k = p; k-- > 0;) {
        c -= 2;
        sum = {hn::MulAdd(sum.x, t, all(c[0])), hn::MulAdd(sum.y, t, all(c[1]))};
    }
    return sum;
}

template <class Degree>
HWY_INLINE PointLanes rational_points(const TaylorPiece& piece, Degree p, Lanes t) {
    const double* c = piece.terms() + 3 * (p - 1);
    PointLanes sum{all(c[0]), all(c[1])};
    Lanes weight = all(c[2]);
    for (std::size_t k = p; k-- > 1;) {
        c -= 3;
        sum = {hn::MulAdd(sum.x, t, all(c[0])), hn::MulAdd(sum.y, t, all(c[1]))};
        weight = hn::MulAdd(weight, t, all(c[2]));
    }
    const Lanes share = hn::Div(t, hn::MulAdd(weight, t, all(1.0)));
    return {hn::MulAdd(sum.x, share, all(piece.point()[0])), hn::MulAdd(sum.y, share, all(piece.point()[1]))};
}

template <class Evaluate>
HWY_INLINE void sample(const TaylorPiece& piece, const double* parameters, std::size_t count, double* points,
                       Evaluate evaluate) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const Lanes middle = all(piece.middle());
    const Lanes scale = all(piece.scale());
    const auto points_at = [&](Lanes u) HWY_ATTR { return evaluate(hn::Mul(hn::Sub(u, middle), scale)); };
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        const PointLanes found = points_at(hn::LoadU(d, parameters + i));
        hn::StoreInterleaved2(found.x, found.y, d, points + 2 * i);
    }
    if (i == count) return;
    // The rest too in lanes, so that it gets the same bits.
    HWY_ALIGN std::array<double, hn::MaxLanes(d)> rest{};
    HWY_ALIGN std::array<double, 2 * hn::MaxLanes(d)> rest_points;
    std::copy(parameters + i, parameters + count, rest.begin());
    const PointLanes found = points_at(hn::Load(d, rest.data()));
    hn::StoreInterleaved2(found.x, found.y, d, rest_points.data());
    std::copy_n(rest_points.begin(), 2 * (count - i), points + 2 * i);
}

template <class Degree>
void sample_of_degree(const TaylorPiece& piece, Degree p, const double* parameters, std::size_t count, double* points) {
    if (piece.is_rational)
        sample(piece, parameters, count, points, [=](Lanes t) HWY_ATTR { return rational_points(piece, p, t); });
    else
        sample(piece, parameters, count, points, [=](Lanes t) HWY_ATTR { return polynomial_points(piece, p, t); });
}

template <std::size_t P>
using Known = std::integral_constant<std::size_t, P>;

void sample_lanes(const TaylorPiece& piece, const double* parameters, std::size_t count, double* points) {
    switch (piece.p) {
        case 1:
            return sample_of_degree(piece, Known<1>(), parameters, count, points);
        case 2:
            return sample_of_degree(piece, Known<2>(), parameters, count, points);
        case 3:
            return sample_of_degree(piece, Known<3>(), parameters, count, points);
        case 4:
            return sample_of_degree(piece, Known<4>(), parameters, count, points);
        case 5:
            return sample_of_degree(piece, Known<5>(), parameters, count, points);
        default:
            return sample_of_degree(piece, piece.p, parameters, count, points);
    }
}

}  // namespace
}  // namespace batten::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace batten::core {

HWY_EXPORT(sample_lanes);

void sample_piece(const TaylorPiece& piece, std::span<const double> parameters, Point* points) {
    static_assert(sizeof(Point) == 2 * sizeof(double));
    HWY_DYNAMIC_DISPATCH(sample_lanes)
    (piece, parameters.data(), parameters.size(), reinterpret_cast<double*>(points));
}

}  // namespace batten::core
#endif
