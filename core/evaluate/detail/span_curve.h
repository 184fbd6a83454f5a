/// The curve over one span, at one parameter.
#pragma once

#include <bit>

#include "core/evaluate/detail/span_triangle.h"

namespace batten::core {

inline double larger_part(Pair pair) {
    return std::max(std::abs(pair[0]), std::abs(pair[1]));
}

/// Where all weights in reach are equal they do not matter: the curve is a polynomial there, and nothing is projected.
template <class Degree>
class SpanCurve {
  public:
    using Local = LocalPairs<Degree>;

    SpanCurve(const Curve& curve, const SpanKnots& at, Degree p, double u) : at_(at), p_(p), triangle_(at, p, u) {
        read(curve);
        if (is_rational_) weight_ = triangle_.apex(weights_)[0];
    }

    bool is_rational() const { return is_rational_; }

    /// w(u), 1 where the weights are equal. Where they are extreme all are divided by one power of two.
    double weight() const { return weight_; }

    /// C(u). Twice: the second time seen from the first answer, where the coordinates are small, and so is what
    /// rounding does to them. What is left is little more than the last rounding.
    Point point() const { return point_by_way_of(point_by_way_of({0.0, 0.0})); }

    double least_weight() const {
        double least = weights_[0][0];
        for (std::size_t j = 1; j <= p_; ++j) least = std::min(least, weights_[j][0]);
        return least;
    }

    /// No less than a coordinate of a local point seen from `origin`.
    double size_seen_from(Point origin) const {
        double largest = 0.0;
        for (std::size_t j = 0; j <= p_; ++j)
            largest = std::max(largest, larger_part(points_[j] - std::bit_cast<Pair>(origin)));
        return largest;
    }

    /// (w C)(u), C seen from `origin`.
    Vector weighted(Point origin) const { return std::bit_cast<Vector>(triangle_.apex(seen_from(origin))); }

    /// The derivatives by u / unit of orders 1 to `order` and to p, of w C, seen from `origin`, and of w. `use` gets
    /// the order k, both derivatives, and the points and numbers over which they are splines, at k to p.
    template <class Use>
    void while_derivative(Point origin, std::size_t order, Use use, double unit = 1.0) const {
        Local points = is_rational_ ? seen_from(origin) : points_;
        Local weights;
        if (is_rational_) weights = weights_;
        while_level(p_, order, [&](auto k) {
            differentiate(points, k, unit);
            if (is_rational_) differentiate(weights, k, unit);
            const double weight = is_rational_ ? triangle_.apex(weights, k)[0] : 0.0;
            return use(k, std::bit_cast<Vector>(triangle_.apex(points, k)), weight, points, weights);
        });
    }

  private:
    void read(const Curve& curve) {
        const std::span<const Point> points = curve.control_points();
        std::size_t i = at_.s - p_;
        for (std::size_t j = 0; j <= p_; ++j) {
            points_[j] = std::bit_cast<Pair>(points[i]);
            if (++i == points.size()) i = 0;
        }
        if (curve.is_rational()) read_weights(curve.weights());
    }

    void read_weights(std::span<const double> weights) {
        std::size_t i = at_.s - p_;
        const double first_weight = weights[i];
        for (std::size_t j = 0; j <= p_; ++j) {
            weights_[j] = Pair{weights[i], weights[i]};
            is_rational_ |= weights[i] != first_weight;
            if (++i == weights.size()) i = 0;
        }
        if (is_rational_) make_moderate();
    }

    void make_moderate() {
        double largest = 0.0;
        for (std::size_t j = 0; j <= p_; ++j) largest = std::max(largest, weights_[j][0]);
        const int order = extreme_order(largest);
        if (order == 0) return;
        for (std::size_t j = 0; j <= p_; ++j) {
            const double weight = divided_by_power(weights_[j][0], order);
            weights_[j] = Pair{weight, weight};
        }
    }

    Local seen_from(Point origin) const {
        Local seen;
        for (std::size_t j = 0; j <= p_; ++j) seen[j] = points_[j] - std::bit_cast<Pair>(origin);
        if (is_rational_)
            for (std::size_t j = 0; j <= p_; ++j) seen[j] = weights_[j] * seen[j];
        return seen;
    }

    Point point_by_way_of(Point origin) const {
        const Vector sum = weighted(origin);
        return origin + (is_rational_ ? sum / weight_ : sum);
    }

    template <class Level>
    void differentiate(Local& points, Level k, double unit) const {
        const double factor = unit * static_cast<double>(p_ - k + 1);
        for (std::size_t j = p_; j >= k; --j)
            points[j] = (factor / (at_.upper(j, k) - at_.lower(j))) * (points[j] - points[j - 1]);
    }

    SpanKnots at_;
    Degree p_;
    SpanTriangle<Degree> triangle_;
    Local points_;
    Local weights_;  // each twice
    bool is_rational_ = false;
    double weight_ = 1.0;
};

}  // namespace batten::core
