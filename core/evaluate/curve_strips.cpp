#include "core/evaluate/curve_strips.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/curve/detail/bspline.h"
#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// So many stretches looked at closely are kept in any case, others while they are used again and again: a picture asks
// for runs and knots several times.
constexpr std::size_t most_open_stretches = 1024;
constexpr std::size_t most_uses_between = 32;

// The control points of the curve over the spans `first`..`last`, both not empty, as a curve of its own with clamped
// ends, which the stretch stays in the hull of. By de Boor's algorithm at both ends.
std::vector<HomogeneousPoint> clamped_points(const Curve& curve, std::size_t first, std::size_t last) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::span<const double> values = curve.knots().values();
    std::vector<double> knots(values.begin() + static_cast<std::ptrdiff_t>(first - p),
                              values.begin() + static_cast<std::ptrdiff_t>(last + p + 2));
    std::vector<HomogeneousPoint> points;
    points.reserve(last - first + p + 1);
    for (std::size_t i = first - p; i <= last; ++i) points.push_back(curve.homogeneous_point(i));
    const double a = knots[p];
    for (std::size_t r = 1; r <= p; ++r)
        for (std::size_t i = r; i <= p; ++i)
            points[i - r] = blend_between(points[i - r], points[i - r + 1], knots[i], knots[i + p - r + 1], a);
    std::fill(knots.begin(), knots.begin() + static_cast<std::ptrdiff_t>(p), a);
    const std::size_t e = points.size() - 1;
    const double b = knots[e + 1];
    for (std::size_t r = 1; r <= p; ++r)
        for (std::size_t i = e; i >= e - p + r; --i)
            points[i] = blend_between(points[i - 1], points[i], knots[i], knots[i + p - r + 1], b);
    return points;
}

// Whether the chord shows the stretch of a piece well enough.
bool is_fine(const Strip& strip, const ChordRequest& request) {
    const double tolerance = std::max(request.tolerance, rounding_of_halving(strip.box));
    return is_small_beside(strip.box, request.view, tolerance) && !(strip.deviation > tolerance);
}

// The chords of a piece, halved as far as needed.
void take_chords(const BezierPiece& piece, const ChordRequest& request, int depth = 0) {
    const Strip strip{.first = project(piece.points.front()),
                      .last = project(piece.points.back()),
                      .box = control_box(piece.points),
                      .deviation = chord_deviation_bound(piece.points)};
    if (!is_seen(strip, request)) return;
    if (is_fine(strip, request) || depth == most_chord_halvings || !is_divisible(piece.interval, strip.box))
        return request.take(strip.first, strip.last);
    const auto [left, right] = cut_piece(piece, middle(piece.interval));
    take_chords(left, request, depth + 1);
    take_chords(right, request, depth + 1);
}

// The same for piece k; one without weights is looked at where it is.
void take_chords(const BezierPieces& pieces, std::size_t k, const ChordRequest& request) {
    if (!pieces.weights(k).empty()) return take_chords(pieces[k], request);
    const std::span<const Point> points = pieces.points(k);
    Strip strip{.first = points.front(), .last = points.back(), .box = {}, .deviation = chord_deviation_bound(points)};
    for (const Point point : points) strip.box.include(point);
    if (!is_seen(strip, request)) return;
    if (is_fine(strip, request)) return request.take(strip.first, strip.last);
    take_chords(pieces[k], request);
}

// The size of what may be thin or long, for a strip whose numbers overflow.
Strip boundless_strip(Point first, Point last) {
    constexpr double infinity = Box::infinity;
    return {first, last, {{-infinity, -infinity}, {infinity, infinity}}, infinity, true};
}

}  // namespace

// Goes down to what is seen, halving as far as needed.
class CurveStrips::Search {
  public:
    enum class Outside { left_out, as_chords };

    Search(CurveStrips& strips, const StripRequest& request, ItemRange range, Outside outside = Outside::left_out)
        : strips_(strips), request_(request), range_(range), outside_(outside), runs_(request.most_places) {}

    RunCollector search() {
        strips_.stretches_.visit(
            [&](const Strip& strip, std::size_t first, std::size_t last) {
                return is_to_enter(strip, strips_.stretch_spans_.items(first, last));
            },
            [&](std::size_t stretch) { search_stretch(stretch); });
        return std::move(runs_);
    }

  private:
    bool is_to_enter(const Strip& strip, ItemRange spans) {
        if (runs_.is_full() || spans.end <= range_.first || range_.end <= spans.first) return false;
        if (!strip.box.intersects(request_.view)) return pass_by(strip);
        const bool is_inside = range_.first <= spans.first && spans.end <= range_.end;
        if (!is_inside || !is_small_beside(strip.box, request_.view, request_.tolerance)) return true;
        return !add_if_simple(strip, request_.tolerance, runs_);
    }

