#include "core/evaluate/end_derivatives.h"

#include <cmath>

namespace batten::core {

namespace {

// The control points and knots from an end of the domain on, inward.
class Inward {
  public:
    Inward(const Curve& curve, CurveEnd end) : curve_(curve), is_start_(end == CurveEnd::start) {
        const Interval domain = curve.domain();
        const std::size_t span =
            is_start_ ? curve.knots().span_at(domain.lower) : curve.knots().span_at(domain.upper, Side::left);
        first_knot_ = is_start_ ? span : span + 1;
        first_point_ = is_start_ ? span - static_cast<std::size_t>(curve.degree()) : span;
    }

    EndPoint point(std::size_t k) const {
        const std::size_t i = is_start_ ? first_point_ + k : first_point_ - k;
        return {i, curve_.control_points()[i], curve_.weights()[i]};
    }

    EndKnot knot(std::size_t k) const {
        const std::size_t i = is_start_ ? first_knot_ + k : first_knot_ - k;
        const double value = curve_.knots()[i];
        return {i, value, std::abs(value - curve_.knots()[first_knot_])};
    }

    bool begins_in_a_control_point() const {
        const auto others = static_cast<std::size_t>(curve_.degree()) - 1;
        const std::size_t outermost = is_start_ ? first_knot_ - others : first_knot_ + others;
        return curve_.knots()[outermost] == curve_.knots()[first_knot_];
    }

  private:
    const Curve& curve_;
    bool is_start_;
    std::size_t first_knot_ = 0;
    std::size_t first_point_ = 0;
};

SecondEndDerivative second_of(const EndDerivatives& at, const EndPoint& far_point, const EndKnot& far) {
    const double p = at.degree;
    const double h = at.near.distance;
    const double k = far.distance;
    const double near_share = at.near_point.weight / at.end_point.weight;
    const double far_share = far_point.weight / at.end_point.weight;
    SecondEndDerivative second{.far_point = far_point, .far = far};
    second.far_factor = p * (p - 1.0) / h / k * far_share;
    second.near_factor =
        p * (p - 1.0) / h * (1.0 / h + 1.0 / k) * near_share + 2.0 * p * p / h / h * (near_share - 1.0) * near_share;
    second.value = second.far_factor * (far_point.point - at.end_point.point) -
                   second.near_factor * (at.near_point.point - at.end_point.point);
    return second;
}

}  // namespace

std::optional<EndDerivatives> end_derivatives(const Curve& curve, CurveEnd end) {
    if (curve.is_periodic()) return std::nullopt;
    const Inward inward(curve, end);
    if (!inward.begins_in_a_control_point()) return std::nullopt;
    EndDerivatives at{.end = end,
                      .degree = curve.degree(),
                      .end_knot = inward.knot(0),
                      .near = inward.knot(1),
                      .end_point = inward.point(0),
                      .near_point = inward.point(1)};
    at.factor = at.degree / at.near.distance * (at.near_point.weight / at.end_point.weight);
    const Vector leg = at.near_point.point - at.end_point.point;
    at.first = at.factor * (end == CurveEnd::start ? leg : -leg);
    at.is_rational = at.near_point.weight != at.end_point.weight;
    if (at.degree < 2) return at;
    at.second = second_of(at, inward.point(2), inward.knot(2));
    at.is_rational = at.is_rational || at.second->far_point.weight != at.end_point.weight;
    return at;
}

}  // namespace batten::core
