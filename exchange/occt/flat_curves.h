/// Curves in planes z = constant, of edges of OpenCASCADE or of the numbers of a file, as curves of a document.
#pragma once

#include <TopoDS_Edge.hxx>
#include <gp_GTrsf.hxx>
#include <gp_XYZ.hxx>
#include <optional>
#include <string>
#include <vector>

#include "core/curve/curve.h"

namespace batten::exchange::occt {

/// A curve in space by the numbers of its entity, and where that is placed.
struct SpatialCurve {
    core::CurveDefinition shape{};  ///< without its points
    std::vector<gp_XYZ> points{};
    std::vector<gp_GTrsf> placements{};    ///< of the points, the first one first
    std::optional<core::Interval> part{};  ///< of the domain; none: all of it
    double error = 0.0;                    ///< of the numbers, at most, before they are placed
    double contradiction = 0.0;            ///< how much of that is since the numbers contradict one another
};

/// Or the reason why there is none, as a part of a sentence.
using StatedCurve = tl::expected<SpatialCurve, std::string>;

enum class LeftOut { none, in_another_plane, of_another_kind, unbounded, not_computable };

/// How far a stated part of a curve is in its domain.
enum class PartInDomain {
    all,   ///< but for rounding
    some,  ///< which is what the curve was cut to
    none   ///< so that the curve is whole
};

struct FlatCurve {
    std::optional<core::Curve> curve{};
    double error = 0.0;          ///< at most
    double contradiction = 0.0;  ///< how much of that is since the numbers of a file contradict one another
    PartInDomain part = PartInDomain::all;
    double height = 0.0;
    LeftOut why = LeftOut::none;
    std::string reason{};  ///< why it is not computable, where that is known: a part of a sentence
};

/// The curve of `edge`, if it is a line, a conic, a Bézier or a B-spline curve, between its parameters, multiplied.
FlatCurve flat_curve(const TopoDS_Edge& edge, double parameter_factor = 1.0);

/// The stated curve, placed as `location` says at last.
FlatCurve flat_curve(const StatedCurve& stated, const gp_GTrsf& location);

}  // namespace batten::exchange::occt