    // A strip outside of the view may be its chord, if that is one line.
    bool pass_by(const Strip& strip) {
        if (outside_ == Outside::left_out) return false;
        if (!strip.is_whole) return true;
        runs_.add(strip.first, strip.last);
        return false;
    }

    void search_stretch(std::size_t stretch) {
        OpenStretch& open = strips_.opened(stretch);
        const std::size_t base = strips_.stretch_spans_[stretch].first;
        open.spans.visit(
            [&](const Strip& strip, std::size_t first, std::size_t last) {
                return is_to_enter(strip, {base + first, base + last + 1});
            },
            [&](std::size_t k) {
                const Strip& span = open.parts[k].front().strip;
                noise_ = rounding_of_halving(span.box);
                search_part(open.parts[k], 0, 0);
            });
    }

    void search_part(SpanParts& parts, std::size_t i, int depth) {
        const Strip strip = parts[i].strip;
        const double tolerance = std::max(request_.tolerance, noise_);
        if (runs_.is_full()) return;
        if (!strip.box.intersects(request_.view)) return static_cast<void>(pass_by(strip));
        const bool is_fine = is_small_beside(strip.box, request_.view, tolerance) && strip.deviation <= tolerance;
        if (is_fine || depth == most_chord_halvings || !is_divisible(parts[i].interval, strip.box))
            return runs_.add(strip.first, strip.last);
        if (parts[i].parts == 0) strips_.halve(parts, i);
        const std::size_t first_half = parts[i].parts;
        search_part(parts, first_half, depth + 1);
        search_part(parts, first_half + 1, depth + 1);
    }

    CurveStrips& strips_;
    const StripRequest& request_;
    ItemRange range_;
    Outside outside_;
    double noise_ = 0.0;
    RunCollector runs_;
};

CurveStrips::CurveStrips(std::shared_ptr<const Curve> curve)
    : curve_(std::move(curve)), stretch_spans_({first_span(), span_end()}) {
    std::vector<Strip> stretches;
    stretches.reserve(stretch_spans_.size());
    for (std::size_t i = 0; i < stretch_spans_.size(); ++i) stretches.push_back(strip_of_stretch(i));
    stretches_ = StripTree(std::move(stretches));
    open_.resize(stretch_spans_.size());
}

double CurveStrips::rounding() const {
    return rounding_of_halving(box());
}

ItemRange CurveStrips::spans_over(Interval range) const {
    const KnotVector& knots = curve_->knots();
    const Interval domain = curve_->domain();
    return {range.lower <= domain.lower ? first_span() : knots.span_at(range.lower),
            range.upper >= domain.upper ? span_end() : knots.span_at(range.upper, Side::left) + 1};
}

std::optional<PointRuns> CurveStrips::runs(const StripRequest& request, Interval range) {
    ++use_;
    assert(request.tolerance > 0.0);
    RunCollector runs = Search(*this, request, spans_over(range)).search();
    drop_unused();
    if (runs.is_full()) return std::nullopt;
    return runs.take();
}

std::optional<PointRuns> CurveStrips::outline(const StripRequest& request) {
    ++use_;
    assert(request.tolerance > 0.0);
    RunCollector runs = Search(*this, request, {first_span(), span_end()}, Search::Outside::as_chords).search();
    drop_unused();
    if (runs.is_full()) return std::nullopt;
    return runs.take();
}

void CurveStrips::visit_chords(const ChordRequest& request, Interval range,
                               std::span<const std::size_t> left_out) const {
    assert(request.tolerance > 0.0);
    const ItemRange wanted = spans_over(range);
    const auto enter = [&](const Strip& strip, std::size_t first, std::size_t last) {
        const ItemRange spans = stretch_spans_.items(first, last);
        if (spans.end <= wanted.first || wanted.end <= spans.first || !is_seen(strip, request)) return false;
        const bool is_whole =
            wanted.first <= spans.first && spans.end <= wanted.end && !has_any(left_out, spans.first, spans.end - 1);
        const bool is_simple =
            strip.deviation <= request.tolerance && is_small_beside(strip.box, request.view, request.tolerance);
        if (!is_whole || !is_simple) return true;
        request.take(strip.first, strip.last);
        return false;
    };
    stretches_.visit_scattered(enter, [&](std::size_t stretch) {
        const ItemRange spans = stretch_spans_[stretch];
        const BezierPieces pieces =
            bezier_pieces(*curve_, std::max(spans.first, wanted.first), std::min(spans.end, wanted.end) - 1);
        for (std::size_t k = 0; k < pieces.size(); ++k)
            if (!has_any(left_out, pieces.span(k), pieces.span(k))) take_chords(pieces, k, request);
    });
}

