#include "core/evaluate/detail/span_block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/evaluate/detail/span_block.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Compiled once for each kind of processor.
HWY_BEFORE_NAMESPACE();
namespace batten::core::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, block_size>;
using Lanes = hn::Vec<Doubles>;

template <std::size_t P>
using Known = std::integral_constant<std::size_t, P>;

template <class Degree>
inline constexpr std::size_t most_of = max_degree;
template <std::size_t P>
inline constexpr std::size_t most_of<Known<P>> = P;

// Up to these sums of terms the last digit or two of their sum are lost at most, which is what weights and degrees up
// to 25 leave anyway.
constexpr double largest_sum = 4.0;

// So does a sum of the terms of the weight that is nowhere smaller than this part of all their sizes.
constexpr double least_part = 0.25;

HWY_INLINE Lanes all(double value) {
    return hn::Set(Doubles(), value);
}

struct PointLanes {
    Lanes x;
    Lanes y;
};

template <class Degree>
using LocalValues = std::array<Lanes, most_of<Degree> + 1>;

// The triangle of bspline.h at a parameter, as SpanTriangle has it for one span.
template <class Degree>
class TriangleLanes {
  public:
    // Knots are multiplied by `scale`.
    HWY_INLINE TriangleLanes(const SpanBlock& block, std::size_t lane, Degree p, Lanes scale) : p_(p) {
        const Doubles d;
        const Lanes u = hn::Load(d, &block.parameters.lanes[lane]);
        for (std::size_t r = 1; r <= p_; ++r)
            for (std::size_t j = r; j <= p_; ++j) {
                const Lanes lower = hn::Load(d, &block.knots[j - 1].lanes[lane]);
                const Lanes upper = hn::Load(d, &block.knots[p_ + j - r].lanes[lane]);
                steps_[r - 1][j - 1] = step_at(hn::Mul(scale, hn::Sub(u, lower)), hn::Mul(scale, hn::Sub(upper, u)),
                                               hn::Mul(scale, hn::Sub(upper, lower)));
            }
    }

    // Splines after `levels_done` levels.
    template <std::size_t Count>
    HWY_INLINE std::array<Lanes, Count> apices(const std::array<LocalValues<Degree>, Count>& splines,
                                               std::size_t levels_done = 0) const {
        std::array<LocalValues<Degree>, Count> values;
        for (std::size_t c = 0; c < Count; ++c)
            for (std::size_t j = levels_done; j <= p_; ++j) values[c][j] = splines[c][j];
        for (std::size_t r = levels_done + 1; r <= p_; ++r)
            for (std::size_t j = p_; j >= r; --j)
                for (auto& v : values) v[j] = blended(v[j - 1], v[j], steps_[r - 1][j - 1]);
        std::array<Lanes, Count> apices;
        for (std::size_t c = 0; c < Count; ++c) apices[c] = values[c][p_];
        return apices;
    }

    // Level k as a derivative, divided by k, in place; returns the largest of the new ones.
    HWY_INLINE Lanes differentiate(LocalValues<Degree>& values, std::size_t k) const {
        const Lanes factor = all(static_cast<double>(p_ - k + 1) / static_cast<double>(k));
        Lanes largest = all(0.0);
        for (std::size_t j = p_; j >= k; --j) {
            const Lanes speed = hn::Mul(factor, steps_[k - 1][j - 1].inverse);
            values[j] = hn::Mul(speed, hn::Sub(values[j], values[j - 1]));
            largest = hn::Max(largest, hn::Abs(values[j]));
        }
        return largest;
    }

  private:
    struct Step {
        Lanes share;  // from the nearer one: upper_share or -lower_share
        hn::Mask<Doubles> is_nearer_lower;
        Lanes inverse;  // of the distance of the knots
    };

