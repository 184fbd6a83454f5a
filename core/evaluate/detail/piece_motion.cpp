#include "core/evaluate/detail/piece_motion.h"

#include <array>
#include <cmath>

#include "core/curve/control_box.h"

namespace batten::core {

namespace {

// The Bernstein form of the first `count` points.
template <class P>
P bernstein_sum(LocalPoints<P>& points, std::size_t count, Ratio ratio) {
    for (std::size_t left = count - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i) points[i] = blend(points[i], points[i + 1], ratio);
    return points[0];
}

// The same in O(p): by powers of the one share and Horner's rule in the other. Not finite where a point times the
// largest of the binomial coefficients is not. Source: Farin, Curves and Surfaces for CAGD, hornbez.
Vector quick_sum(const LocalPoints<Vector>& points, std::size_t count, Ratio ratio) {
    const std::size_t p = count - 1;
    Vector sum = points[0];
    double share = 1.0;  // of the power of the upper share and the binomial coefficient
    for (std::size_t i = 1; i <= p; ++i) {
        share *= ratio.upper_share * (static_cast<double>(p + 1 - i) / static_cast<double>(i));
        sum = ratio.lower_share * sum + share * points[i];
    }
    return sum;
}

}  // namespace

Vector PieceMotion::velocity_at(Ratio ratio) const {
    if (!is_polynomial_) return rational_at(ratio).velocity;
    const std::size_t p = piece_.points.size() - 1;
    LocalPoints<Vector> legs;
    for (std::size_t i = 0; i < p; ++i) legs[i] = plane_part(piece_.points[i + 1]) - plane_part(piece_.points[i]);
    const Vector sum = quick_sum(legs, p, ratio);
    if (!is_finite(sum)) return polynomial_at(ratio).velocity;
    return static_cast<double>(p) * (sum / piece_.points.front().z);
}

Motion PieceMotion::at(Ratio ratio) const {
    return is_polynomial_ ? polynomial_at(ratio) : rational_at(ratio);
}

Motion PieceMotion::polynomial_at(Ratio ratio) const {
    const std::size_t p = piece_.points.size() - 1;
    const double weight = piece_.points.front().z;
    LocalPoints<Vector> points;
    LocalPoints<Vector> legs;
    for (std::size_t i = 0; i <= p; ++i) points[i] = plane_part(piece_.points[i]);
    for (std::size_t i = 0; i < p; ++i) legs[i] = points[i + 1] - points[i];
    return {tip_of(bernstein_sum(points, p + 1, ratio) / weight),
            static_cast<double>(p) * (bernstein_sum(legs, p, ratio) / weight)};
}

Motion PieceMotion::rational_at(Ratio ratio) const {
    const std::size_t p = piece_.points.size() - 1;
    LocalPoints<HomogeneousPoint> points;
    std::copy(piece_.points.begin(), piece_.points.end(), points.begin());
    const HomogeneousPoint here = bernstein_sum(points, p + 1, ratio);
    const Point position = tip_of(plane_part(here) / here.z);
    // Seen from C(t), where the derivative of the weight does not matter.
    LocalPoints<Vector> legs;
    const auto away = [&](const HomogeneousPoint& point) { return plane_part(point) - point.z * vector_to(position); };
    for (std::size_t i = 0; i < p; ++i) legs[i] = away(piece_.points[i + 1]) - away(piece_.points[i]);
    return {position, static_cast<double>(p) * (bernstein_sum(legs, p, ratio) / here.z)};
}

std::vector<PieceMotion> motions_of(const Curve& curve, std::size_t first, std::size_t last) {
    const BezierPieces pieces = bezier_pieces(curve, first, last);
    std::vector<PieceMotion> motions;
    motions.reserve(pieces.size());
    for (BezierPiece piece : pieces) motions.emplace_back(std::move(piece));
    return motions;
}

std::vector<PieceMotion> motions_of(const Curve& curve, Point origin) {
    const auto p = static_cast<std::size_t>(curve.degree());
    return motions_of(seen_from(curve, origin), p, curve.knots().size() - p - 2);
}

}  // namespace batten::core
