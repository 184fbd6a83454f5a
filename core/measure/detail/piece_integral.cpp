#include "core/measure/detail/piece_integral.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/unit_interval.h"

namespace batten::core {

namespace {

// Each range is so many times as long as the one before it.
constexpr double growth = 16.0;

// So many ranges are enough for the weights of any curve but a huge one.
constexpr double most_ranges = 20'000.0;

Ratio ratio_of(HalfPlace place) {
    if (place.is_second()) return {-place.offset, 1.0 + place.offset};
    return {1.0 - place.offset, place.offset};
}

// How many steps it takes from the middle of a half to where the largest weight no longer outweighs the smallest one.
int steps_toward_end(const PieceMotion& piece, std::size_t piece_count) {
    const auto [least, most] =
        std::minmax_element(piece.points().begin(), piece.points().end(),
                            [](const HomogeneousPoint& a, const HomogeneousPoint& b) { return a.z < b.z; });
    const double steps = std::log(most->z / least->z) / std::log(growth);
    return static_cast<int>(std::min(steps, 0.5 * most_ranges / static_cast<double>(piece_count)));
}

void add_range(std::vector<PieceRange>& ranges, std::size_t half, Interval interval, Interval wanted) {
    const Interval common{std::max(interval.lower, wanted.lower), std::min(interval.upper, wanted.upper)};
    if (common.lower < common.upper) ranges.push_back({half, common});
}

}  // namespace

Motion motion_at(std::span<const PieceMotion> pieces, HalfPlace place) {
    return pieces[place.piece()].at(ratio_of(place));
}

Vector velocity_at(std::span<const PieceMotion> pieces, HalfPlace place) {
    return pieces[place.piece()].velocity_at(ratio_of(place));
}

double parameter_at(std::span<const PieceMotion> pieces, HalfPlace place) {
    const Interval interval = pieces[place.piece()].interval();
    if (place.is_second()) return interval.clamp(interval.upper + place.offset * interval.length());
    return from_unit(interval, place.offset);
}

HalfPlace place_at(std::span<const PieceMotion> pieces, std::size_t piece, double u) {
    const Interval interval = pieces[piece].interval();
    const double share = to_unit(interval, u);
    if (share < 0.5) return {2 * piece, share};
    return {2 * piece + 1, std::clamp((u - interval.upper) / interval.length(), -0.5, 0.0)};
}

void add_ranges(std::vector<PieceRange>& ranges, std::span<const PieceMotion> pieces, std::size_t piece,
                Interval wanted) {
    const Interval interval = pieces[piece].interval();
    if (interval.upper <= wanted.lower || interval.lower >= wanted.upper) return;
    const HalfPlace from = place_at(pieces, piece, interval.clamp(wanted.lower));
    const HalfPlace to = place_at(pieces, piece, interval.clamp(wanted.upper));
    const Interval first{from.is_second() ? 0.5 : from.offset, to.is_second() ? 0.5 : to.offset};
    const Interval second{from.is_second() ? from.offset : -0.5, to.is_second() ? to.offset : -0.5};
    const int steps = steps_toward_end(pieces[piece], pieces.size());
    const auto cut = [&](int k) { return k > steps ? 0.0 : 0.5 * std::pow(growth, -k); };
    for (int k = steps; k >= 0; --k) add_range(ranges, 2 * piece, {cut(k + 1), cut(k)}, first);
    for (int k = 0; k <= steps; ++k) add_range(ranges, 2 * piece + 1, {-cut(k), -cut(k + 1)}, second);
}

std::vector<PieceRange> ranges_between(std::span<const PieceMotion> pieces, Interval wanted) {
    std::vector<PieceRange> ranges;
    for (std::size_t i = 0; i < pieces.size(); ++i) add_ranges(ranges, pieces, i, wanted);
    return ranges;
}

}  // namespace batten::core
