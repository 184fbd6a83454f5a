/// The operations whose accuracy is compared, as one interface in front of each spline library.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/curve/curve.h"

namespace batten::bench {

using core::Curve;
using core::CurveDefinition;
using core::Point;

/// What is interpolated, and over which knots.
struct InterpolationTask {
    int degree = 3;
    std::vector<Point> through;
    std::vector<double> parameters;  ///< one for each point, exact but for one rounding
    std::vector<double> knots;       ///< the averages of the parameters, likewise
};

/// A library. Every operation answers nothing where the library has no such operation, refuses the case, or throws.
class SplineLibrary {
  public:
    template <class T>
    using Answer = std::optional<T>;
    using Rows = std::vector<std::vector<double>>;

    virtual ~SplineLibrary() = default;

    /// With the version.
    virtual std::string name() const = 0;

    /// C(u), C'(u), ..., of the side that lies inside the domain, on the right of a knot; derivatives as their tips, as
    /// the reference results have them.
    virtual Answer<std::vector<Point>> derivatives(const Curve&, double, int) const { return {}; }

    /// Row r holds the r-th derivatives of the degree + 1 functions that do not vanish on the right of a knot, up to
    /// the order given.
    virtual Answer<Rows> basis(const core::KnotVector&, double, int) const { return {}; }

    virtual Answer<CurveDefinition> insert(const Curve&, std::span<const double>) const { return {}; }

    /// The reverse of insert: one knot less for each value, if that changes the shape by no more than a tolerance.
    virtual Answer<CurveDefinition> remove(const Curve&, std::span<const double>, double) const { return {}; }

    virtual Answer<CurveDefinition> elevate(const Curve&, int) const { return {}; }

    /// The clamped parts on both sides of a parameter.
    virtual Answer<std::vector<CurveDefinition>> split(const Curve&, double) const { return {}; }

    /// The control points and weights of the Bézier pieces, one definition for each; knots are left out.
    virtual Answer<std::vector<CurveDefinition>> bezier_pieces(const Curve&) const { return {}; }

    /// The derivative of a polynomial curve as a curve.
    virtual Answer<CurveDefinition> hodograph(const Curve&) const { return {}; }

    virtual Answer<double> curvature(const Curve&, double) const { return {}; }
    virtual Answer<double> arc_length(const Curve&) const { return {}; }
    virtual Answer<Point> closest_point(const Curve&, Point) const { return {}; }
    virtual Answer<CurveDefinition> interpolate(const InterpolationTask&) const { return {}; }
};

std::unique_ptr<SplineLibrary> make_batten();
std::unique_ptr<SplineLibrary> make_sisl();
std::unique_ptr<SplineLibrary> make_occt();

}  // namespace batten::bench
