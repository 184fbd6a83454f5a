#include "exchange/cubic_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/refine/split.h"

namespace batten::exchange {

namespace {

constexpr int most_halvings = 20;

core::Result<core::Curve> bezier_curve(std::span<const core::Point> points, std::span<const double> weights,
                                       core::Interval interval) {
    core::CurveDefinition definition{.degree = static_cast<int>(points.size()) - 1,
                                     .points = {points.begin(), points.end()},
                                     .weights = {weights.begin(), weights.end()}};
    definition.knots.assign(points.size(), interval.lower);
    definition.knots.insert(definition.knots.end(), points.size(), interval.upper);
    return core::Curve::make(std::move(definition));
}

CubicPiece line_between(core::Point first, core::Point last) {
    return {.degree = 1, .points = {first, last}};
}

// Handles along the tangents such that the cubic passes the middle of the curve; none where they would point back or
// lead far beyond the ends.
std::optional<CubicPiece> through_middle(const core::Curve& curve, core::Point first, core::Point last) {
    const core::Interval domain = curve.domain();
    const auto leaving = core::tangent_at(curve, domain.lower, core::Side::right);
    const auto arriving = core::tangent_at(curve, domain.upper, core::Side::left);
    if (!leaving || !arriving) return std::nullopt;
    const core::Point middle = core::point_at(curve, domain.lower + 0.5 * (domain.upper - domain.lower));
    const core::Vector wanted = 8.0 / 3.0 * (middle - core::middle(first, last));
    const double area = core::cross(*leaving, *arriving);
    const double a = core::cross(wanted, *arriving) / area;
    const double b = core::cross(wanted, *leaving) / area;
    const double most = 4.0 * (core::robust_length(middle - first) + core::robust_length(last - middle));
    const auto is_usable = [most](double handle) { return handle >= 0.0 && handle <= most; };
    if (!is_usable(a) || !is_usable(b)) return std::nullopt;
    return CubicPiece{.points = {first, first + a * *leaving, last - b * *arriving, last}};
}

// The cubic with the same points and derivatives at its ends.
CubicPiece with_end_derivatives(const core::Curve& curve, core::Point first, core::Point last) {
    const core::Interval domain = curve.domain();
    const double third = (domain.upper - domain.lower) / 3.0;
    const auto handle = [&](double u, core::Side side) {
        return third * core::derivatives_at(curve, u, 1, side).derivatives.front();
    };
    return {.points = {first, first + handle(domain.lower, core::Side::right),
                       last - handle(domain.upper, core::Side::left), last}};
}

bool all_finite(const CubicPiece& piece) {
    return std::ranges::all_of(piece.control_points(), [](core::Point point) { return core::is_finite(point); });
}

struct Guess {
    CubicPiece piece;
    // Bernstein coefficients of the parameter of the piece, over that of the curve in [0, 1].
    std::array<double, 5> parameter{0.0, 0.25, 0.5, 0.75, 1.0};
};

// The cubic passes the middle of the curve at its own middle and leaves and arrives with other speeds; a parameter of
// degree 4 makes them those of the curve.
std::array<double, 5> matched_parameter(const core::Curve& curve, const CubicPiece& piece) {
    const CubicPiece same_speed = with_end_derivatives(curve, piece.points[0], piece.points[3]);
    const auto ratio = [&](std::size_t end, std::size_t handle) {
        return core::robust_length(same_speed.points[handle] - piece.points[end]) /
               core::robust_length(piece.points[handle] - piece.points[end]);
    };
    const double second = 0.25 * ratio(0, 1);
    const double fourth = 1.0 - 0.25 * ratio(3, 2);
    const std::array<double, 5> wanted{0.0, second, (7.0 - 4.0 * (second + fourth)) / 6.0, fourth, 1.0};
    const bool is_usable = std::ranges::all_of(wanted, [](double value) { return 0.0 <= value && value <= 1.0; });
    return is_usable ? wanted : Guess{}.parameter;
}

// With the tangents of the curve, and few pieces where it is smooth.
std::optional<Guess> smooth_guess(const core::Curve& curve) {
    const auto piece = through_middle(curve, curve.control_points().front(), curve.control_points().back());
    if (!piece || !all_finite(*piece)) return std::nullopt;
    return Guess{*piece, matched_parameter(curve, *piece)};
}

// With the derivatives of the curve, which it nears by every halving, also around a cusp.
Guess plain_guess(const core::Curve& curve) {
    const core::Point first = curve.control_points().front();
    const core::Point last = curve.control_points().back();
    if (const CubicPiece piece = with_end_derivatives(curve, first, last); all_finite(piece)) return {piece};
    return {{.points = {first, first, last, last}}};
}

// The binomial coefficients of n.
std::vector<double> choices_of(std::size_t n) {
    std::vector<double> choices(n + 1, 1.0);
    for (std::size_t i = 0; i < n; ++i)
        choices[i + 1] = choices[i] * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return choices;
}

// The product of two polynomials in Bernstein form.
std::vector<double> product(std::span<const double> a, std::span<const double> b) {
    const auto of_a = choices_of(a.size() - 1);
    const auto of_b = choices_of(b.size() - 1);
    const auto of_both = choices_of(a.size() + b.size() - 2);
    std::vector<double> result(of_both.size(), 0.0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += of_a[i] * a[i] * of_b[j] * b[j];
    for (std::size_t k = 0; k < result.size(); ++k) result[k] /= of_both[k];
    return result;
}

// The control points of D(phi(t)), of degree 12, seen from the first one.
std::vector<core::Vector> composed(const Guess& guess) {
    const std::span<const double> phi = guess.parameter;
    std::array<double, 5> rest{};
    std::ranges::transform(phi, rest.begin(), [](double value) { return 1.0 - value; });
    std::vector<core::Vector> result(13, {0.0, 0.0});
    const auto add = [&](double factor, std::span<const double> a, std::span<const double> b, std::span<const double> c,
                         core::Vector v) {
        const std::vector<double> share = product(product(a, b), c);
        for (std::size_t k = 0; k < result.size(); ++k) result[k] += factor * share[k] * v;
    };
    const auto& points = guess.piece.points;
    add(3.0, phi, rest, rest, points[1] - points[0]);
    add(3.0, phi, phi, rest, points[2] - points[0]);
    add(1.0, phi, phi, phi, points[3] - points[0]);
    return result;
}

// The weighted difference w(t) (C(t) - D(phi(t))) and w(t) as one polynomial in Bernstein form.
std::vector<core::HomogeneousPoint> difference(const core::Curve& curve, const Guess& guess) {
    const auto points = curve.control_points();
    const std::vector<core::Vector> others = composed(guess);
    const auto of_curve = choices_of(points.size() - 1);
    const auto of_others = choices_of(others.size() - 1);
    const auto of_both = choices_of(points.size() + others.size() - 2);
    const double heaviest = std::ranges::max(curve.weights());
    std::vector<core::HomogeneousPoint> result(of_both.size(), core::HomogeneousPoint(0.0, 0.0, 0.0));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const core::Vector place = points[i] - points[0];
        for (std::size_t j = 0; j < others.size(); ++j) {
            const double weight = of_curve[i] * of_others[j] / of_both[i + j] * (curve.weights()[i] / heaviest);
            const core::Vector v = weight * (place - others[j]);
            result[i + j] += core::HomogeneousPoint(v.x, v.y, weight);
        }
    }
    return result;
}

// No quotient is longer than those of the coefficients, of which there are nearer ones in both halves. Infinite where
// one of them is beyond doubles.
double length_bound(std::vector<core::HomogeneousPoint> coefficients, double wanted, int halvings) {
    double bound = 0.0;
    for (const core::HomogeneousPoint& c : coefficients) {
        const double here = core::robust_length(core::Vector(c.x / c.z, c.y / c.z));
        if (!std::isfinite(here)) return std::numeric_limits<double>::infinity();
        bound = std::max(bound, here);
    }
    if (bound <= wanted || halvings == 0) return bound;
    std::vector<core::HomogeneousPoint> left;
    for (std::size_t k = coefficients.size(); k > 0; --k) {
        left.push_back(coefficients.front());
        for (std::size_t i = 0; i + 1 < k; ++i) coefficients[i] = 0.5 * (coefficients[i] + coefficients[i + 1]);
    }
    return std::max(length_bound(std::move(left), wanted, halvings - 1),
                    length_bound(std::move(coefficients), wanted, halvings - 1));
}

struct Fit {
    CubicPiece piece;
    double error = 0.0;
};

Fit fit_of(const core::Curve& curve, const Guess& guess, double wanted) {
    return {guess.piece, length_bound(difference(curve, guess), wanted, 2)};
}

Fit best_fit(const core::Curve& curve, double wanted) {
    const std::optional<Guess> smooth = smooth_guess(curve);
    if (!smooth) return fit_of(curve, plain_guess(curve), wanted);
    const Fit fit = fit_of(curve, *smooth, wanted);
    if (fit.error <= wanted) return fit;
    const Fit plain = fit_of(curve, plain_guess(curve), wanted);
    return plain.error < fit.error ? plain : fit;
}

class PieceMaker {
  public:
    explicit PieceMaker(double tolerance) : tolerance_(tolerance) {}

