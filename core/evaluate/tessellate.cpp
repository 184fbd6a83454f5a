#include "core/evaluate/tessellate.h"

#include <cassert>
#include <cmath>

#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// More halvings than a double has digits find nothing new.
constexpr int most_chord_halvings = 60;

// Halving rounds the control points; a bound that asks for less than this many units in the last place would chase
// noise.
constexpr double noise_in_ulps = 32.0;

// A straight piece that is this much larger than the view is halved all the same, so that what goes to the screen stays
// within the range of its smaller numbers.
constexpr double largest_piece_in_views = 64.0;

double distance_to_segment(Point point, Point a, Point b) {
    const Vector along = b - a;
    const double length_squared = dot(along, along);
    if (length_squared == 0.0) return distance(point, a);
    return distance(point, a + std::clamp(dot(point - a, along) / length_squared, 0.0, 1.0) * along);
}

// The most that the inner control points count together at any point of the piece. For equal weights it is 1 - 2^(1-p),
// reached in the middle; for others at most that of inner weights all as large, and end weights all as small, as the
// extreme ones.
double largest_inner_share(const BezierPiece& piece) {
    const double share = 1.0 - std::exp2(2.0 - static_cast<double>(piece.points.size()));
    double largest_inner = 0.0;
    for (std::size_t i = 1; i + 1 < piece.points.size(); ++i)
        largest_inner = std::max(largest_inner, piece.points[i].z);
    const double end_to_inner = std::min(piece.points.front().z, piece.points.back().z) / largest_inner;
    return share / ((1.0 - share) * end_to_inner + share);
}

// A bound of the distance from the piece to its chord: C(u) is a mean of a point of the chord and one of the inner
// hull.
double chord_deviation_bound(const BezierPiece& piece) {
    const Point a = project(piece.points.front());
    const Point b = project(piece.points.back());
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < piece.points.size(); ++i)
        largest = std::max(largest, distance_to_segment(project(piece.points[i]), a, b));
    return largest == 0.0 ? 0.0 : largest * largest_inner_share(piece);
}

double largest_coordinate(const Box& box) {
    const double x = std::max(std::abs(box.lower.x), std::abs(box.upper.x));
    return std::max({x, std::abs(box.lower.y), std::abs(box.upper.y)});
}

class Tessellator {
  public:
    Tessellator(const Curve& curve, const TessellationRequest& request) : curve_(curve), request_(request) {}

    void add_span(std::size_t span) {
        if (!is_span_visible(span)) return;
        BezierPiece piece = bezier_piece(curve_, span);
        if (piece.interval.lower < request_.range.lower) piece = cut_piece(piece, request_.range.lower).second;
        if (piece.interval.upper > request_.range.upper) piece = cut_piece(piece, request_.range.upper).first;
        const double noise =
            noise_in_ulps * std::numeric_limits<double>::epsilon() * largest_coordinate(control_box(piece));
        tolerance_ = std::max(request_.tolerance, noise);
        may_connect_ = !is_torn_at(span);
        add_piece(piece, 0);
    }

    std::vector<std::vector<CurveSample>> take_runs() { return std::move(runs_); }

  private:
    // By the span's own control points, which costs less than its Bézier points.
    bool is_span_visible(std::size_t span) const {
        const auto p = static_cast<std::size_t>(curve_.degree());
        Box box;
        for (std::size_t i = span - p; i <= span; ++i) box.include(project(curve_.homogeneous_point(i)));
        return box.intersects(request_.view);
    }

    bool is_torn_at(std::size_t span) const {
        return curve_.knots()[span - static_cast<std::size_t>(curve_.degree())] == curve_.knots()[span];
    }

    bool is_small_enough(const Box& box) const {
        const Vector piece_size = box.size();
        const Vector view_size = request_.view.size();
        const double largest = std::max(largest_piece_in_views * std::max(view_size.x, view_size.y), tolerance_);
        return std::max(piece_size.x, piece_size.y) <= largest;
    }

    void add_piece(const BezierPiece& piece, int depth) {
        const Box box = control_box(piece);
        if (!box.intersects(request_.view)) return;
        const double half = middle(piece.interval);
        const bool is_divisible = depth < most_chord_halvings && piece.interval.lower < half &&
                                  half < piece.interval.upper && std::isfinite(largest_coordinate(box));
        // Where products of weights and coordinates overflow there is no bound, and no finer.
        const bool is_curved = chord_deviation_bound(piece) > tolerance_;
        if (!is_divisible || (is_small_enough(box) && !is_curved)) return add_chord(piece.interval);
        const auto [left, right] = cut_piece(piece, half);
        add_piece(left, depth + 1);
        add_piece(right, depth + 1);
    }

    // Samples are evaluated from the curve and not taken from the halved points, so that a parameter has the same point
    // in every view.
    void add_chord(Interval interval) {
        const bool continues = may_connect_ && !runs_.empty() && runs_.back().back().u == interval.lower;
        if (!continues) runs_.push_back({{interval.lower, point_at(curve_, interval.lower, Side::right)}});
        runs_.back().push_back({interval.upper, point_at(curve_, interval.upper, Side::left)});
        may_connect_ = true;
    }

    const Curve& curve_;
    const TessellationRequest& request_;
    double tolerance_ = 0.0;
    bool may_connect_ = true;
    std::vector<std::vector<CurveSample>> runs_;
};

}  // namespace

std::vector<std::vector<CurveSample>> tessellate(const Curve& curve, const TessellationRequest& request) {
    assert(request.tolerance > 0.0);
    Tessellator tessellator(curve, request);
    const auto knots = curve.knots().values();
    const Interval domain = curve.domain();
    const Interval wanted{std::max(domain.lower, request.range.lower), std::min(domain.upper, request.range.upper)};
    if (!(wanted.lower < wanted.upper)) return {};
    const std::size_t last = curve.knots().span_at(wanted.upper, Side::left);
    for (std::size_t span = curve.knots().span_at(wanted.lower); span <= last; ++span)
        if (knots[span] < knots[span + 1]) tessellator.add_span(span);
    return tessellator.take_runs();
}

}  // namespace batten::core
