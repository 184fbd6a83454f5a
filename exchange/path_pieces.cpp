#include "exchange/path_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/refine/split.h"
#include "exchange/cubic_fit.h"

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

constexpr int most_halvings_of_one = 30;

double farthest_coordinate(std::span<const Point> points) {
    double farthest = 0.0;
    for (const Point point : points) farthest = std::max({farthest, std::abs(point.x), std::abs(point.y)});
    return farthest;
}

struct Arc {
    PathPiece piece{};
    double error = 0.0;
};

// The piece as an arc of a circle where nothing but rounding is against it: its legs are equally long, and the weight
// is the sine of half the angle between them.
std::optional<Arc> circular_arc(std::span<const Point> points, std::span<const double> weights) {
    constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
    constexpr double most_share = 1e-3;
    constexpr double exact_share = 1e-9;
    const Vector first = points[1] - points[0];
    const Vector second = points[2] - points[1];
    const double leg = core::robust_length(first);
    const double half_chord = core::robust_length(points[2] - points[0]) / 2.0;
    const double height = core::robust_length(points[1] - core::middle(points[0], points[2]));
    const double farthest = farthest_coordinate(points);
    if (!(leg > 0.0 && height > 0.0 && half_chord > 0.0) || !std::isfinite(leg + farthest)) return std::nullopt;
    const double weight = weights[1] / (std::sqrt(weights[0]) * std::sqrt(weights[2]));
    // Coordinates that are rounded far from the origin tell less of the angle.
    const double share = rounding * (1.0 + farthest / leg);
    const double off = std::max(std::abs(core::robust_length(second) / leg - 1.0), std::abs(weight - half_chord / leg));
    if (!(off <= share && share <= most_share)) return std::nullopt;
    return Arc{{.degree = 0,
                .points = {points[0], points[2]},
                .radius = leg * half_chord / height,
                .is_counterclockwise = core::cross(first, second) > 0.0},
               share > exact_share ? 4.0 * share * leg : 0.0};
}

PathPiece plain_piece(std::span<const Point> points) {
    PathPiece piece{.degree = static_cast<int>(points.size()) - 1};
    std::copy(points.begin(), points.end(), piece.points.begin());
    return piece;
}

// A power of two near the largest coordinate where that is extreme, so that nothing overflows on the way; else 1.
double unit_of(std::span<const Point> points) {
    constexpr int most_exponent = 300;
    const double farthest = farthest_coordinate(points);
    if (!(farthest > 0.0) || !std::isfinite(farthest)) return 1.0;
    const int exponent = std::ilogb(farthest);
    return std::abs(exponent) > most_exponent ? std::scalbn(1.0, exponent) : 1.0;
}

core::Result<core::Curve> bezier_curve(std::span<const Point> points, std::span<const double> weights, double unit) {
    core::CurveDefinition definition{.degree = static_cast<int>(points.size()) - 1,
                                     .weights = {weights.begin(), weights.end()}};
    for (const Point point : points) definition.points.push_back({point.x / unit, point.y / unit});
    definition.knots.assign(points.size(), 0.0);
    definition.knots.insert(definition.knots.end(), points.size(), 1.0);
    return core::Curve::make(std::move(definition));
}

// Nothing is nearer to a curve than the numbers of its points are to what they stand for.
double rounding_of(const core::Curve& curve) {
    return 4.0 * std::numeric_limits<double>::epsilon() * farthest_coordinate(curve.control_points());
}

bool all_equal(std::span<const double> weights) {
    return std::ranges::all_of(weights, [&](double weight) { return weight == weights.front(); });
}

// How far what is computed of a curve may be from it by rounding, after steps that each put a point between two others:
// main + share (other - main), with a share of 1/2 at most. The sum is rounded by half an epsilon of the largest
// coordinate, in the plane of 0.71 epsilon. The rest is of the size of the curve alone: 13 roundings of the second term
// by half an epsilon of half of it, in the plane 4.6; and 6 of the new weight, which moves the curve by 3.
class StepRounding {
  public:
    explicit StepRounding(const core::Curve& curve) : p_(static_cast<double>(curve.degree())) {
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        const core::Box box = core::control_box(curve);
        const double half_size = core::robust_length(box.upper - core::middle(box.lower, box.upper));
        of_step_ = epsilon * farthest_coordinate(curve.control_points()) + 16.0 * epsilon * half_size;
    }

    // For a half of a half ... of the Bézier curve over a span. To get that, p knots are inserted at both of its ends,
    // where the last of them rests on p, p - 1, ... steps at the knots after it; a halving takes p steps. The ends of
    // spans are moved onto those of their neighbors, which are as far off themselves.
    double after(int halvings) const {
        const double of_span = p_ * (p_ + 1.0) / 2.0 + p_;
        return (3.0 * of_span + p_ * halvings) * of_step_;
    }

