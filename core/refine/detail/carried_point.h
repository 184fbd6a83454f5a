/// The control points of a curve one dimension up, near an origin of their own, and back again.
///
/// Lifting and projecting costs bits, and so do coordinates far from (0, 0) times weights. So points are carried as
/// seen from an origin near them, and each remembers which control point it is until something is done to it: what an
/// operation does not reach comes back bit-equal.
#pragma once

#include "core/base/detail/precise_point.h"
#include "core/curve/detail/spline.h"

namespace batten::core {

/// A homogeneous point under way. It may only enter into affine combinations, of which one of equal points is itself.
template <class Homogeneous, class Number>
struct Carried {
    static constexpr std::size_t is_new = static_cast<std::size_t>(-1);

    Homogeneous point{};
    std::size_t source = is_new;  ///< the control point that it is

    friend std::size_t common_source(const Carried& a, const Carried& b) {
        return a.source == b.source ? a.source : is_new;
    }
    friend Carried operator+(const Carried& a, const Carried& b) { return {a.point + b.point, common_source(a, b)}; }
    friend Carried operator-(const Carried& a, const Carried& b) { return {a.point - b.point, common_source(a, b)}; }
    friend Carried operator*(Number factor, const Carried& a) { return {factor * a.point, a.source}; }
};

using CarriedPoint = Carried<HomogeneousPoint, double>;
using CarriedSpline = Spline<CarriedPoint>;

/// In twice the precision, where what is extrapolated would lose more digits than a double has.
using PreciselyCarriedPoint = Carried<PreciseHomogeneousPoint, DoubleDouble>;
using PreciselyCarriedSpline = Spline<PreciselyCarriedPoint>;

inline PreciselyCarriedPoint blend_between(const PreciselyCarriedPoint& a, const PreciselyCarriedPoint& b, double lower,
                                           double upper, double u) {
    return blend_precisely(a, b, lower, upper, u);
}

/// The origin from which the points of `curve` are carried: in each coordinate 0, or, where all are so far from 0 that
/// their differences to it are exact, the least or greatest of them.
Point origin_near(const Curve& curve);

/// The spline of `curve`; of a periodic one the unrolled spline with `periods` whole periods more on both sides, so
/// that knot p + periods n is the lower end of the period. Weights that are all equal are carried as 1.
CarriedSpline carried(const Curve& curve, std::size_t periods = 0);

/// The same of an open curve.
PreciselyCarriedSpline carried_precisely(const Curve& curve);

/// What a curve that comes back is made of besides its points.
struct CarriedForm {
    int degree = 3;
    std::vector<double> knots{};  ///< one period when periodic
    bool is_periodic = false;
    KnotKind kind = KnotKind::custom;  ///< taken where the values have it
    Tears tears = Tears::refuse;       ///< a torn curve keeps its tears anyway
};

/// The curve of points carried from `from`. Errors: weight_not_positive; not_computable; those of Curve::make.
[[nodiscard]] Result<Curve> settled(const Curve& from, CarriedForm form, std::span<const CarriedPoint> points);

/// Whether points could not be `settled` because they were carried too far.
inline bool is_carried_too_far(const CurveError& error) {
    return error.code == CurveErrorCode::weight_not_positive || error.code == CurveErrorCode::not_computable;
}

/// The open curve of a spline carried from `from`.
[[nodiscard]] Result<Curve> settled(const Curve& from, CarriedSpline spline, KnotKind kind,
                                    Tears tears = Tears::refuse);
[[nodiscard]] Result<Curve> settled(const Curve& from, PreciselyCarriedSpline spline, KnotKind kind);

}  // namespace batten::core
