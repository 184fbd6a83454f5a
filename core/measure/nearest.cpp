#include "core/measure/nearest.h"

#include <cassert>
#include <cmath>

#include "core/base/detail/binomial.h"
#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// Distances closer than this part of the size are equal.
constexpr double relative_tolerance = 1e-14;

// A piece of this part of a span is left to Newton's iteration.
constexpr int most_nearest_halvings = 20;

constexpr int samples_in_piece = 4;
constexpr int most_nearest_steps = 40;
constexpr int most_step_halvings = 30;

// The piece is nearer than `radius` where this polynomial of degree 2p is negative, which is nowhere unless one of its
// Bernstein coefficients is:
//     |A(u) - w(u) Q|^2 - radius^2 w(u)^2
bool may_come_nearer(const BezierPiece& piece, Point query, double radius) {
    const std::size_t p = piece.points.size() - 1;
    const auto product = [&](std::size_t i, std::size_t j) {
        const HomogeneousPoint& a = piece.points[i];
        const HomogeneousPoint& b = piece.points[j];
        return (a.x - query.x * a.z) * (b.x - query.x * b.z) + (a.y - query.y * a.z) * (b.y - query.y * b.z) -
               radius * radius * a.z * b.z;
    };
    const auto of_p = binomials(p);
    for (std::size_t k = 0; k <= 2 * p; ++k) {
        double coefficient = 0.0;  // up to a positive factor
        for (std::size_t i = k > p ? k - p : 0; i <= std::min(k, p); ++i)
            coefficient += of_p[i] * of_p[k - i] * product(i, k - i);
        if (coefficient < 0.0) return true;
    }
    return false;
}

class NearestSearch {
  public:
    NearestSearch(const Curve& curve, Point query) : curve_(curve), query_(query), pieces_(bezier_pieces(curve)) {
        double size = 0.0;
        for (const Point& point : curve.control_points()) size = std::max(size, distance(point, query));
        tolerance_ = relative_tolerance * size;
        start_from_samples();
    }

    CurveSample run() {
        for (const BezierPiece& piece : pieces_) search(piece, piece.interval, 0);
        return best_;
    }

  private:
    struct Candidate {
        double u = 0.0;
        double distance = 0.0;
    };

    Candidate candidate_at(double u, Side side) const { return {u, distance(point_at(curve_, u, side), query_)}; }

    // The span is open at u = upper only, so this is the side inside it.
    static Side inner_side(double u, Interval span) { return u == span.upper ? Side::left : Side::right; }

    void start_from_samples() {
        Interval span_of_nearest = pieces_.front().interval;
        Candidate nearest{span_of_nearest.lower, std::numeric_limits<double>::infinity()};
        for (const BezierPiece& piece : pieces_)
            for (int k = 0; k <= samples_in_piece; ++k) {
                const double u = k == samples_in_piece
                                     ? piece.interval.upper
                                     : piece.interval.lower + piece.interval.length() * k / samples_in_piece;
                const Candidate candidate = candidate_at(u, inner_side(u, piece.interval));
                if (!(candidate.distance < nearest.distance - tolerance_)) continue;
                nearest = candidate;
                span_of_nearest = piece.interval;
            }
        accept(polished(nearest, span_of_nearest), span_of_nearest);
    }

    // Newton's iteration for (C - Q) C' = 0 inside one span, with steps halved until they lead no farther away.
    Candidate polished(Candidate at, Interval span) const {
        for (int i = 0; i < most_nearest_steps; ++i) {
            const auto derivatives = derivatives_at(curve_, at.u, 2, inner_side(at.u, span));
            const Vector away = derivatives.point - query_;
            const double slope = dot(away, derivatives[1]);
            const double speed_squared = dot(derivatives[1], derivatives[1]);
            const double bend = speed_squared + dot(away, derivatives[2]);
            if (slope == 0.0) break;
            // Where the distance bends the wrong way the curve is taken for straight.
            const double step = -slope / (bend > 0.0 ? bend : speed_squared);
            if (!std::isfinite(step)) break;
            Candidate next = candidate_at(span.clamp(at.u + step), inner_side(span.clamp(at.u + step), span));
            for (int k = 0; k < most_step_halvings && next.distance > at.distance + tolerance_; ++k) {
                const double u = middle({at.u, next.u});
                next = candidate_at(u, inner_side(u, span));
            }
            const bool is_done = std::abs(next.u - at.u) <= std::numeric_limits<double>::epsilon() * span.length();
            if (next.distance > at.distance + tolerance_) break;
            at = next;
            if (is_done) break;
        }
        return at;
    }

    void accept(Candidate candidate, Interval span) {
        best_ = {candidate.u, point_at(curve_, candidate.u, inner_side(candidate.u, span))};
        best_distance_ = candidate.distance;
    }

    // Left of the best point an equal distance counts, right of it only a smaller one.
    double distance_to_beat(Interval interval) const {
        return interval.lower < best_.u ? best_distance_ + tolerance_ : best_distance_ - tolerance_;
    }

    void offer(Candidate candidate, Interval span) {
        if (candidate.u == best_.u) return;
        if (candidate.distance < distance_to_beat({candidate.u, candidate.u})) accept(candidate, span);
    }

    void search(const BezierPiece& piece, Interval span, int depth) {
        const double radius = distance_to_beat(piece.interval);
        if (radius <= 0.0 || !may_come_nearer(piece, query_, radius)) return;
        const double half = middle(piece.interval);
        const bool is_divisible = piece.interval.lower < half && half < piece.interval.upper;
        if (depth == most_nearest_halvings || !is_divisible)
            return offer(polished(candidate_at(half, inner_side(half, span)), span), span);
        const auto [left, right] = cut_piece(piece, half);
        search(left, span, depth + 1);
        search(right, span, depth + 1);
    }

    const Curve& curve_;
    Point query_;
    BezierPieces pieces_;
    double tolerance_ = 0.0;
    CurveSample best_;
    double best_distance_ = 0.0;
};

}  // namespace

CurveSample nearest_point(const Curve& curve, Point query) {
    assert(is_finite(query));
    return NearestSearch(curve, query).run();
}

}  // namespace batten::core
