#include "core/measure/detail/common_spans.h"

#include <algorithm>
#include <cmath>

namespace batten::core {

namespace {

constexpr double same_knot_in_ulps = 4.0;

double matched(double u, Interval from, Interval to) {
    if (from == to) return u;
    return to.clamp(to.lower + (u - from.lower) / from.length() * to.length());
}

// How far apart knot `u` of `from` and the match of knot `v` of `to` may be that rounding alone makes different.
double knot_noise(double u, Interval from, double v, Interval to) {
    if (from == to) return 0.0;
    const double noise = std::abs(u) + std::abs(u - from.lower) + std::abs(v) / to.length() * from.length();
    return same_knot_in_ulps * std::numeric_limits<double>::epsilon() * noise;
}

std::vector<std::size_t> spans_of(const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    std::vector<std::size_t> spans;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1]) spans.push_back(s);
    return spans;
}

// The part of span `s` that begins at `lower` and ends at `upper`, which may be beyond it by rounding.
Interval inside_span(const KnotVector& knots, std::size_t s, double lower, double upper) {
    const Interval span{knots[s], knots[s + 1]};
    return {span.clamp(lower), span.clamp(upper)};
}

}  // namespace

std::vector<CommonSpan> common_spans(const Curve& a, const Curve& b) {
    const Interval of_a = a.domain();
    const Interval of_b = b.domain();
    const std::vector<std::size_t> spans_of_a = spans_of(a.knots());
    const std::vector<std::size_t> spans_of_b = spans_of(b.knots());
    std::vector<CommonSpan> result;
    double from_a = of_a.lower;
    double from_b = of_b.lower;
    for (std::size_t i = 0, j = 0; i < spans_of_a.size() && j < spans_of_b.size();) {
        const std::size_t s = spans_of_a[i];
        const std::size_t t = spans_of_b[j];
        double to_a = a.knots()[s + 1];
        double to_b = b.knots()[t + 1];
        const double noise = knot_noise(to_a, of_a, to_b, of_b);
        const double ahead = to_a - matched(to_b, of_b, of_a);
        if (ahead <= noise) ++i;
        if (ahead >= -noise) ++j;
        if (ahead < -noise) to_b = matched(to_a, of_a, of_b);
        if (ahead > noise) to_a = matched(to_b, of_b, of_a);
        result.push_back({s, t, inside_span(a.knots(), s, from_a, to_a), inside_span(b.knots(), t, from_b, to_b)});
        from_a = to_a;
        from_b = to_b;
    }
    return result;
}

bool is_written_alike(const Curve& a, const Curve& b, const CommonSpan& common) {
    if (a.degree() != b.degree() || common.part_of_a != common.part_of_b) return false;
    const auto p = static_cast<std::size_t>(a.degree());
    const auto knots_near = [p](const Curve& curve, std::size_t s) {
        return curve.knots().values().subspan(s - p + 1, 2 * p);
    };
    if (!std::ranges::equal(knots_near(a, common.span_of_a), knots_near(b, common.span_of_b))) return false;
    for (std::size_t j = 0; j <= p; ++j) {
        const std::size_t i = (common.span_of_a - p + j) % a.control_points().size();
        const std::size_t k = (common.span_of_b - p + j) % b.control_points().size();
        if (a.control_points()[i] != b.control_points()[k] || a.weights()[i] != b.weights()[k]) return false;
    }
    return true;
}

}  // namespace batten::core
