#include "core/measure/conic_arc.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace batten::core {

namespace {

ConicKind kind_of(const ConicArc& arc) {
    const bool is_circle =
        arc.circular_weight && std::abs(arc.form.weight - *arc.circular_weight) <= circle_tolerance * arc.form.weight;
    if (is_circle) return ConicKind::circle;
    switch (arc.form.type) {
        case ConicType::ellipse:
            return ConicKind::ellipse;
        case ConicType::parabola:
            return ConicKind::parabola;
        case ConicType::hyperbola:
            break;
    }
    return ConicKind::hyperbola;
}

// The conic with the weights 1, -w, 1. Seen from P1 only the ends have coordinates, so that of its blossom b(s, t) the
// weight and they are
//     (1-s)(1-t) + st - w (s (1-t) + t (1-s))    and    (1-s)(1-t) (P0 - P1) + st (P2 - P1).
class Complement {
  public:
    explicit Complement(const ConicArc& arc)
        : corner_(arc.points[1]), from_(arc.points[0] - corner_), to_(arc.points[2] - corner_), w_(arc.form.weight) {}

    // Where it is at infinity for the first time, 0 < s <= 1/2; none for an ellipse.
    std::optional<double> infinity(ConicType type) const {
        if (type == ConicType::ellipse) return std::nullopt;
        const double root = type == ConicType::parabola ? 0.0 : std::sqrt((w_ - 1.0) / (w_ + 1.0));
        return 1.0 / ((1.0 + w_) * (1.0 + root));
    }

    double distance_at(double s) const { return robust_length(place(s, s) / weight(s, s)); }

    // The pieces between neighboring parameters as one curve; none where its coordinates are no numbers.
    std::optional<Curve> over(const std::vector<double>& parameters) const {
        CurveDefinition definition{.degree = 2, .knots = {0.0, 0.0}};
        const auto add = [&](double s, double t) {
            definition.points.push_back(corner_ + place(s, t) / weight(s, t));
            definition.weights.push_back(std::abs(weight(s, t)));
        };
        const std::size_t pieces = parameters.size() - 1;
        for (std::size_t k = 0; k < pieces; ++k) {
            const double knot = static_cast<double>(k) / static_cast<double>(pieces);
            definition.knots.insert(definition.knots.end(), k == 0 ? 1 : 2, knot);
            add(parameters[k], parameters[k]);
            add(parameters[k], parameters[k + 1]);
        }
        add(parameters.back(), parameters.back());
        definition.knots.insert(definition.knots.end(), 3, 1.0);
        auto curve = Curve::make(std::move(definition));
        return curve ? std::optional(*std::move(curve)) : std::nullopt;
    }

  private:
    double weight(double s, double t) const {
        return (1.0 - s) * (1.0 - t) + s * t - w_ * (s * (1.0 - t) + t * (1.0 - s));
    }
    Vector place(double s, double t) const { return (1.0 - s) * (1.0 - t) * from_ + s * t * to_; }

    Point corner_;
    Vector from_;
    Vector to_;
    double w_;
};

// The first halving of the way to `limit` from the side of `start` at which the curve is beyond `reach`.
double cut_before(const Complement& rest, double start, double limit, double reach) {
    constexpr int most_halvings = 40;
    double s = start;
    for (int k = 0; k < most_halvings && !(rest.distance_at(s) >= reach); ++k) s += 0.5 * (limit - s);
    return s;
}

}  // namespace

Result<ConicArc> conic_arc(const BezierPiece& piece) {
    const auto form = conic_form(piece);
    if (!form) return tl::unexpected(form.error());
    const std::array points{project(piece.points[0]), project(piece.points[1]), project(piece.points[2])};
    const Vector from = points[0] - points[1];
    const Vector to = points[2] - points[1];
    const std::array legs{robust_length(from), robust_length(to)};
    const double angle = std::abs(angle_between(from / legs[0], to / legs[1]));
    ConicArc arc{.form = *form,
                 .points = points,
                 .chord_middle = middle(points[0], points[2]),
                 .half_angle = 0.5 * angle * (180.0 / std::numbers::pi),
                 .legs = legs,
                 .circular_weight = std::nullopt};
    if (std::abs(legs[0] - legs[1]) <= circle_tolerance * legs[0])
        arc.circular_weight = 0.5 * robust_length(from / legs[0] - to / legs[1]);
    arc.kind = kind_of(arc);
    return arc;
}

std::vector<Curve> complement_of(const ConicArc& arc, double reach) {
    assert(reach > 0.0 && std::isfinite(reach));
    const Complement rest(arc);
    std::vector<Curve> curves;
    const auto add = [&](const std::vector<double>& parameters) {
        if (auto curve = rest.over(parameters)) curves.push_back(*std::move(curve));
    };
    const auto infinity = rest.infinity(arc.form.type);
    if (!infinity) {
        add({0.0, 0.5, 1.0});
        return curves;
    }
    const double cut = cut_before(rest, 0.5 * *infinity, *infinity, reach);
    add({0.0, cut});
    if (arc.form.type == ConicType::hyperbola) {
        const double branch = cut_before(rest, 0.5 * (*infinity + 0.5), *infinity, reach);
        add({branch, 1.0 - branch});
    }
    add({1.0 - cut, 1.0});
    return curves;
}

}  // namespace batten::core
