#include "exchange/occt/geom_curves.h"

#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include "core/curve/knot_analysis.h"

namespace batten::exchange::occt {

namespace {

Handle(Geom_BSplineCurve) spline_of(const core::Curve& curve) {
    const std::vector<core::DistinctKnot> distinct = core::distinct_knots(curve.knots());
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, knots.Length());
    for (int k = 1; k <= knots.Length(); ++k) {
        knots(k) = distinct[static_cast<std::size_t>(k) - 1].value;
        multiplicities(k) = distinct[static_cast<std::size_t>(k) - 1].multiplicity;
    }
    TColgp_Array1OfPnt poles(1, static_cast<int>(curve.control_points().size()));
    TColStd_Array1OfReal weights(1, poles.Length());
    for (int i = 1; i <= poles.Length(); ++i) {
        const core::Point point = curve.control_points()[static_cast<std::size_t>(i) - 1];
        poles(i) = gp_Pnt(point.x, point.y, 0.0);
        weights(i) = curve.weights()[static_cast<std::size_t>(i) - 1];
    }
    if (!curve.is_rational()) return new Geom_BSplineCurve(poles, knots, multiplicities, curve.degree());
    return new Geom_BSplineCurve(poles, weights, knots, multiplicities, curve.degree());
}

}  // namespace

std::vector<NamedSpline> geom_curves(const core::Document& document) {
    std::vector<NamedSpline> curves;
    for (const core::DocumentCurve& entry : document.curves) {
        try {
            curves.push_back({entry.name, spline_of(*entry.curve)});
        } catch (const Standard_Failure&) {
            continue;  // whoever asked for it misses it in the file
        }
    }
    return curves;
}

bool is_in_inches(const core::Document& document) {
    return document.units && document.units->unit == core::LengthUnit::inch;
}

}  // namespace batten::exchange::occt
