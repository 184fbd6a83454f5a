#include "core/evaluate/hodograph.h"

#include <algorithm>
#include <utility>

#include "core/base/detail/binomial.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

namespace {

// Whether the derivative of this order may jump there.
bool jumps_at(const Curve& curve, double knot, int order) {
    return curve.knots().multiplicity(knot) > curve.degree() - order;
}

bool jumps_somewhere(const Curve& curve, int order) {
    for (const DistinctKnot& knot : distinct_knots(curve.knots()))
        if (knot.in_domain && knot.is_interior && jumps_at(curve, knot.value, order)) return true;
    return false;
}

bool stays_periodic(const Curve& curve, int order = 1) {
    return curve.is_periodic() && !jumps_somewhere(curve, order);
}

Point control_point(const Curve& curve, std::size_t i) {
    return curve.control_points()[i % curve.control_points().size()];
}

// Derivatives of the control points, and the knots that remain; index i of the knots is one more than in the curve.
struct Differences {
    std::vector<double> knots;
    std::vector<Point> points;
};

// p (P_{i+1} - P_i) / (u_{i+p+1} - u_{i+1}), drawn from (0, 0): for coordinates of few digits rounded by the division
// alone.
Point leg_derivative(const Curve& curve, std::size_t i) {
    const auto u = curve.knots().values();
    const auto p = static_cast<std::size_t>(curve.degree());
    const Vector leg = control_point(curve, i + 1) - control_point(curve, i);
    return tip_of(static_cast<double>(p) * leg / (u[i + p + 1] - u[i + 1]));
}

// A difference over knots that are all equal belongs to a tear, or to an end point that acts nowhere: it goes together
// with one of the knots.
Differences differences(const Curve& curve) {
    const auto u = curve.knots().values();
    const auto p = static_cast<std::size_t>(curve.degree());
    Differences result;
    for (std::size_t i = 0; i + p + 2 < u.size(); ++i) {
        if (u[i + 1] == u[i + p + 1]) continue;
        result.knots.push_back(u[i + 1]);
        result.points.push_back(leg_derivative(curve, i));
    }
    result.knots.insert(result.knots.end(), u.end() - static_cast<std::ptrdiff_t>(p) - 1, u.end() - 1);
    return result;
}

// Over one period the unrolled differences are those of the stored points: u_{p+k} = t_k is knot p-1 of degree p-1.
Result<Curve> periodic_hodograph(const Curve& curve) {
    const std::size_t n = curve.control_points().size();
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back(leg_derivative(curve, i));
    const auto stored = curve.knots().stored();
    return Curve::make({.degree = curve.degree() - 1,
                        .knots = {stored.begin(), stored.end()},
                        .points = std::move(points),
                        .periodic = true,
                        .kind = curve.knots().kind()});
}

// Degree p-1, open. The unrolled knots of a periodic curve describe it as an open one.
Result<Curve> open_hodograph(const Curve& curve) {
    Differences found = differences(curve);
    const KnotKind kind = curve.is_periodic() ? KnotKind::custom : curve.knots().kind();
    return Curve::make({.degree = curve.degree() - 1,
                        .knots = std::move(found.knots),
                        .points = std::move(found.points),
                        .kind = kind,
                        .tears = Tears::allow});
}

// Knots for pieces of `degree` side by side: breaks of multiplicity `degree`, one more where the pieces jump.
std::vector<double> knots_of_pieces(const Curve& curve, int order, const std::vector<Interval>& pieces,
                                    std::size_t degree) {
    std::vector<double> knots(degree + 1, pieces.front().lower);
    for (std::size_t k = 1; k < pieces.size(); ++k)
        knots.insert(knots.end(), degree + (jumps_at(curve, pieces[k].lower, order) ? 1 : 0), pieces[k].lower);
    knots.insert(knots.end(), degree + 1, pieces.back().upper);
    return knots;
}

std::vector<Interval> spans_of(const Curve& curve) {
    const auto u = curve.knots().values();
    const auto p = static_cast<std::size_t>(curve.degree());
    std::vector<Interval> spans;
    for (std::size_t s = p; s + p + 1 < u.size(); ++s)
        if (u[s] < u[s + 1]) spans.push_back({u[s], u[s + 1]});
    return spans;
}

// The derivative of a polygon is constant along each leg.
Result<Curve> polygon_hodograph(const Curve& curve) {
    const auto u = curve.knots().values();
    std::vector<Point> points;
    for (std::size_t s = 1; s + 2 < u.size(); ++s)
        if (u[s] < u[s + 1]) points.insert(points.end(), 2, leg_derivative(curve, s - 1));
    return Curve::make({.degree = 1,
                        .knots = knots_of_pieces(curve, 1, spans_of(curve), 1),
                        .points = std::move(points),
                        .tears = Tears::allow});
}

// The Bernstein form of one degree more.
template <class P>
std::vector<P> elevated(const std::vector<P>& points) {
    const auto degree = static_cast<double>(points.size());
    std::vector<P> result{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double share = static_cast<double>(i) / degree;
        result.push_back(share * points[i - 1] + (1.0 - share) * points[i]);
    }
    result.push_back(points.back());
    return result;
}

// Of so high a degree.
template <class P>
std::vector<P> raised(std::vector<P> points, std::size_t degree) {
    while (points.size() <= degree) points = elevated(points);
    return points;
}

// w^2 C' = A' w - A w' in Bernstein form of degree 2p - 2, as a sum of differences of control points, which nothing
// cancels:  sum over i < j of (j - i) binomial(p, i) binomial(p, j) w_i w_j (P_j - P_i) t^(i+j-1) (1-t)^(2p-1-i-j) / h
std::vector<Vector> derivative_numerator(const BezierPiece& piece) {
    const std::size_t p = piece.points.size() - 1;
    const auto of_p = binomials(p);
    const auto of_product = binomials(2 * p - 2);
    std::vector<Vector> numerator(2 * p - 1, Vector{});
    for (std::size_t i = 0; i <= p; ++i)
        for (std::size_t j = i + 1; j <= p; ++j) {
            const HomogeneousPoint& a = piece.points[i];
            const HomogeneousPoint& b = piece.points[j];
            const double factor =
                static_cast<double>(j - i) * of_p[i] * of_p[j] / of_product[i + j - 1] / piece.interval.length();
            numerator[i + j - 1] += factor * a.z * b.z * (project(b) - project(a));
        }
    return numerator;
}

std::vector<double> weights_of(const BezierPiece& piece) {
    std::vector<double> weights;
    for (const HomogeneousPoint& point : piece.points) weights.push_back(point.z);
    return weights;
}

// The product of two polynomials in Bernstein form.
template <class P>
std::vector<P> product(const std::vector<double>& a, const std::vector<P>& b) {
    const std::size_t m = a.size() - 1;
    const std::size_t n = b.size() - 1;
    const auto of_a = binomials(m);
    const auto of_b = binomials(n);
    const auto of_product = binomials(m + n);
    std::vector<P> result(m + n + 1, P{});
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j) result[i + j] += of_a[i] * of_b[j] / of_product[i + j] * a[i] * b[j];
    return result;
}