void CurveStrips::visit_span_chords(const ChordRequest& request, std::size_t span) const {
    if (curve_->knots()[span] == curve_->knots()[span + 1]) return;
    take_chords(bezier_piece(*curve_, span), request);
}

bool CurveStrips::is_torn_at(std::size_t span) const {
    return curve_->knots()[span - first_span()] == curve_->knots()[span];
}

// Where a span begins the one before ends, bit by bit, unless the curve may come apart there.
Point CurveStrips::start_of(std::size_t span) const {
    const double u = curve_->knots()[span];
    const bool is_start = u == curve_->domain().lower;
    return point_at(*curve_, u, is_start || is_torn_at(span) ? Side::right : Side::left);
}

Strip CurveStrips::strip_of_piece(const BezierPiece& piece, Point first) const {
    Strip strip{
        .first = first, .last = point_at(*curve_, piece.interval.upper, Side::left), .box = control_box(piece.points)};
    if (!is_finite(strip.box.lower) || !is_finite(strip.box.upper)) return boundless_strip(strip.first, strip.last);
    strip.box.include(strip.first);
    strip.box.include(strip.last);
    // Where products of weights and coordinates overflow there is no bound, and no finer.
    const double bound = chord_deviation_bound(piece.points);
    strip.deviation = std::isnan(bound) ? 0.0 : bound;
    return strip;
}

Strip CurveStrips::strip_of_stretch(std::size_t stretch) {
    ++stretch_count_;
    const KnotVector& knots = curve_->knots();
    std::size_t first = stretch_spans_[stretch].first;
    std::size_t last = stretch_spans_[stretch].end - 1;
    while (first <= last && knots[first] == knots[first + 1]) ++first;
    while (first <= last && knots[last] == knots[last + 1]) --last;
    if (first > last) return {};
    std::vector<Point> hull{start_of(first)};
    for (const HomogeneousPoint& point : clamped_points(*curve_, first, last)) hull.push_back(project(point));
    hull.push_back(point_at(*curve_, knots[last + 1], Side::left));
    if (!std::all_of(hull.begin(), hull.end(), [](Point point) { return is_finite(point); }))
        return boundless_strip(hull.front(), hull.back());
    Strip strip = strip_of(hull);
    for (std::size_t s = first + 1; s <= last; ++s)
        if (knots[s] < knots[s + 1] && is_torn_at(s)) strip.is_whole = false;
    if (!strip.is_whole) strip.deviation = length(strip.box.size());
    return strip;
}

CurveStrips::SpanParts CurveStrips::parts_of_span(std::size_t span) {
    if (curve_->knots()[span] == curve_->knots()[span + 1]) return {Part{}};
    ++span_count_;
    BezierPiece piece = bezier_piece(*curve_, span);
    return {Part{strip_of_piece(piece, start_of(span)), piece.interval, 0, std::move(piece.points)}};
}

CurveStrips::OpenStretch& CurveStrips::opened(std::size_t stretch) {
    std::unique_ptr<OpenStretch>& open = open_[stretch];
    if (!open) {
        open = std::make_unique<OpenStretch>();
        ++open_count_;
        const ItemRange range = stretch_spans_[stretch];
        std::vector<Strip> spans;
        for (std::size_t s = range.first; s < range.end; ++s) {
            open->parts.push_back(parts_of_span(s));
            spans.push_back(open->parts.back().front().strip);
        }
        open->spans = StripTree(std::move(spans));
    }
    open->last_use = use_;
    return *open;
}

void CurveStrips::halve(SpanParts& parts, std::size_t part) const {
    const BezierPiece piece{parts[part].interval, 0, std::move(parts[part].points)};
    auto [left, right] = cut_piece(piece, middle(piece.interval));
    const Strip left_strip = strip_of_piece(left, parts[part].strip.first);
    const Strip right_strip = strip_of_piece(right, left_strip.last);
    parts[part].points = {};
    parts[part].parts = parts.size();
    parts.push_back({left_strip, left.interval, 0, std::move(left.points)});
    parts.push_back({right_strip, right.interval, 0, std::move(right.points)});
}

// Stretches that have not been looked at for some time are closed again where there are too many.
void CurveStrips::drop_unused() {
    if (open_count_ <= most_open_stretches) return;
    for (std::unique_ptr<OpenStretch>& open : open_) {
        if (!open || open->last_use + most_uses_between > use_) continue;
        open.reset();
        --open_count_;
    }
}

}  // namespace batten::core