    // Where a curve does not come apart its pieces have the same point at their joint, whatever the rounding.
    void add(CubicPiece piece, bool is_torn) {
        if (made_.pieces.empty()) {
            piece.is_first = true;
        } else {
            const core::Point before = made_.pieces.back().control_points().back();
            piece.is_first = is_torn && before != piece.points.front();
            if (!piece.is_first) piece.points.front() = before;
        }
        made_.pieces.push_back(piece);
    }

    void add_within_tolerance(const core::Curve& curve, bool is_torn, int halvings = most_halvings) {
        const Fit fit = best_fit(curve, tolerance_);
        const core::Interval domain = curve.domain();
        const double middle = domain.lower + 0.5 * (domain.upper - domain.lower);
        const bool can_be_halved = halvings > 0 && domain.lower < middle && middle < domain.upper;
        if (fit.error > tolerance_ && can_be_halved && std::isfinite(fit.error)) {
            if (const auto halves = core::split(curve, middle)) {
                add_within_tolerance(halves->front(), is_torn, halvings - 1);
                add_within_tolerance(halves->back(), false, halvings - 1);
                return;
            }
        }
        made_.error = std::max(made_.error, fit.error);
        add(fit.piece, is_torn);
    }

    // What is beyond doubles, where nothing is known of the error.
    void add_line(std::span<const core::Point> points, bool is_torn) {
        made_.error = std::numeric_limits<double>::infinity();
        add(line_between(points.front(), points.back()), is_torn);
    }

