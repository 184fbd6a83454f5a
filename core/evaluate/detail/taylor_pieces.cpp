#include "core/evaluate/detail/taylor_pieces.h"

#include <bit>
#include <cstdint>
#include <numeric>

#include "core/evaluate/detail/span_block.h"

namespace batten::core {

namespace {

constexpr int most_halvings = 5;

// The least power of two that is no less than half of the length, zero where that is too small a number.
double unit_of(Interval interval) {
    constexpr std::uint64_t exponent = 0x7FF0000000000000U;
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(interval.length()) - 1) & exponent);
}

double middle_of(Interval interval) {
    return interval.lower + 0.5 * interval.length();
}

}  // namespace

// The rows of a block are filled before they are read.
TaylorExpander::TaylorExpander(const Curve& curve)  // NOLINT(cppcoreguidelines-pro-type-member-init)
    : curve_(curve),
      pieces_{.p = static_cast<std::size_t>(curve.degree()), .is_rational = curve.is_rational()},
      block_(curve) {
    parts_.reserve(block_size);
}

void TaylorExpander::begin_at(std::size_t first) {
    pieces_.joints.assign(1, curve_.knots()[first]);
    pieces_.numbers.clear();
    next_ = first;
}

TaylorPieces TaylorExpander::all_pieces() {
    const KnotVector& knots = curve_.knots();
    pieces_.joints.reserve(knots.size());
    pieces_.numbers.reserve(knots.size() * pieces_.stride());
    begin_at(knots.span_at(knots.domain().lower));
    while (pieces_.joints.back() < knots.domain().upper) add_spans();
    return std::move(pieces_);
}

void TaylorExpander::add_spans() {
    const std::span<const double> knots = curve_.knots().values();
    const std::size_t end = knots.size() - pieces_.p - 1;
    parts_.clear();
    for (; next_ < end && parts_.size() < block_size; ++next_)
        if (knots[next_] < knots[next_ + 1]) parts_.push_back({next_, {knots[next_], knots[next_ + 1]}});
    const std::size_t before = pieces_.joints.size() - 1;
    for (int halvings = most_halvings; !parts_.empty(); --halvings) add_parts(halvings);
    put_in_order(before);
}

// Leaves the halves of those that are not sharp.
void TaylorExpander::add_parts(int halvings) {
    std::vector<SpanPart> halves;
    for (std::size_t i = 0; i < parts_.size(); i += block_size) {
        const auto parts = std::span(parts_).subspan(i, std::min(block_size, parts_.size() - i));
        expand_parts(parts);
        for (std::size_t lane = 0; lane < parts.size(); ++lane) {
            const auto [span, interval] = parts[lane];
            const double middle = block_.parameters[lane];
            const bool is_sharp = numbers_[1][lane] != 0.0;
            if (is_sharp || halvings == 0 || !(interval.lower < middle && middle < interval.upper))
                add_piece(lane, interval.upper);
            else
                halves.insert(halves.end(), {{span, {interval.lower, middle}}, {span, {middle, interval.upper}}});
        }
    }
    if (halves.empty())
        parts_.clear();
    else
        parts_ = std::move(halves);
}

void TaylorExpander::expand_parts(std::span<const SpanPart> parts) {
    LaneRow scales;
    const bool follow_another = are_following(parts);
    if (follow_another) block_.read_following(curve_, parts[0].span);
    for (std::size_t lane = 0; lane < block_size; ++lane) {
        const auto& [span, interval] = parts[std::min(lane, parts.size() - 1)];
        if (!follow_another) block_.read(curve_, span, lane);
        block_.parameters[lane] = middle_of(interval);
        scales[lane] = 1.0 / unit_of(interval);
    }
    expand(block_, scales, numbers_);
}

bool TaylorExpander::are_following(std::span<const SpanPart> parts) const {
    if (parts.size() < block_size || parts.back().span >= curve_.control_points().size()) return false;
    for (std::size_t lane = 0; lane < block_size; ++lane)
        if (parts[lane].span != parts[0].span + lane) return false;
    return true;
}

void TaylorExpander::add_piece(std::size_t lane, double upper) {
    const std::size_t before = pieces_.numbers.size();
    pieces_.numbers.resize(before + pieces_.stride());
    for (std::size_t k = 0; k < pieces_.stride(); ++k) pieces_.numbers[before + k] = numbers_[k][lane];
    pieces_.joints.push_back(upper);
}

// Halves were added behind the others.
void TaylorExpander::put_in_order(std::size_t first) {
    const std::span<double> uppers = std::span(pieces_.joints).subspan(first + 1);
    if (std::is_sorted(uppers.begin(), uppers.end())) return;
    std::vector<std::size_t> order(uppers.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return uppers[i] < uppers[j]; });
    const std::size_t stride = pieces_.stride();
    const std::span<double> to = std::span(pieces_.numbers).subspan(first * stride);
    const std::vector<double> from(to.begin(), to.end());
    for (std::size_t i = 0; i < order.size(); ++i) std::copy_n(&from[order[i] * stride], stride, &to[i * stride]);
    std::sort(uppers.begin(), uppers.end());
}

}  // namespace batten::core