// The derivative over a span of this length; of a constant the constant 0.
template <class P>
std::vector<P> derivative(const std::vector<P>& points, double span) {
    const auto degree = static_cast<double>(points.size() - 1);
    std::vector<P> result;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) result.push_back(degree / span * (points[i + 1] - points[i]));
    if (result.empty()) result.push_back(P{});
    return result;
}

// With N = w^2 C' it is w^3 C'' = N' w - 2 N w', of degree 3p - 3.
std::vector<Vector> second_numerator(const BezierPiece& piece) {
    const std::size_t degree = 3 * (piece.points.size() - 1);
    const std::vector<double> weights = weights_of(piece);
    const std::vector<Vector> first = derivative_numerator(piece);
    const double span = piece.interval.length();
    std::vector<Vector> numerator = raised(product(weights, derivative(first, span)), degree);
    const std::vector<Vector> fall = raised(product(derivative(weights, span), first), degree);
    for (std::size_t k = 0; k <= degree; ++k) numerator[k] -= 2.0 * fall[k];
    return numerator;
}

// A derivative over one piece as a quotient of polynomials of one degree in Bernstein form.
struct Quotient {
    std::vector<Vector> numerator;
    std::vector<double> denominator;
};

Quotient derivative_of(const BezierPiece& piece, int order) {
    const std::vector<double> weights = weights_of(piece);
    const std::vector<double> square = product(weights, weights);
    if (order == 1) return {raised(derivative_numerator(piece), square.size() - 1), square};
    return {second_numerator(piece), product(weights, square)};
}

// Near the first control point, where differences do not cancel, and with weights that can be squared.
Curve near_origin(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    const Point origin = definition.points.front();
    for (Point& point : definition.points) point = seen_from(point, origin);
    const double largest = *std::max_element(definition.weights.begin(), definition.weights.end());
    for (double& weight : definition.weights) weight /= largest;
    return Curve::make(std::move(definition)).value_or(curve);
}

// The pieces side by side; points that neighbors share are taken from the piece on the right.
struct JoinedPieces {
    std::vector<Point> points;
    std::vector<double> weights;

    void append(const Quotient& piece, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            points.push_back(tip_of(piece.numerator[k] / piece.denominator[k]));
            weights.push_back(piece.denominator[k]);
        }
    }
};

Result<Curve> rational_hodograph(const Curve& curve, int order) {
    const std::size_t degree = static_cast<std::size_t>(order + 1) * static_cast<std::size_t>(curve.degree());
    if (degree > static_cast<std::size_t>(max_degree))
        return refuse({.code = CurveErrorCode::degree_out_of_range, .value = static_cast<double>(degree)});
    const BezierPieces pieces = bezier_pieces(near_origin(curve));
    const bool is_periodic = stays_periodic(curve, order);
    JoinedPieces joined;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const bool is_last = k + 1 == pieces.size();
        const bool has_own_end = is_last ? !is_periodic : jumps_at(curve, pieces.interval(k).upper, order);
        joined.append(derivative_of(pieces[k], order), degree + (has_own_end ? 1 : 0));
    }
    std::vector<double> knots = knots_of_pieces(curve, order, spans_of(curve), degree);
    if (is_periodic) {
        // One period: the seam once at its lower end, `degree` times at the upper one.
        knots.erase(knots.begin(), knots.begin() + static_cast<std::ptrdiff_t>(degree));
        knots.pop_back();
    }
    return Curve::make({.degree = static_cast<int>(degree),
                        .knots = std::move(knots),
                        .points = std::move(joined.points),
                        .weights = std::move(joined.weights),
                        .periodic = is_periodic,
                        .tears = Tears::allow});
}

}  // namespace

Result<Curve> hodograph(const Curve& curve) {
    if (curve.is_rational()) return rational_hodograph(curve, 1);
    if (curve.degree() == 1) return polygon_hodograph(curve);
    return stays_periodic(curve) ? periodic_hodograph(curve) : open_hodograph(curve);
}

Result<Curve> second_hodograph(const Curve& curve) {
    return curve.is_rational() ? rational_hodograph(curve, 2) : hodograph(curve).and_then(hodograph);
}

}  // namespace batten::core
