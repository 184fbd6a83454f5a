/// The curves of IGES entities by the numbers that the file has of them.
#pragma once

#include <IGESData_IGESEntity.hxx>

#include "exchange/occt/flat_curves.h"

namespace batten::exchange::occt {

/// The curve of `entity`, in lengths of which the file's unit has `unit`: of B-spline curves (126), of which
/// OpenCASCADE loses near knots and small weights, conics (104), which it turns and mirrors, and parametric splines
/// (112), whose joints it closes. None for other entities, which are as OpenCASCADE makes them.
std::optional<StatedCurve> iges_curve(const Handle(IGESData_IGESEntity) & entity, double unit);

}  // namespace batten::exchange::occt
