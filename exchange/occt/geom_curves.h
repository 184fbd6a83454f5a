/// Curves of a document as OpenCASCADE has them.
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <string>
#include <vector>

#include "core/document/document.h"

namespace batten::exchange::occt {

struct NamedSpline {
    std::string name;
    Handle(Geom_BSplineCurve) spline;
};

/// The curves of `document`, which are clamped, but for those whose knots OpenCASCADE does not take.
std::vector<NamedSpline> geom_curves(const core::Document& document);

/// Whether lengths are inches, else millimeters.
bool is_in_inches(const core::Document& document);

}  // namespace batten::exchange::occt
