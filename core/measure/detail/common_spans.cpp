#include "core/measure/detail/common_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

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

// Spans [first, end) of a knot vector, empty ones among them.
struct SpanRange {
    std::size_t first = 0;
    std::size_t end = 0;
};

SpanRange all_spans(const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    return {p, knots.size() - p - 1};
}

// How many values both begin with.
template <class T>
std::size_t common_beginning(std::span<const T> a, std::span<const T> b) {
    if (a.data() == b.data()) return std::min(a.size(), b.size());
    return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

// How many values both end with.
template <class T>
std::size_t common_end(std::span<const T> a, std::span<const T> b) {
    const std::size_t most = std::min(a.size(), b.size());
    if (a.data() == b.data() && a.size() == b.size()) return most;
    const auto last = a.rbegin() + static_cast<std::ptrdiff_t>(most);
    return static_cast<std::size_t>(std::mismatch(a.rbegin(), last, b.rbegin()).first - a.rbegin());
}

std::size_t less_by(std::size_t count, std::size_t by) {
    return count - std::min(count, by);
}

// How many spans, also empty ones, both curves begin with that are written alike: span s depends on the knots
// s-p+1..s+p and the control points s-p..s.
std::size_t first_difference(const Curve& a, const Curve& b) {
    const auto p = static_cast<std::size_t>(a.degree());
    const std::size_t knots = common_beginning(a.knots().values(), b.knots().values());
    return std::min({less_by(knots, p), common_beginning(a.control_points(), b.control_points()),
                     common_beginning(a.weights(), b.weights())});
}

// How many both end with. The last spans of a periodic curve depend on its first control points.
std::size_t spans_alike_at_end(const Curve& a, const Curve& b, std::size_t first) {
    const auto p = static_cast<std::size_t>(a.degree());
    if (a.is_periodic() && first < p) return 0;
    const std::size_t knots = common_end(a.knots().values(), b.knots().values());
    const std::size_t points =
        std::min(common_end(a.control_points(), b.control_points()), common_end(a.weights(), b.weights()));
    return std::min(less_by(knots, 2 * p), a.is_periodic() ? points : less_by(points, p));
}

// The spans of both curves but those at the beginning and at the end that are written alike.
struct DifferingWindow {
    SpanRange of_a;
    SpanRange of_b;
};

DifferingWindow differing_window(const Curve& a, const Curve& b) {
    DifferingWindow window{all_spans(a.knots()), all_spans(b.knots())};
    if (a.degree() != b.degree() || a.is_periodic() != b.is_periodic() || a.domain() != b.domain()) return window;
    const std::size_t end = std::min(window.of_a.end, window.of_b.end);
    const std::size_t first = first_difference(a, b);
    window.of_a.first = window.of_b.first = std::clamp(first, window.of_a.first, end);
    const std::size_t alike = std::min(spans_alike_at_end(a, b, first), end - window.of_a.first);
    window.of_a.end -= alike;
    window.of_b.end -= alike;
    return window;
}

std::vector<std::size_t> spans_of(const KnotVector& knots, SpanRange range) {
    std::vector<std::size_t> spans;
    for (std::size_t s = range.first; s < range.end; ++s)
        if (knots[s] < knots[s + 1]) spans.push_back(s);
    return spans;
}

// The part of span `s` that begins at `lower` and ends at `upper`, which may be beyond it by rounding.
Interval inside_span(const KnotVector& knots, std::size_t s, double lower, double upper) {
    const Interval span{knots[s], knots[s + 1]};
    return {span.clamp(lower), span.clamp(upper)};
}

// Whether both curves are the same there because they are written the same: no computation can tell them apart.
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

}  // namespace

std::vector<CommonSpan> differing_spans(const Curve& a, const Curve& b) {
    const Interval of_a = a.domain();
    const Interval of_b = b.domain();
    const DifferingWindow window = differing_window(a, b);
    const std::vector<std::size_t> spans_of_a = spans_of(a.knots(), window.of_a);
    const std::vector<std::size_t> spans_of_b = spans_of(b.knots(), window.of_b);
    std::vector<CommonSpan> result;
    double from_a = a.knots()[window.of_a.first];
    double from_b = b.knots()[window.of_b.first];
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
        const CommonSpan common{s, t, inside_span(a.knots(), s, from_a, to_a), inside_span(b.knots(), t, from_b, to_b)};
        if (!is_written_alike(a, b, common)) result.push_back(common);
        from_a = to_a;
        from_b = to_b;
    }
    return result;
}

}  // namespace batten::core
