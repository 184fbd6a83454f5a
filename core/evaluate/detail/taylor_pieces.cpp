#include "core/evaluate/detail/taylor_pieces.h"

#include <cmath>

#include "core/evaluate/detail/span_curve.h"

namespace batten::core {

namespace {

constexpr int most_halvings = 5;

// Up to these sums of terms the last digit or two of their sum are lost at most, which is what weights and degrees up
// to 25 leave anyway.
constexpr double largest_sum = 4.0;

// So does a sum of weights that is nowhere much smaller than its terms.
constexpr double largest_sum_of_weights = 1.25;
constexpr double least_part_of_weight = 0.5;
constexpr double small_sum_of_weights = 0.625;

// The least power of two that is no less than half of the length.
double unit_of(Interval interval) {
    int exponent = 0;
    const double fraction = std::frexp(0.5 * interval.length(), &exponent);
    return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
}

template <class Pairs>
double largest_from(const Pairs& points, std::size_t first, std::size_t p) {
    double largest = 0.0;
    for (std::size_t j = first; j <= p; ++j) largest = std::max(largest, larger_part(points[j]));
    return largest;
}

bool are_finite(std::span<const double> numbers) {
    bool are = true;
    for (const double number : numbers) are &= std::isfinite(number);
    return are;
}

double* write(double* out, Vector v) {
    *out++ = v.x;
    *out++ = v.y;
    return out;
}

// Writes the point and the terms about `middle`, where t = (u - middle) / unit. Whether their sum keeps its digits: it
// cannot be larger than the points over which the terms are splines.
template <class Degree>
[[gnu::flatten]] bool write_terms(const Curve& curve, const SpanKnots& at, Degree p, double middle, double unit,
                                  bool has_weights, double* out) {
    const SpanCurve span(curve, at, p, middle);
    const Point origin = span.point();
    const Vector rest = span.weighted(origin) / span.weight();
    double sum = 0.0;
    double sum_of_weights = 0.0;
    double factor = 1.0 / span.weight();
    out = write(out, vector_to(origin) + rest);
    const double most = largest_sum * span.size_seen_from(origin);
    const bool is_even = span.least_weight() >= least_part_of_weight * span.weight();
    const double most_of_weights = is_even ? largest_sum_of_weights : small_sum_of_weights;
    const auto add_term = [&](auto k, Vector derivative, double weight, const auto& points, const auto& weights) {
        factor /= static_cast<double>(static_cast<std::size_t>(k));
        out = write(out, factor * derivative - factor * weight * rest);
        if (has_weights) *out++ = factor * weight;
        sum += factor * largest_from(points, k, p);
        if (span.is_rational()) sum_of_weights += factor * largest_from(weights, k, p);
        return sum <= most && sum_of_weights <= most_of_weights;
    };
    span.while_derivative(origin, p, add_term, unit);
    return sum <= most && sum_of_weights <= most_of_weights;
}

class Expander {
  public:
    explicit Expander(const Curve& curve) : curve_(curve) {
        pieces_.p = static_cast<std::size_t>(curve.degree());
        pieces_.is_rational = curve.is_rational();
        pieces_.joints.reserve(curve.knots().size());
        pieces_.numbers.reserve(curve.knots().size() * pieces_.stride());
    }

    TaylorPieces expanded() {
        const KnotVector& knots = curve_.knots();
        pieces_.joints.push_back(knots.domain().lower);
        for (std::size_t s = pieces_.p; s + pieces_.p + 1 < knots.size(); ++s)
            if (knots[s] < knots[s + 1]) add(SpanKnots(knots, s), {knots[s], knots[s + 1]}, most_halvings);
        return std::move(pieces_);
    }

  private:
    void add(const SpanKnots& at, Interval interval, int halvings) {
        const double middle = interval.lower + 0.5 * interval.length();
        const std::size_t before = pieces_.numbers.size();
        pieces_.numbers.resize(before + pieces_.stride());
        const std::span<double> numbers = std::span(pieces_.numbers).subspan(before);
        const bool is_sharp = write_piece(at, middle, unit_of(interval), numbers);
        if (!is_sharp && halvings > 0 && interval.lower < middle && middle < interval.upper) {
            pieces_.numbers.resize(before);
            add(at, {interval.lower, middle}, halvings - 1);
            add(at, {middle, interval.upper}, halvings - 1);
            return;
        }
        if (!is_sharp) numbers[1] = 0.0;
        pieces_.joints.push_back(interval.upper);
    }

    bool write_piece(const SpanKnots& at, double middle, double unit, std::span<double> numbers) {
        numbers[0] = middle;
        numbers[1] = 1.0 / unit;
        const bool is_sharp = with_known_degree(at.p, [&](auto p) {
            return write_terms(curve_, at, p, middle, unit, pieces_.is_rational, numbers.data() + 2);
        });
        return is_sharp && are_finite(numbers);
    }

    const Curve& curve_;
    TaylorPieces pieces_;
};

}  // namespace

TaylorPieces taylor_pieces(const Curve& curve) {
    return Expander(curve).expanded();
}

}  // namespace batten::core
