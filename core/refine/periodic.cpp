#include "core/refine/periodic.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/detail/edit_checks.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/closing.h"
#include "core/measure/deviation.h"
#include "core/refine/clamping.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_removal.h"

namespace batten::core {

namespace {

template <class T>
auto iterator_at(T& container, std::size_t i) {
    return container.begin() + static_cast<std::ptrdiff_t>(i);
}

Result<void> check_closed(const Curve& curve, double tolerance) {
    if (curve.is_periodic()) return {};
    const auto [lower, upper] = curve.domain();
    const double gap = robust_length(point_at(curve, upper) - point_at(curve, lower));
    if (gap <= tolerance) return {};
    return refuse_computed({.code = CurveErrorCode::ends_apart, .value = gap, .upper = tolerance});
}

// `curve` with knot `u` of multiplicity `wanted`.
Result<Curve> with_multiplicity(const Curve& curve, double u, int wanted) {
    const int missing = wanted - curve.knots().multiplicity(u);
    return missing > 0 ? insert_knot(curve, u, missing) : Result<Curve>(curve);
}

// Knots, points and weights on their way to another form.
void drop_last(CurveDefinition& curve, std::size_t count) {
    curve.knots.resize(curve.knots.size() - count);
    curve.points.resize(curve.points.size() - count);
    curve.weights.resize(curve.weights.size() - count);
}

// The points i of the unrolled curve, first <= i < end.
void take_unrolled(const Curve& curve, std::size_t first, std::size_t end, CurveDefinition& into) {
    const std::size_t n = curve.control_points().size();
    into.points.clear();
    into.weights.clear();
    for (std::size_t i = first; i < end; ++i) {
        into.points.push_back(curve.control_points()[i % n]);
        into.weights.push_back(curve.weights()[i % n]);
    }
}

// With p knots at the seam, of which b are named at the upper end, the point there is number p - b of the unrolled
// ones.
Result<Curve> opened_at_seam(const Curve& curve) {
    const auto [lower, upper] = curve.domain();
    Result<Curve> full = with_multiplicity(curve, lower, curve.degree());
    if (!full) return full;
    CurveDefinition definition = full->definition();
    auto& knots = definition.knots;
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = full->control_points().size();
    const auto at_upper = static_cast<std::size_t>(std::count(knots.begin(), knots.end(), upper));
    take_unrolled(*full, p - at_upper, p - at_upper + n + 1, definition);
    knots.erase(std::lower_bound(knots.begin(), knots.end(), upper), knots.end());
    knots.erase(knots.begin(), std::upper_bound(knots.begin(), knots.end(), lower));
    knots.insert(knots.begin(), p + 1, lower);
    knots.insert(knots.end(), p + 1, upper);
    definition.periodic = false;
    return Curve::make(std::move(definition));
}

// The change of parameter that makes the weights at the ends of a clamped curve equal.
//
// With c = (w_n / w_0)^(1/p), s = t / (t + c (1 - t)) and both in [0, 1], the homogeneous points times (t + c (1 -
// t))^p make a spline again: knot s becomes t = s c / (1 - s + s c), and a point is multiplied by c / (1 - s + s c) for
// each of its knots. Source: Lee and Lucian 1991.
class EqualEndWeights {
  public:
    explicit EqualEndWeights(const Curve& clamped)
        : domain_(clamped.domain()),
          c_(std::pow(clamped.weights().back() / clamped.weights().front(), 1.0 / clamped.degree())) {}

    double parameter(double u) const {
        if (c_ == 1.0 || u == domain_.lower || u == domain_.upper) return u;
        return domain_.lower + domain_.length() * ((u - domain_.lower) / domain_.length() * factor(u));
    }

    Result<Curve> curve(const Curve& clamped) const {
        if (c_ == 1.0) return clamped;
        CurveDefinition definition = clamped.definition();
        const auto p = static_cast<std::size_t>(clamped.degree());
        for (std::size_t i = 0; i < definition.weights.size(); ++i)
            for (std::size_t k = i + 1; k <= i + p; ++k) definition.weights[i] *= factor(definition.knots[k]);
        definition.weights.front() = definition.weights.back();
        for (double& knot : definition.knots) knot = parameter(knot);
        return Curve::make(std::move(definition));
    }

  private:
    double factor(double u) const {
        return c_ / ((domain_.upper - u) / domain_.length() + (u - domain_.lower) / domain_.length() * c_);
    }

