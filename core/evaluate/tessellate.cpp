#include "core/evaluate/tessellate.h"

#include <cassert>
#include <cmath>

#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

class Tessellator {
  public:
    Tessellator(const Curve& curve, const TessellationRequest& request) : curve_(curve), request_(request) {}

    void add_span(std::size_t span) {
        if (!is_span_visible(span)) return;
        BezierPiece piece = bezier_piece(curve_, span);
        if (piece.interval.lower < request_.range.lower) piece = cut_piece(piece, request_.range.lower).second;
        if (piece.interval.upper > request_.range.upper) piece = cut_piece(piece, request_.range.upper).first;
        tolerance_ = std::max(request_.tolerance, rounding_of_halving(control_box(piece.points)));
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

    void add_piece(const BezierPiece& piece, int depth) {
        const Box box = control_box(piece.points);
        if (!box.intersects(request_.view)) return;
        // Where products of weights and coordinates overflow there is no bound, and no finer.
        const bool is_curved = chord_deviation_bound(piece.points) > tolerance_;
        const bool is_fine = is_small_beside(box, request_.view, tolerance_) && !is_curved;
        if (is_fine || depth == most_chord_halvings || !is_divisible(piece.interval, box))
            return add_chord(piece.interval);
        const auto [left, right] = cut_piece(piece, middle(piece.interval));
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