    HWY_INLINE static Step step_at(Lanes from_lower, Lanes to_upper, Lanes length) {
        const auto is_nearer_lower = hn::Le(from_lower, to_upper);
        const Lanes nearer = hn::IfThenElse(is_nearer_lower, from_lower, hn::Neg(to_upper));
        const Lanes inverse = hn::Div(all(1.0), length);
        // The quotient, but for a rounding, and what is missing to it.
        const Lanes quotient = hn::Mul(nearer, inverse);
        const Lanes rest = hn::NegMulAdd(quotient, length, nearer);
        return {hn::MulAdd(rest, inverse, quotient), is_nearer_lower, inverse};
    }

    HWY_INLINE static Lanes blended(Lanes a, Lanes b, const Step& step) {
        return hn::MulAdd(step.share, hn::Sub(b, a), hn::IfThenElse(step.is_nearer_lower, a, b));
    }

    Degree p_;
    std::array<std::array<Step, most_of<Degree>>, most_of<Degree>> steps_;
};

// The local control points, x and y, and where rational their weights.
template <class Degree, std::size_t Count>
using LocalLanes = std::array<LocalValues<Degree>, Count>;

// The weights divided by the power of two of the largest one.
template <class Degree>
HWY_INLINE void make_moderate(LocalValues<Degree>& weights, Degree p) {
    Lanes largest = weights[0];
    for (std::size_t j = 1; j <= p; ++j) largest = hn::Max(largest, weights[j]);
    const hn::RebindToUnsigned<Doubles> bits;
    const auto exponent = hn::And(hn::BitCast(bits, largest), hn::Set(bits, 0x7FF0000000000000U));
    const Lanes factor = hn::Div(all(1.0), hn::BitCast(Doubles(), exponent));
    for (std::size_t j = 0; j <= p; ++j) weights[j] = hn::Mul(weights[j], factor);
}

template <std::size_t Count, class Degree>
HWY_INLINE LocalLanes<Degree, Count> read_local(const SpanBlock& block, std::size_t lane, Degree p) {
    const Doubles d;
    LocalLanes<Degree, Count> local;
    for (std::size_t j = 0; j <= p; ++j) {
        local[0][j] = hn::Load(d, &block.x[j].lanes[lane]);
        local[1][j] = hn::Load(d, &block.y[j].lanes[lane]);
        if constexpr (Count == 3) local[2][j] = hn::Load(d, &block.weights[j].lanes[lane]);
    }
    if constexpr (Count == 3) make_moderate(local[2], p);
    return local;
}

// The local control points seen from `origin`, times their weights.
template <class Degree, std::size_t Count>
HWY_INLINE LocalLanes<Degree, Count> seen_from(PointLanes origin, const LocalLanes<Degree, Count>& local, Degree p) {
    LocalLanes<Degree, Count> seen;
    for (std::size_t j = 0; j <= p; ++j) {
        seen[0][j] = hn::Sub(local[0][j], origin.x);
        seen[1][j] = hn::Sub(local[1][j], origin.y);
        if constexpr (Count == 3) {
            seen[0][j] = hn::Mul(local[2][j], seen[0][j]);
            seen[1][j] = hn::Mul(local[2][j], seen[1][j]);
            seen[2][j] = local[2][j];
        }
    }
    return seen;
}

// The point on every span and its weight, 1 where not rational.
template <std::size_t Count>
struct SpanPoints {
    PointLanes point;
    Lanes weight;

    HWY_INLINE Lanes projected(Lanes value) const { return Count == 3 ? hn::Div(value, weight) : value; }
};

// Twice: the second time seen from the first answer, where the coordinates are small, and so is what rounding does.
template <class Degree, std::size_t Count>
HWY_INLINE SpanPoints<Count> points_on(const TriangleLanes<Degree>& triangle, const LocalLanes<Degree, Count>& local,
                                       Degree p) {
    SpanPoints<Count> at{{all(0.0), all(0.0)}, all(1.0)};
    for (int pass = 0; pass < 2; ++pass) {
        const auto sums = triangle.apices(seen_from(at.point, local, p));
        if constexpr (Count == 3) at.weight = sums[2];
        at.point.x = hn::Add(at.point.x, at.projected(sums[0]));
        at.point.y = hn::Add(at.point.y, at.projected(sums[1]));
    }
    return at;
}