    Interval domain_;
    double c_;
};

// A clamped curve whose ends are one point; the seam gets multiplicity p, once at its lower end.
Result<Curve> closed_at_ends(const Curve& clamped) {
    CurveDefinition definition = clamped.definition();
    const auto p = static_cast<std::size_t>(clamped.degree());
    drop_last(definition, 1);
    definition.knots.erase(definition.knots.begin(), iterator_at(definition.knots, p));
    definition.periodic = true;
    return Curve::make(std::move(definition));
}

Result<Curve> unwrapped(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    const auto p = static_cast<std::size_t>(curve.degree());
    definition.periodic = true;
    if (definition.kind == KnotKind::uniform) definition.kind = KnotKind::periodic;
    drop_last(definition, p);
    definition.knots.erase(definition.knots.begin(), iterator_at(definition.knots, p));
    return Curve::make(std::move(definition));
}

// The open curve whose knots and points are those of the unrolled periodic one.
Result<Curve> wrapped(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    const auto values = curve.knots().values();
    definition.knots.assign(values.begin(), values.end());
    take_unrolled(curve, 0, values.size() - static_cast<std::size_t>(curve.degree()) - 1, definition);
    definition.periodic = false;
    if (definition.kind == KnotKind::periodic) definition.kind = KnotKind::uniform;
    return Curve::make(std::move(definition));
}

// Closed by its ends or by wrapped points, in periodic form; the seam of the first has multiplicity p.
Result<Approximation> closed_form(const Curve& curve, double tolerance) {
    const auto check = check_tolerance(tolerance).and_then([&] { return check_closed(curve, tolerance); });
    if (!check) return refuse(check.error());
    if (curve.is_periodic()) return Approximation{curve, 0.0};
    if (closing_of(curve).closing == Closing::wrapped) {
        const Result<Curve> result = unwrapped(curve);
        const double error = result ? largest_deviation(curve, *result) : 0.0;
        // Else only the ends are near enough.
        if (error <= tolerance) return result.map([&](const Curve& closed) { return Approximation{closed, error}; });
    }
    const Result<Curve> clamped =
        to_clamped(curve).and_then([](const Curve& open) { return EqualEndWeights(open).curve(open); });
    if (!clamped) return refuse(clamped.error());
    return closed_at_ends(*clamped).map([&](const Curve& closed) {
        return Approximation{closed, largest_deviation(*clamped, closed)};
    });
}

// The periodic curve with knot k of its period as the seam: t_k, ..., t_n and on, as the period is unrolled.
Result<Curve> rotated(const Curve& curve, std::size_t k) {
    CurveDefinition definition = curve.definition();
    const std::vector<double> period = unroll_period(curve.knots().stored(), 0, k);
    definition.knots.assign(iterator_at(period, k), period.end());
    std::rotate(definition.points.begin(), iterator_at(definition.points, k), definition.points.end());
    std::rotate(definition.weights.begin(), iterator_at(definition.weights, k), definition.weights.end());
    return Curve::make(std::move(definition));
}

Result<Curve> with_seam_at(const Curve& curve, double u) {
    const auto [lower, upper] = curve.domain();
    if (u == lower || u == upper) return curve;
    return with_multiplicity(curve, u, 1).and_then([u](const Curve& knotted) {
        const auto stored = knotted.knots().stored();
        return rotated(knotted,
                       static_cast<std::size_t>(std::lower_bound(stored.begin(), stored.end(), u) - stored.begin()));
    });
}

}  // namespace

Result<Approximation> to_periodic(const Curve& curve, double tolerance) {
    Result<Approximation> closed = closed_form(curve, tolerance);
    if (!closed) return closed;
    const KnotVector& knots = closed->curve.knots();
    const double seam = knots.domain().lower;
    const int spare = knots.multiplicity(seam) - 1;
    // What is periodic or wrapped has the seam that its knots say.
    if (curve.is_periodic() || spare < curve.degree() - 1 || spare < 1) return closed;
    const Result<KnotRemoval> smooth = remove_knot(closed->curve, seam, spare, tolerance - closed->error);
    // Too few points to spare one, or nothing left of the tolerance.
    if (!smooth) return closed;
    return Approximation{smooth->curve, closed->error + smooth->error};
}

Result<Curve> to_clamped(const Curve& curve) {
    if (curve.is_periodic()) return opened_at_seam(curve);
    return clamp(curve, CurveEnd::start).and_then([](const Curve& half) { return clamp(half, CurveEnd::end); });
}

Result<Approximation> to_wrapped(const Curve& curve, double tolerance) {
    if (closing_of(curve).closing == Closing::wrapped) return Approximation{curve, 0.0};
    return to_periodic(curve, tolerance).and_then([](const Approximation& periodic) {
        return wrapped(periodic.curve).map([&](Curve result) {
            return Approximation{std::move(result), periodic.error};
        });
    });
}

Result<Approximation> move_seam(const Curve& curve, double u, double tolerance) {
    if (const auto check = check_parameter_finite(u); !check) return refuse(check.error());
    if (const auto check = check_in_domain(curve.knots(), u); !check) return refuse(check.error());
    const Interval domain = curve.domain();
    Result<Approximation> closed = closed_form(curve, tolerance);
    if (!closed) return closed;
    if (u == domain.lower || u == domain.upper) return Approximation{curve, 0.0};
    const bool is_wrapped = closing_of(curve).closing == Closing::wrapped;
    const Result<Curve> clamped = to_clamped(curve);
    const double seam = is_wrapped || !clamped ? u : EqualEndWeights(*clamped).parameter(u);
    return with_seam_at(closed->curve, seam)
        .and_then([&](const Curve& moved) -> Result<Curve> {
            if (curve.is_periodic()) return moved;
            return is_wrapped ? wrapped(moved) : to_clamped(moved);
        })
        .map([&](Curve result) {
            return Approximation{std::move(result), closed->error};
        });
}

}  // namespace batten::core
