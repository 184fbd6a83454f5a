#include "core/measure/detail/difference_piece.h"

#include <cmath>

#include "core/base/detail/binomial.h"
#include "core/base/double_double.h"
#include "core/curve/detail/bspline.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

constexpr double half_ulp = 0.5 * std::numeric_limits<double>::epsilon();

// Below this a weight has lost digits.
constexpr double least_sound_weight = 1e-280;

// The order of the largest weight of either curve: products of two of them then have all the room that doubles have for
// smaller ones, and the binomials have room above.
constexpr int order_of_weights = 450;

// Of all roundings of a control point, from lifting to the last quotient, for each degree.
constexpr double roundings_of_degree = 32.0;

// A homogeneous point with what its rounding is measured by: blends are of positive shares, so that the error of a
// point is that of the blended sizes.
template <class T>
struct Lifted {
    T x{};
    T y{};
    T w{};
    double size = 0.0;  ///< blended from weight times distance, never less than |(x, y)|
};

template <class T>
using Coefficients = std::vector<T>;

// The points of a piece in scaled Bernstein form, each multiplied by its binomial, so that products are convolutions.
template <class T>
struct ScaledPiece {
    Coefficients<T> x;
    Coefficients<T> y;
    Coefficients<T> w;   ///< one coefficient where the weight is constant
    double reach = 0.0;  ///< how far the points are at most from the origin
};

struct View {
    Point origin{};  ///< times 1 / unit
    double unit = 1.0;
};

double difference_of(double a, double b, double) {
    return a - b;
}

DoubleDouble difference_of(double a, double b, DoubleDouble) {
    return exact_sum(a, -b);
}

double rounded(double value) {
    return value;
}

double rounded(DoubleDouble value) {
    return value.rounded();
}

template <class Use>
void for_local_points(const Curve& curve, std::size_t span, const Use& use) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    for (std::size_t j = 0; j <= p; ++j) use(j, (span - p + j) % n);
}

double largest_local_coordinate(const Curve& curve, std::size_t span) {
    double largest = 0.0;
    for_local_points(curve, span, [&](std::size_t, std::size_t i) {
        const Point point = curve.control_points()[i];
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    });
    return largest;
}

double power_of_two_at(double size) {
    return size > 0.0 ? std::ldexp(1.0, std::min(std::ilogb(size) + 1, 1023)) : 1.0;
}

// Seen from the curve, because its control points may be much farther away than it is large.
View view_of(const Curve& a, const Curve& b, const CommonSpan& common) {
    const double size =
        std::max(largest_local_coordinate(a, common.span_of_a), largest_local_coordinate(b, common.span_of_b));
    View view{.unit = power_of_two_at(size)};
    const Point begin = point_at(a, common.part_of_a.lower);
    if (is_finite(begin)) view.origin = {begin.x / view.unit, begin.y / view.unit};
    return view;
}

template <class T>
using LocalLifted = std::array<Lifted<T>, max_degree + 1>;

// The local control points as seen in `view`, the largest weight of the order that leaves most room.
template <class T>
LocalLifted<T> local_lifted(const Curve& curve, std::size_t span, const View& view) {
    double heaviest = 0.0;
    for_local_points(curve, span,
                     [&](std::size_t, std::size_t i) { heaviest = std::max(heaviest, curve.weights()[i]); });
    const int exponent = std::ilogb(heaviest) - order_of_weights;
    LocalLifted<T> points;
    for_local_points(curve, span, [&](std::size_t j, std::size_t i) {
        const Point point = curve.control_points()[i];
        const double weight = std::ldexp(curve.weights()[i], -exponent);
        const T x = difference_of(point.x / view.unit, view.origin.x, T{});
        const T y = difference_of(point.y / view.unit, view.origin.y, T{});
        points[j] = {x * T(weight), y * T(weight), T(weight), weight * robust_length({rounded(x), rounded(y)})};
    });
    return points;
}

// Both shares are positive, so that weights keep their relative accuracy, however different they are.
template <class T>
void blend_into(Lifted<T>& to, const Lifted<T>& from, T from_share, T to_share) {
    to.x = from_share * from.x + to_share * to.x;
    to.y = from_share * from.y + to_share * to.y;
    to.w = from_share * from.w + to_share * to.w;
    to.size = rounded(from_share) * from.size + rounded(to_share) * to.size;
}

// From between `lower` and `upper` to `u`: one blend of a level.
template <class T>
void blend_into(Lifted<T>& to, const Lifted<T>& from, double lower, double upper, double u) {
    const T length = difference_of(upper, lower, T{});
    blend_into(to, from, difference_of(upper, u, T{}) / length, difference_of(u, lower, T{}) / length);
}

// The Bézier points over `part` of the span, by two triangles: the right edge of the first has the points
// b(l, ..., l, u_{s+1}, ...), the left edge of the second b(l, ..., l, u, ..., u).
template <class T>
LocalLifted<T> bezier_points(LocalLifted<T> points, const SpanKnots& at, Interval part) {
    LocalLifted<T> half;
    half[at.p] = points[at.p];
    for (std::size_t r = 1; r <= at.p; ++r) {
        for (std::size_t j = at.p; j >= r; --j)
            blend_into(points[j], points[j - 1], at.lower(j), at.upper(j, r), part.lower);
        half[at.p - r] = points[at.p];
    }
    LocalLifted<T> result;
    result[0] = half[0];
    for (std::size_t r = 1; r <= at.p; ++r) {
        for (std::size_t j = at.p; j >= r; --j)
            blend_into(half[j], half[j - 1], part.lower, at.upper(j, r), part.upper);
        result[r] = half[r];
    }
    return result;
}

