/// Offsets with few points, whose loops are cut away.
#pragma once

#include <vector>

#include "core/base/names.h"
#include "core/base/progress.h"
#include "core/curve/curve.h"

namespace batten::core {

enum class OffsetSide { left, right, both };

/// What goes around a corner on its outer side.
enum class OffsetCorners {
    mitre,  ///< both sides go on straight until they meet; a bevel where that is farther away than 4 distances
    round,  ///< an arc about the corner
    bevel   ///< a straight line
};

/// How the offsets on both sides of an open curve are joined at its ends.
enum class OffsetCaps { none, flat, round };

template <>
struct Names<OffsetSide> {
    static constexpr std::array table{Named{OffsetSide::left, "left", "left"},
                                      Named{OffsetSide::right, "right", "right"},
                                      Named{OffsetSide::both, "both", "both sides"}};
};

template <>
struct Names<OffsetCorners> {
    static constexpr std::array table{Named{OffsetCorners::mitre, "mitre", "mitered"},
                                      Named{OffsetCorners::round, "round", "round"},
                                      Named{OffsetCorners::bevel, "bevel", "beveled"}};
};

template <>
struct Names<OffsetCaps> {
    static constexpr std::array table{Named{OffsetCaps::none, "none", "none"}, Named{OffsetCaps::flat, "flat", "flat"},
                                      Named{OffsetCaps::round, "round", "round"}};
};

struct OffsetRequest {
    double distance = 0.0;   ///< to the left; a negative one exchanges left and right
    double tolerance = 0.0;  ///< > 0: how far the result may be from the true offset
    OffsetSide side = OffsetSide::left;
    OffsetCorners corners = OffsetCorners::mitre;
    OffsetCaps caps = OffsetCaps::none;  ///< of both sides of an open curve; else of no consequence
};

/// Curves that together are one offset, and how far they are from the true one at samples between those that were
/// fitted.
struct OffsetCurves {
    std::vector<Curve> curves{};
    double error = 0.0;
};

/// The places at the distance from `curve` on the sides asked for, as far as no other part of the curve is nearer: what
/// is nearer is cut away, at the crossings, so that a closed curve may come apart into several, and one that crosses
/// itself into open ones. They go the same way as `curve`; with caps they are closed and run counter-clockwise about
/// it.
/// - Lines, circles and arcs are exact; so is all of a polygon.
/// - All others are cubics with C2, with as many points as the tolerance needs, spaced by length; where the curve is
///   less than G2 so is the offset.
/// Errors: vector_not_finite; tolerance_not_positive; curve_has_corner where it is torn; curve_stands_still;
/// tolerance_not_reached; shape_vanishes where nothing is left; shapes_not_decided; not_computable. Source: the
/// untrimmed offset C + d N is cut where it crosses itself, and parts whose middle is nearer than d are left out.
[[nodiscard]] Result<OffsetCurves> offset_shape(const Curve& curve, const OffsetRequest& request,
                                                const Progress& progress = {});

}  // namespace batten::core
