#include "core/evaluate/detail/taylor_pieces.h"

#include <cmath>

#include "core/curve/detail/bspline.h"

namespace batten::core {

namespace {

constexpr int most_halvings = 5;

// Up to these sums of terms the last digit or two of their sum are lost at most, which is what weights and degrees up
// to 25 leave anyway.
constexpr double largest_sum = 4.0;
constexpr double largest_sum_of_weights = 0.625;

double largest_part(Vector v) {
    return std::max(std::abs(v.x), std::abs(v.y));
}

double weight_part(Vector) {
    return 0.0;
}

double largest_part(const HomogeneousPoint& point) {
    return largest_part(plane_part(point));
}

double weight_part(const HomogeneousPoint& point) {
    return std::abs(point.z);
}

LocalPoints<Vector> local_vectors(const Curve& curve, const SpanKnots& at, Point origin) {
    LocalPoints<Vector> points;
    const std::size_t n = curve.control_points().size();
    for (std::size_t j = 0; j <= at.p; ++j) points[j] = curve.control_points()[(at.s - at.p + j) % n] - origin;
    return points;
}

double largest_of(const LocalPoints<Vector>& points, std::size_t p) {
    double largest = 0.0;
    for (std::size_t j = 0; j <= p; ++j) largest = std::max(largest, largest_part(points[j]));
    return largest;
}

// The terms of one span about a middle: terms[k] t^k, where t = (u - middle) / unit.
template <class P>
struct Terms {
    LocalPoints<P> terms;
    // No less than the sum of the terms behind the first, anywhere in the span, and of all that they were computed
    // from.
    double size = 0.0;
    double weight_size = 0.0;
};

template <class P>
Terms<P> terms_about(LocalPoints<P> points, const SpanKnots& at, double middle, double unit) {
    Terms<P> result;
    result.terms[0] = de_boor(points, at, middle);
    for (std::size_t k = 1; k <= at.p; ++k) {
        differentiate_level(points, at, k);
        double largest = 0.0;
        double largest_weight = 0.0;
        for (std::size_t j = k; j <= at.p; ++j) {
            points[j] = (unit / static_cast<double>(k)) * points[j];
            largest = std::max(largest, largest_part(points[j]));
            largest_weight = std::max(largest_weight, weight_part(points[j]));
        }
        result.terms[k] = de_boor(points, at, middle, k);
        result.size += largest;
        result.weight_size += largest_weight;
    }
    return result;
}

class Expander {
  public:
    explicit Expander(const Curve& curve) : curve_(curve) {
        pieces_.p = static_cast<std::size_t>(curve.degree());
        pieces_.is_rational = curve.is_rational();
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
        const bool is_sharp = add_numbers(at, middle, unit_of(interval));
        if (!is_sharp && halvings > 0 && interval.lower < middle && middle < interval.upper) {
            pieces_.numbers.resize(before);
            add(at, {interval.lower, middle}, halvings - 1);
            add(at, {middle, interval.upper}, halvings - 1);
            return;
        }
        if (!is_sharp) pieces_.numbers[before + 1] = 0.0;
        pieces_.joints.push_back(interval.upper);
    }

    // The least power of two that is no less than half of the length.
    static double unit_of(Interval interval) {
        int exponent = 0;
        const double fraction = std::frexp(0.5 * interval.length(), &exponent);
        return std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
    }

    bool add_numbers(const SpanKnots& at, double middle, double unit) {
        const std::size_t before = pieces_.numbers.size();
        pieces_.numbers.push_back(middle);
        pieces_.numbers.push_back(1.0 / unit);
        const bool is_sharp = pieces_.is_rational ? add_rational(at, middle, unit) : add_polynomial(at, middle, unit);
        return is_sharp && std::all_of(pieces_.numbers.begin() + static_cast<std::ptrdiff_t>(before),
                                       pieces_.numbers.end(), [](double number) { return std::isfinite(number); });
    }

    // Twice, as point_at does it: the second time seen from the point itself, where the coordinates are small.
    bool add_polynomial(const SpanKnots& at, double middle, double unit) {
        const Point near = near_point(at);
        const Point origin = near + de_boor(local_vectors(curve_, at, near), at, middle);
        const LocalPoints<Vector> points = local_vectors(curve_, at, origin);
        const Terms<Vector> found = terms_about(points, at, middle, unit);
        add_vector(vector_to(origin) + found.terms[0]);
        for (std::size_t k = 1; k <= at.p; ++k) add_vector(found.terms[k]);
        return found.size <= largest_sum * largest_of(points, at.p);
    }

    bool add_rational(const SpanKnots& at, double middle, double unit) {
        const Point near = near_point(at);
        const Point origin = near + vector_to(project(de_boor(local_shadow_points(curve_, at, near), at, middle)));
        const auto found = terms_about(local_shadow_points(curve_, at, origin), at, middle, unit);
        const double weight = found.terms[0].z;
        const Vector rest = plane_part(found.terms[0]) / weight;
        add_vector(vector_to(origin) + rest);
        for (std::size_t k = 1; k <= at.p; ++k) {
            const double w = found.terms[k].z / weight;
            add_vector(plane_part(found.terms[k]) / weight - w * rest);
            pieces_.numbers.push_back(w);
        }
        const double size = largest_of(local_vectors(curve_, at, origin), at.p);
        return found.size <= largest_sum * size * weight && found.weight_size <= largest_sum_of_weights * weight;
    }

    Point near_point(const SpanKnots& at) const {
        return curve_.control_points()[(at.s - at.p / 2) % curve_.control_points().size()];
    }

    void add_vector(Vector v) {
        pieces_.numbers.push_back(v.x);
        pieces_.numbers.push_back(v.y);
    }

    const Curve& curve_;
    TaylorPieces pieces_;
};

}  // namespace

TaylorPieces taylor_pieces(const Curve& curve) {
    return Expander(curve).expanded();
}

}  // namespace batten::core