bool has_one_weight(const Curve& curve, std::size_t span) {
    const double first = curve.weights()[span % curve.weights().size()];
    bool is_one = true;
    for_local_points(curve, span, [&](std::size_t, std::size_t i) { is_one = is_one && curve.weights()[i] == first; });
    return is_one;
}

template <class T>
ScaledPiece<T> scaled_piece(const Curve& curve, std::size_t span, Interval part, const View& view) {
    const SpanKnots at(curve.knots(), span);
    const auto of_degree = binomials(at.p);
    const LocalLifted<T> corners = bezier_points(local_lifted<T>(curve, span, view), at, part);
    ScaledPiece<T> piece;
    for (std::size_t k = 0; k <= at.p; ++k) {
        piece.x.push_back(T(of_degree[k]) * corners[k].x);
        piece.y.push_back(T(of_degree[k]) * corners[k].y);
        piece.w.push_back(T(of_degree[k]) * corners[k].w);
        piece.reach = std::max(piece.reach, corners[k].size / rounded(corners[k].w));
    }
    if (has_one_weight(curve, span)) piece.w = {corners[0].w};
    return piece;
}

template <class T>
Coefficients<T> convolved(const Coefficients<T>& a, const Coefficients<T>& b) {
    Coefficients<T> result(a.size() + b.size() - 1, T{});
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] = result[i + j] + a[i] * b[j];
    return result;
}

// The same polynomial with `size` coefficients.
template <class T>
Coefficients<T> elevated_to(const Coefficients<T>& a, std::size_t size) {
    if (a.size() == size) return a;
    const auto ones = binomials(size - a.size());
    return convolved(a, Coefficients<T>(ones.begin(), ones.end()));
}

// w a - v b with as many coefficients as `size` says.
template <class T>
Coefficients<T> crossed(const Coefficients<T>& a, const Coefficients<T>& w, const Coefficients<T>& b,
                        const Coefficients<T>& v, std::size_t size) {
    Coefficients<T> result = elevated_to(convolved(a, w), size);
    const Coefficients<T> other = elevated_to(convolved(b, v), size);
    for (std::size_t k = 0; k < size; ++k) result[k] = result[k] - other[k];
    return result;
}

template <class T>
std::vector<HomogeneousPoint> difference_points(const ScaledPiece<T>& a, const ScaledPiece<T>& b) {
    const std::size_t size = std::max(a.x.size() + b.w.size(), b.x.size() + a.w.size()) - 1;
    const Coefficients<T> x = crossed(a.x, b.w, b.x, a.w, size);
    const Coefficients<T> y = crossed(a.y, b.w, b.y, a.w, size);
    const Coefficients<T> w = elevated_to(convolved(a.w, b.w), size);
    const auto of_degree = binomials(size - 1);
    std::vector<HomogeneousPoint> points;
    points.reserve(size);
    for (std::size_t k = 0; k < size; ++k)
        points.emplace_back(rounded(x[k]) / of_degree[k], rounded(y[k]) / of_degree[k], rounded(w[k]) / of_degree[k]);
    return points;
}

template <class T>
DifferencePiece difference_in(const Curve& a, const Curve& b, const CommonSpan& common, double roundoff) {
    const View view = view_of(a, b, common);
    const auto of_a = scaled_piece<T>(a, common.span_of_a, common.part_of_a, view);
    const auto of_b = scaled_piece<T>(b, common.span_of_b, common.part_of_b, view);
    const double reach = of_a.reach + of_b.reach;
    const double roundings = roundings_of_degree * static_cast<double>(a.degree() + b.degree() + 2);
    return {difference_points(of_a, of_b), view.unit, reach, roundings * roundoff * reach};
}

double distance_of(const HomogeneousPoint& point) {
    return point.z > least_sound_weight ? robust_length(plane_part(point) / point.z)
                                        : std::numeric_limits<double>::infinity();
}

double farthest_of(const std::vector<HomogeneousPoint>& points) {
    double farthest = 0.0;
    for (const HomogeneousPoint& point : points) farthest = std::max(farthest, distance_of(point));
    return farthest;
}

}  // namespace

double DifferencePiece::bound() const {
    return (std::min(farthest_of(points), reach) + rounding) * unit;
}

double DifferencePiece::distance_at_ends() const {
    const double distance = std::max(distance_of(points.front()), distance_of(points.back()));
    return distance <= reach ? std::max(distance - rounding, 0.0) * unit : 0.0;
}

std::pair<DifferencePiece, DifferencePiece> DifferencePiece::halves() const {
    const std::size_t degree = points.size() - 1;
    const double farthest = std::min(farthest_of(points), reach);
    const double more_rounding = 4.0 * half_ulp * static_cast<double>(degree) * farthest;
    DifferencePiece right{points, unit, reach, rounding + more_rounding};
    DifferencePiece left{{}, unit, reach, right.rounding};
    left.points.reserve(points.size());
    for (std::size_t level = 0; level <= degree; ++level) {
        left.points.push_back(right.points.front());
        for (std::size_t i = 0; i + level < degree; ++i)
            right.points[i] = 0.5 * (right.points[i] + right.points[i + 1]);
    }
    return {std::move(left), std::move(right)};
}

DifferencePiece difference_piece(const Curve& a, const Curve& b, const CommonSpan& common, Precision precision) {
    if (precision == Precision::plain) return difference_in<double>(a, b, common, half_ulp);
    return difference_in<DoubleDouble>(a, b, common, 4.0 * half_ulp * half_ulp);
}

}  // namespace batten::core