  private:
    double p_;
    double of_step_ = 0.0;
};

class PathMaker {
  public:
    PathMaker(const core::Curve& curve, double tolerance, Arcs arcs, std::size_t most_halvings)
        : rounding_(curve), tolerance_(tolerance), arcs_(arcs), halvings_left_(most_halvings) {}

    // The piece over one span.
    void add(std::span<const Point> points, std::span<const double> weights, bool is_torn) {
        const std::size_t first = made_.pieces.size();
        const std::size_t p = points.size() - 1;
        if (p == 1 || (p <= 3 && all_equal(weights)))
            made_.pieces.push_back(plain_piece(points));
        else if (const auto arc = p == 2 && arcs_ == Arcs::as_arcs ? circular_arc(points, weights) : std::nullopt)
            add_arc(*arc);
        else
            add_cubics(points, weights);
        made_.pieces.back().set_end(points.back());
        const auto is_double = [](Point point) { return core::is_finite(point); };
        if (!std::ranges::all_of(points, is_double)) made_.error = std::numeric_limits<double>::infinity();
        join(made_.pieces[first], points.front(), first == 0 ? nullptr : &made_.pieces[first - 1], is_torn);
    }

    PathPieces take(bool is_periodic) && {
        if (is_periodic) made_.pieces.back().set_end(made_.pieces.front().start());
        std::size_t first = 0;
        for (std::size_t k = 0; k < made_.pieces.size(); ++k) {
            if (made_.pieces[k].is_first) first = k;
            const bool is_last = k + 1 == made_.pieces.size() || made_.pieces[k + 1].is_first;
            const bool is_a_line = first == k && made_.pieces[k].degree == 1;
            made_.pieces[k].closes = is_last && !is_a_line && made_.pieces[k].end() == made_.pieces[first].start();
        }
        return std::move(made_);
    }

  private:
    // Where a curve does not come apart its pieces have the same point at their joint, whatever the rounding.
    static void join(PathPiece& piece, Point start, const PathPiece* before, bool is_torn) {
        piece.is_first = before == nullptr || (is_torn && before->end() != start);
        piece.points[0] = piece.is_first ? start : before->end();
    }

    void add_arc(const Arc& arc) {
        made_.pieces.push_back(arc.piece);
        made_.error = std::max(made_.error, arc.error);
    }

    void add_cubics(std::span<const Point> points, std::span<const double> weights) {
        const double unit = unit_of(points);
        if (const auto piece = bezier_curve(points, weights, unit)) return add_halves(with_even_ends(*piece), unit);
        // Beyond doubles, where nothing is known of the error.
        made_.error = std::numeric_limits<double>::infinity();
        made_.pieces.push_back({.points = {points.front(), points.back()}});
    }

    void add_halves(const core::Curve& curve, double unit, int halvings = most_halvings_of_one) {
        const double rounding = rounding_.after(most_halvings_of_one - halvings);
        const double wanted = std::max(rounding_of(curve), std::max(tolerance_ - rounding, 0.5 * tolerance_) / unit);
        const CubicFit fit = cubic_fit(curve, wanted);
        if (fit.error > wanted && halvings > 0 && halvings_left_ > 0 && std::isfinite(fit.error)) {
            if (const auto halves = core::split(curve, 0.5)) {
                --halvings_left_;
                for (const core::Curve& half : *halves) add_halves(with_even_ends(half), unit, halvings - 1);
                return;
            }
        }
        PathPiece piece{.degree = 3};
        std::ranges::transform(fit.points, piece.points.begin(),
                               [unit](Point point) { return Point(point.x * unit, point.y * unit); });
        if (!made_.pieces.empty()) piece.points[0] = made_.pieces.back().end();
        made_.pieces.push_back(piece);
        made_.error = std::max(made_.error, fit.error * unit + rounding);
    }

    StepRounding rounding_;
    double tolerance_;
    Arcs arcs_;
    std::size_t halvings_left_;
    PathPieces made_;
};

}  // namespace

PathPieces path_pieces(const core::Curve& curve, double tolerance, Arcs arcs, std::size_t most_halvings) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const core::BezierPieces spans = core::bezier_pieces(curve);
    PathMaker maker(curve, tolerance, arcs, most_halvings);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        const std::size_t span = spans.span(k);
        const bool is_torn = k > 0 && knots[span - p] == knots[span];
        maker.add(spans.points(k), spans.weights(k), is_torn);
    }
    return std::move(maker).take(curve.is_periodic());
}

}  // namespace batten::exchange
