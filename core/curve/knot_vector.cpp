#include "core/curve/knot_vector.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "core/curve/knot_analysis.h"

namespace batten::core {

namespace {

using Check = Result<void>;

Check check_count(std::size_t found, std::size_t least) {
    if (found < least)
        return refuse({.code = CurveErrorCode::knot_count_mismatch,
                       .value = static_cast<double>(found),
                       .lower = static_cast<double>(least)});
    return {};
}

Check check_finite(std::span<const double> knots) {
    for (std::size_t i = 0; i < knots.size(); ++i)
        if (!std::isfinite(knots[i])) return refuse({.code = CurveErrorCode::knot_not_finite, .index = i});
    return {};
}

Check check_order(std::span<const double> knots) {
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (knots[i] < knots[i - 1])
            return refuse(
                {.code = CurveErrorCode::knot_decreasing, .index = i, .value = knots[i], .lower = knots[i - 1]});
    return {};
}

// Of knots as algorithms see them; `stored` are their ends as they were given.
Check check_extent(std::span<const double> knots, std::span<const double> stored) {
    if (!std::isfinite(knots.back() - knots.front()))
        return refuse({.code = CurveErrorCode::knots_too_far_apart, .lower = stored.front(), .upper = stored.back()});
    return {};
}

Check check_domain(Interval domain) {
    if (domain.lower == domain.upper) return refuse({.code = CurveErrorCode::domain_empty, .value = domain.lower});
    return {};
}

Check check_multiplicity(std::size_t first, std::size_t found, std::size_t most) {
    if (found > most)
        return refuse({.code = CurveErrorCode::multiplicity_too_high,
                       .index = first,
                       .value = static_cast<double>(found),
                       .upper = static_cast<double>(most)});
    return {};
}

std::size_t end_of_run(std::span<const double> knots, std::size_t first) {
    std::size_t end = first;
    while (end < knots.size() && knots[end] == knots[first]) ++end;
    return end;
}

Check check_multiplicities(std::span<const double> knots, std::size_t p, Interval domain, Tears tears) {
    for (std::size_t first = 0; first < knots.size();) {
        const std::size_t end = end_of_run(knots, first);
        const bool at_end = knots[first] == domain.lower || knots[first] == domain.upper;
        const std::size_t most = at_end || tears == Tears::allow ? p + 1 : p;
        if (auto check = check_multiplicity(first, end - first, most); !check) return check;
        first = end;
    }
    return {};
}

// The seam is one knot, which the period names at both of its ends.
Check check_period_multiplicities(std::span<const double> period, std::size_t p) {
    const auto at_upper_end = static_cast<std::size_t>(std::count(period.begin(), period.end(), period.back()));
    const std::size_t end_of_seam = end_of_run(period, 0);
    if (auto check = check_multiplicity(0, end_of_seam + at_upper_end - 1, p); !check) return check;
    for (std::size_t first = end_of_seam; first < period.size() - at_upper_end;) {
        const std::size_t end = end_of_run(period, first);
        if (auto check = check_multiplicity(first, end - first, p); !check) return check;
        first = end;
    }
    return {};
}

// How many of the sorted `values` are `before` the rest. Eight ways at each step and no branch that depends on what is
// found there, so that the processor never guesses wrong.
template <class Before>
std::size_t count_first(std::span<const double> values, Before before) {
    constexpr std::size_t ways = 8;
    const double* first = values.data();
    std::size_t count = values.size();
    const auto count_before = [&](std::size_t candidates, std::size_t step) {
        std::size_t found = 0;
        for (std::size_t k = 1; k <= candidates; ++k) found += static_cast<std::size_t>(before(first[k * step - 1]));
        return found;
    };
    while (count >= ways) {
        const std::size_t step = count / ways;
        first += step * count_before(ways - 1, step);
        count -= step * (ways - 1);
    }
    return static_cast<std::size_t>(first - values.data()) + count_before(count, 1);
}

}  // namespace

Result<void> check_degree(int degree) {
    if (degree < min_degree || degree > max_degree)
        return refuse({.code = CurveErrorCode::degree_out_of_range, .value = static_cast<double>(degree)});
    return {};
}

KnotVector::KnotVector(int degree, bool is_periodic, KnotKind kind, SharedArray<double> values)
    : degree_(degree), is_periodic_(is_periodic), kind_(kind), values_(std::move(values)) {}

KnotVector KnotVector::of_kind_or_custom(int degree, bool is_periodic, KnotKind kind, SharedArray<double> values) {
    KnotVector knots(degree, is_periodic, kind, std::move(values));
    if (!is_of_kind(knots, kind)) knots.kind_ = KnotKind::custom;
    return knots;
}

Result<KnotVector> KnotVector::make(int degree, std::vector<double> knots, KnotKind kind, Tears tears) {
    if (auto check = check_degree(degree); !check) return refuse(check.error());
    const auto p = static_cast<std::size_t>(degree);
    const auto domain = [&] { return Interval{knots[p], knots[knots.size() - p - 1]}; };
    const Check check = check_count(knots.size(), 2 * p + 2)
                            .and_then([&] { return check_finite(knots); })
                            .and_then([&] { return check_order(knots); })
                            .and_then([&] { return check_extent(knots, knots); })
                            .and_then([&] { return check_domain(domain()); })
                            .and_then([&] { return check_multiplicities(knots, p, domain(), tears); });
    if (!check) return refuse(check.error());
    return of_kind_or_custom(degree, false, kind, SharedArray(std::move(knots)));
}

Result<KnotVector> KnotVector::make_periodic(int degree, std::vector<double> period, KnotKind kind) {
    if (auto check = check_degree(degree); !check) return refuse(check.error());
    const auto p = static_cast<std::size_t>(degree);
    const Check check = check_count(period.size(), 3)
                            .and_then([&] { return check_finite(period); })
                            .and_then([&] { return check_order(period); })
                            .and_then([&] {
                                return check_domain({period.front(), period.back()});
                            })
                            .and_then([&] { return check_period_multiplicities(period, p); });
    if (!check) return refuse(check.error());
    std::vector<double> values = unroll_period(period, p, p);
    if (auto extent = check_extent(values, period); !extent) return refuse(extent.error());
    return of_kind_or_custom(degree, true, kind, SharedArray(std::move(values)));
}

std::size_t KnotVector::control_point_count() const {
    const auto p = static_cast<std::size_t>(degree_);
    return is_periodic_ ? values_.size() - 2 * p - 1 : values_.size() - p - 1;
}

std::span<const double> KnotVector::stored() const {
    const std::span<const double> all = values();
    return is_periodic_ ? all.subspan(stored_offset(), control_point_count() + 1) : all;
}

std::size_t KnotVector::span_at(double u, Side side) const {
    const auto p = static_cast<std::size_t>(degree_);
    const auto [lower, upper] = domain();
    const std::span<const double> inner = values().subspan(p + 1, values_.size() - 2 * p - 2);
    const bool from_left = u >= upper || (side == Side::left && u > lower);
    const double least = u > lower ? u : lower;
    return p + (from_left ? count_first(inner, [most = std::min(u, upper)](double knot) { return knot < most; })
                          : count_first(inner, [least](double knot) { return knot <= least; }));
}

int KnotVector::multiplicity(double u) const {
    assert(!std::isnan(u));
    if (is_periodic_) u = into_domain(u);
    const auto knots = stored();
    const auto [lower, upper] = domain();
    const auto occurrences = [&](double value) {
        const auto run = std::equal_range(knots.begin(), knots.end(), value);
        return static_cast<int>(run.second - run.first);
    };
    const bool at_seam = is_periodic_ && (u == lower || u == upper);
    return at_seam ? occurrences(lower) + occurrences(upper) - 1 : occurrences(u);
}

double KnotVector::into_domain(double u) const {
    const Interval range = domain();
    if (range.contains(u)) return u;
    if (!is_periodic_) return u > range.upper ? range.upper : range.lower;
    if (!std::isfinite(u)) return range.lower;
    const double turns = std::floor((u - range.lower) / range.length());
    return range.clamp(u - turns * range.length());
}

double KnotVector::into_domain(double u, Side side) const {
    const double inside = into_domain(u);
    const auto [lower, upper] = domain();
    if (!is_periodic_ || (inside != lower && inside != upper)) return inside;
    return side == Side::right ? lower : upper;
}

std::vector<double> unroll_period(std::span<const double> period, std::size_t below, std::size_t above) {
    assert(period.size() >= 2);
    const std::size_t n = period.size() - 1;
    std::vector<double> knots(below + period.size() + above);
    std::copy(period.begin(), period.end(), knots.begin() + static_cast<std::ptrdiff_t>(below));
    // Differences to an end of the period come first: they are zero where a knot equals the end, so the copy does too.
    for (std::size_t i = below; i-- > 0;) knots[i] = period.front() + (knots[i + n] - period.back());
    for (std::size_t i = below + period.size(); i < knots.size(); ++i)
        knots[i] = period.back() + (knots[i - n] - period.front());
    return knots;
}

}  // namespace batten::core
