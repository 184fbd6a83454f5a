/// What the pointer can snap to, and which of these are switched on.
#pragma once

#include <bitset>
#include <cstddef>

#include "core/base/names.h"

namespace batten::editor {

/// In the order in which they are listed.
enum class SnapKind {
    grid,
    guides,
    points,     ///< control points that are shown
    knots,      ///< of all curves
    ends,       ///< likewise
    midpoints,  ///< of the legs of polygons that are shown
    curve,      ///< its nearest place
    perpendicular,
    tangent,
    intersections,
    angles  ///< directions from where a gesture began
};
inline constexpr std::size_t snap_kind_count = 11;

class SnapKinds {
  public:
    bool has(SnapKind kind) const { return bits_.test(static_cast<std::size_t>(kind)); }
    void set(SnapKind kind, bool on) { bits_.set(static_cast<std::size_t>(kind), on); }
    bool operator==(const SnapKinds&) const = default;

  private:
    std::bitset<snap_kind_count> bits_{0b01000010110};  // guides, points, ends and intersections
};

/// How pointers snap.
struct SnapSettings {
    SnapKinds kinds;
    double angle_step = 15.0;  ///< degrees, above 0
    bool operator==(const SnapSettings&) const = default;
};

/// What the step of angles may be.
inline constexpr double least_angle_step = 0.1;
inline constexpr double greatest_angle_step = 90.0;

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::SnapKind> {
    using enum editor::SnapKind;
    static constexpr std::array table{Named{grid, "grid", "grid"},
                                      Named{guides, "guides", "guides"},
                                      Named{points, "points", "control points"},
                                      Named{knots, "knots", "knots"},
                                      Named{ends, "ends", "ends"},
                                      Named{midpoints, "midpoints", "midpoints of legs"},
                                      Named{curve, "curve", "curves"},
                                      Named{perpendicular, "perpendicular", "perpendicular"},
                                      Named{tangent, "tangent", "tangent"},
                                      Named{intersections, "intersections", "intersections"},
                                      Named{angles, "angles", "angles"}};
};

}  // namespace batten::core
