#include "core/measure/arc_length.h"

#include <cassert>

#include "core/base/detail/quadrature.h"
#include "core/base/detail/unit_interval.h"
#include "core/curve/control_box.h"

namespace batten::core {

namespace {

// A part whose error is less than this share of the whole length is done.
constexpr double enough = 1e-15;

constexpr double length_rounding = 8.0 * std::numeric_limits<double>::epsilon();
constexpr int most_length_steps = 60;
constexpr Interval whole_piece{0.0, 1.0};

struct PieceRange {
    const PieceMotion* piece = nullptr;
    Interval shares;  // in [0, 1]
};

// The error of the longer rule, which converges much faster than the shorter one that it is compared with.
double error_of(const RulePair<double>& rules) {
    const double size = std::abs(rules.kronrod);
    if (size == 0.0) return 0.0;
    return size * std::min(1.0, std::pow(200.0 * std::abs(rules.kronrod - rules.gauss) / size, 1.5));
}

double estimate(std::span<const PieceRange> ranges) {
    double sum = 0.0;
    for (const PieceRange& range : ranges)
        sum += integrate_once<double>([&](double t) { return range.piece->speed_at(t); }, range.shares).kronrod;
    return sum;
}

// Calls `take` with every range's parts, on which the rules are as accurate as they should be.
template <class Take>
Integral integrate(std::span<const PieceRange> ranges, const Take& take) {
    const double tolerance = enough * estimate(ranges);
    Integral total;
    for (const PieceRange& range : ranges)
        integrate_adaptively<double>([&](double t) { return range.piece->speed_at(t); }, range.shares,
                                     [&](const RulePair<double>& rules) { return !(error_of(rules) > tolerance); },
                                     [&](const RulePair<double>& rules) {
                                         take(*range.piece, rules);
                                         total.value += rules.kronrod;
                                         total.error += error_of(rules);
                                     });
    total.error += length_rounding * total.value;
    return total;
}

Integral integrate(std::span<const PieceRange> ranges) {
    return integrate(ranges, [](const PieceMotion&, const RulePair<double>&) {});
}

std::vector<PieceRange> ranges_between(std::span<const PieceMotion> pieces, Interval wanted) {
    std::vector<PieceRange> ranges;
    for (const PieceMotion& piece : pieces) {
        const Interval interval = piece.interval();
        if (interval.upper <= wanted.lower || interval.lower >= wanted.upper) continue;
        ranges.push_back({&piece, {to_unit(interval, wanted.lower), to_unit(interval, wanted.upper)}});
    }
    return ranges;
}

// How often the period goes into the way from the domain's beginning to `u`, and what is left.
std::pair<double, double> whole_periods(Interval domain, double u) {
    const double count = std::floor((u - domain.lower) / domain.length());
    return {count, domain.clamp(u - count * domain.length())};
}

Integral around(std::span<const PieceMotion> pieces, Interval domain, double from, double to) {
    const auto [first_period, first] = whole_periods(domain, from);
    const auto [last_period, last] = whole_periods(domain, to);
    if (first_period == last_period) return integrate(ranges_between(pieces, {first, last}));
    const Integral whole = integrate(ranges_between(pieces, domain));
    const Integral begun = integrate(ranges_between(pieces, {first, domain.upper}));
    const Integral ended = integrate(ranges_between(pieces, {domain.lower, last}));
    const double between = last_period - first_period - 1.0;
    return {begun.value + between * whole.value + ended.value, begun.error + between * whole.error + ended.error};
}

}  // namespace

Integral arc_length(const Curve& curve) {
    return arc_length(curve, curve.domain().lower, curve.domain().upper);
}

Integral arc_length(const Curve& curve, double from, double to) {
    assert(!std::isnan(from) && !std::isnan(to));
    if (to < from) {
        const Integral reverse = arc_length(curve, to, from);
        return {-reverse.value, reverse.error};
    }
    const auto pieces = motions_of(curve, middle_of(curve));
    const Interval domain = curve.domain();
    const bool is_inside = domain.contains(from) && domain.contains(to);
    if (curve.is_periodic() && !is_inside && std::isfinite(to - from)) return around(pieces, domain, from, to);
    return integrate(ranges_between(pieces, {domain.clamp(from), domain.clamp(to)}));
}

ArcLengthTable::ArcLengthTable(const Curve& curve)
    : knots_(curve.knots()), pieces_(motions_of(curve, middle_of(curve))) {
    std::vector<PieceRange> ranges;
    for (const PieceMotion& piece : pieces_) ranges.push_back({&piece, whole_piece});
    total_ = integrate(ranges, [&](const PieceMotion& piece, const RulePair<double>& rules) {
        const double before = parts_.empty() ? 0.0 : parts_.back().before + parts_.back().length;
        parts_.push_back({static_cast<std::size_t>(&piece - pieces_.data()), rules.interval, rules.kronrod, before});
    });
}

double ArcLengthTable::length_at(double u) const {
    const double inside = knots_.into_domain(u);
    const auto after = std::partition_point(parts_.begin() + 1, parts_.end(), [&](const Part& part) {
        return from_unit(pieces_[part.piece].interval(), part.shares.lower) <= inside;
    });
    const Part& part = *(after - 1);
    const PieceMotion& piece = pieces_[part.piece];
    const double t = part.shares.clamp(to_unit(piece.interval(), inside));
    if (t == part.shares.upper) return part.before + part.length;
    const auto speed = [&](double share) { return piece.speed_at(share); };
    return part.before + integrate_once<double>(speed, {part.shares.lower, t}).kronrod;
}

double ArcLengthTable::parameter_at(double s) const {
    assert(!std::isnan(s));
    const double total = parts_.back().before + parts_.back().length;
    const bool goes_round = knots_.is_periodic() && !(0.0 <= s && s <= total) && total > 0.0 && std::isfinite(s);
    const double wanted = std::clamp(goes_round ? s - std::floor(s / total) * total : s, 0.0, total);
    const auto reached = std::partition_point(parts_.begin(), parts_.end() - 1,
                                              [&](const Part& part) { return part.before + part.length < wanted; });
    return from_unit(pieces_[reached->piece].interval(), share_at(*reached, wanted - reached->before));
}

// Newton's iteration for the integral of the speed, whose derivative is the speed.
double ArcLengthTable::share_at(const Part& part, double length) const {
    if (length <= 0.0) return part.shares.lower;
    if (length >= part.length) return part.shares.upper;
    const auto speed = [&](double share) { return pieces_[part.piece].speed_at(share); };
    Interval bracket = part.shares;
    double t = from_unit(bracket, length / part.length);
    for (int i = 0; i < most_length_steps; ++i) {
        const double excess = integrate_once<double>(speed, {part.shares.lower, t}).kronrod - length;
        (excess < 0.0 ? bracket.lower : bracket.upper) = t;
        double next = t - excess / speed(t);
        if (!(bracket.lower <= next && next <= bracket.upper)) next = bracket.lower + 0.5 * bracket.length();
        const bool is_done = std::abs(next - t) <= 0.5 * std::numeric_limits<double>::epsilon();
        t = next;
        if (is_done) break;
    }
    return t;
}

}  // namespace batten::core
