/// A curve of OpenCASCADE, and its arrays, which count from 1.
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <span>

#include "core/curve/curve.h"

namespace batten::bench {

using OcctCurve = Handle(Geom2d_BSplineCurve);

template <class Array, class Values>
Array occt_array(const Values& values) {
    Array array(1, static_cast<int>(values.size()));
    for (int i = 1; i <= array.Length(); ++i) array(i) = values[static_cast<std::size_t>(i) - 1];
    return array;
}

TColgp_Array1OfPnt2d occt_array(std::span<const core::Point> points);

/// Throws Standard_Failure where OpenCASCADE refuses the curve.
OcctCurve occt_curve(const core::Curve& curve);

}  // namespace batten::bench