// Where the numbers go.
class RowWriter {
  public:
    HWY_INLINE RowWriter(std::array<LaneRow, most_taylor_numbers>& rows, std::size_t lane) : rows_(rows), lane_(lane) {}

    HWY_INLINE void add(Lanes values) {
        hn::Store(values, Doubles(), &rows_[next_++].lanes[lane_]);
        // Zero as long as all are finite.
        check_ = hn::MulAdd(values, all(0.0), check_);
    }

    HWY_INLINE hn::Mask<Doubles> are_finite() const { return hn::Eq(check_, all(0.0)); }

  private:
    std::array<LaneRow, most_taylor_numbers>& rows_;
    std::size_t lane_;
    std::size_t next_ = 2;
    Lanes check_ = all(0.0);
};

// No less than a coordinate of a control point seen from `origin`.
template <class Degree, std::size_t Count>
HWY_INLINE Lanes size_seen_from(PointLanes origin, const LocalLanes<Degree, Count>& local, Degree p) {
    Lanes size = all(0.0);
    for (std::size_t j = 0; j <= p; ++j) {
        size = hn::Max(size, hn::Abs(hn::Sub(local[0][j], origin.x)));
        size = hn::Max(size, hn::Abs(hn::Sub(local[1][j], origin.y)));
    }
    return size;
}

// Where a sum of weights keeps its digits: of one and others of these sizes. It is no smaller than the least weight.
template <class Degree>
HWY_INLINE hn::Mask<Doubles> is_sharp_weight(const LocalValues<Degree>& weights, Degree p, Lanes one, Lanes others) {
    Lanes least = weights[0];
    for (std::size_t j = 1; j <= p; ++j) least = hn::Min(least, weights[j]);
    return hn::Ge(hn::Max(least, hn::Sub(one, others)), hn::Mul(all(least_part), hn::Add(one, others)));
}

// Where the sum of all terms keeps its digits: it cannot be larger than the points over which the terms are splines.
template <class Degree, std::size_t Count>
HWY_INLINE hn::Mask<Doubles> are_small(const TriangleLanes<Degree>& triangle, const LocalLanes<Degree, Count>& local,
                                       LocalLanes<Degree, Count> seen, Degree p, const SpanPoints<Count>& at) {
    Lanes sum = all(0.0);
    Lanes sum_of_weights = all(0.0);
    for (std::size_t k = 1; k <= p; ++k) {
        const Lanes size = triangle.differentiate(seen[0], k);
        sum = hn::Add(sum, hn::Max(size, triangle.differentiate(seen[1], k)));
        if constexpr (Count == 3) sum_of_weights = hn::Add(sum_of_weights, triangle.differentiate(seen[2], k));
    }
    const auto are = hn::Le(at.projected(sum), hn::Mul(all(largest_sum), size_seen_from(at.point, local, p)));
    if constexpr (Count == 2) return are;
    return hn::And(are, is_sharp_weight(local[Count - 1], p, at.weight, sum_of_weights));
}

template <std::size_t Count, class Degree>
void expand_lanes(const SpanBlock& block, Degree p, std::size_t lane, const LaneRow& scales,
                  std::array<LaneRow, most_taylor_numbers>& numbers) {
    const Doubles d;
    const Lanes scale = hn::Load(d, &scales.lanes[lane]);
    const TriangleLanes<Degree> triangle(block, lane, p, scale);
    const auto local = read_local<Count>(block, lane, p);
    const SpanPoints<Count> at = points_on(triangle, local, p);
    auto seen = Count == 3 ? seen_from(at.point, local, p) : local;
    const auto is_sharp = are_small(triangle, local, seen, p, at);
    hn::Store(hn::Load(d, &block.parameters.lanes[lane]), d, &numbers[0].lanes[lane]);
    hn::Store(hn::IfThenElseZero(is_sharp, scale), d, &numbers[1].lanes[lane]);
    if (hn::AllFalse(d, is_sharp)) return;
    RowWriter out(numbers, lane);
    out.add(at.point.x);
    out.add(at.point.y);
    for (std::size_t k = 1; k <= p; ++k) {
        for (auto& values : seen) triangle.differentiate(values, k);
        for (const Lanes term : triangle.apices(seen, k)) out.add(at.projected(term));
    }
    hn::Store(hn::IfThenElseZero(hn::And(is_sharp, out.are_finite()), scale), d, &numbers[1].lanes[lane]);
}

