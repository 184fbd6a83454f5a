/// Curves of a document as OpenCASCADE has them.
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <string>
#include <vector>

#include "exchange/report.h"

namespace batten::exchange::occt {

struct NamedSpline {
    std::string name;
    Handle(Geom_BSplineCurve) spline;
};

/// What is to be written: the visible curves, in lengths of a unit that files have.
struct GeomCurves {
    std::vector<NamedSpline> curves;
    bool is_in_inches = false;  ///< else in millimeters
    Report report{};
};

/// Curves that are not clamped, periodic or torn are written otherwise, and a document without such a unit, which the
/// report says. Error: there is no curve, or none that OpenCASCADE accepts.
core::FileResult<GeomCurves> geom_curves(const core::Document& document);

}  // namespace batten::exchange::occt