    CubicPieces take() && {
        const auto& pieces = made_.pieces;
        const bool is_one_run = std::ranges::count_if(pieces, &CubicPiece::is_first) == 1;
        made_.is_closed = is_one_run && pieces.front().points.front() == pieces.back().control_points().back();
        return std::move(made_);
    }

  private:
    double tolerance_;
    CubicPieces made_;
};

CubicPiece exact_piece(std::span<const core::Point> points) {
    CubicPiece piece{.degree = static_cast<int>(points.size()) - 1};
    std::ranges::copy(points, piece.points.begin());
    return piece;
}

bool all_equal(std::span<const double> weights) {
    return std::ranges::all_of(weights, [&](double weight) { return weight == weights.front(); });
}

bool begins_torn(const core::KnotVector& knots, std::size_t span) {
    const auto p = static_cast<std::size_t>(knots.degree());
    return span >= 2 * p + 1 && knots[span - p] == knots[span];
}

// The piece over `interval`, exactly or within the tolerance.
void add_piece(PieceMaker& result, std::span<const core::Point> points, std::span<const double> weights,
               core::Interval interval, bool is_torn) {
    const std::size_t p = points.size() - 1;
    if (p == 1 || (p <= 3 && all_equal(weights)))
        result.add(exact_piece(points), is_torn);
    else if (const auto piece = bezier_curve(points, weights, interval))
        result.add_within_tolerance(*piece, is_torn);
    else
        result.add_line(points, is_torn);
}

}  // namespace

CubicPieces cubic_pieces(const core::Curve& curve, double tolerance) {
    PieceMaker result(tolerance);
    const core::BezierPieces pieces = core::bezier_pieces(curve);
    for (std::size_t k = 0; k < pieces.size(); ++k)
        add_piece(result, pieces.points(k), pieces.weights(k), pieces.interval(k),
                  begins_torn(curve.knots(), pieces.span(k)));
    return std::move(result).take();
}

CubicPieces cubic_pieces(std::span<const core::Point> points, std::span<const double> weights, double tolerance) {
    PieceMaker result(tolerance);
    add_piece(result, points, weights, {0.0, 1.0}, false);
    return std::move(result).take();
}

core::Curve curve_of(const CubicPiece& piece) {
    return bezier_curve(piece.control_points(), {}, {0.0, 1.0}).value();
}

}  // namespace batten::exchange