template <std::size_t Count, class Degree>
void point_lanes(const SpanBlock& block, Degree p, std::size_t lane, std::array<Point, block_size>& points) {
    const TriangleLanes<Degree> triangle(block, lane, p, all(1.0));
    const PointLanes found = points_on(triangle, read_local<Count>(block, lane, p), p).point;
    hn::StoreInterleaved2(found.x, found.y, Doubles(), &points[lane].x);
}

template <class Use>
HWY_INLINE void for_lanes(std::size_t p, Use use) {
    for (std::size_t lane = 0; lane < block_size; lane += hn::Lanes(Doubles())) {
        switch (p) {
            case 1:
                use(Known<1>(), lane);
                break;
            case 2:
                use(Known<2>(), lane);
                break;
            case 3:
                use(Known<3>(), lane);
                break;
            case 4:
                use(Known<4>(), lane);
                break;
            case 5:
                use(Known<5>(), lane);
                break;
            default:
                use(p, lane);
        }
    }
}

void expand_block(const SpanBlock& block, const LaneRow& scales, std::array<LaneRow, most_taylor_numbers>& numbers) {
    for_lanes(block.p, [&](auto p, std::size_t lane) HWY_ATTR {
        return block.is_rational ? expand_lanes<3>(block, p, lane, scales, numbers)
                                 : expand_lanes<2>(block, p, lane, scales, numbers);
    });
}

void points_of_block(const SpanBlock& block, std::array<Point, block_size>& points) {
    for_lanes(block.p, [&](auto p, std::size_t lane) HWY_ATTR {
        return block.is_rational ? point_lanes<3>(block, p, lane, points) : point_lanes<2>(block, p, lane, points);
    });
}

}  // namespace
}  // namespace batten::core::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace batten::core {

HWY_EXPORT(expand_block);
HWY_EXPORT(points_of_block);

void expand(const SpanBlock& block, const LaneRow& scales, std::array<LaneRow, most_taylor_numbers>& numbers) {
    HWY_DYNAMIC_DISPATCH(expand_block)(block, scales, numbers);
}

void points_of(const SpanBlock& block, std::array<Point, block_size>& points) {
    static_assert(sizeof(Point) == 2 * sizeof(double));
    HWY_DYNAMIC_DISPATCH(points_of_block)(block, points);
}

void SpanBlock::read(const Curve& curve, std::size_t s, std::size_t lane) {
    const std::span<const double> from = curve.knots().values().subspan(s - p + 1, 2 * p);
    for (std::size_t i = 0; i < 2 * p; ++i) knots[i][lane] = from[i];
    const std::span<const Point> points = curve.control_points();
    std::size_t i = (s - p) % points.size();
    for (std::size_t j = 0; j <= p; ++j) {
        x[j][lane] = points[i].x;
        y[j][lane] = points[i].y;
        if (is_rational) weights[j][lane] = curve.weights()[i];
        if (++i == points.size()) i = 0;
    }
}

void SpanBlock::read_following(const Curve& curve, std::size_t s) {
    const double* from = &curve.knots().values()[s - p + 1];
    for (std::size_t i = 0; i < 2 * p; ++i) std::copy_n(from + i, block_size, knots[i].lanes.begin());
    const Point* points = &curve.control_points()[s - p];
    for (std::size_t j = 0; j <= p; ++j)
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            x[j][lane] = points[j + lane].x;
            y[j][lane] = points[j + lane].y;
        }
    if (!is_rational) return;
    for (std::size_t j = 0; j <= p; ++j) std::copy_n(&curve.weights()[s - p + j], block_size, weights[j].lanes.begin());
}

}  // namespace batten::core
#endif
