/// What is told of a uniform cubic: the segment at the view's parameter, with the joints at its ends.
#pragma once

#include <array>
#include <optional>

#include "app/editor/state/state.h"
#include "core/curve/curve_end.h"
#include "core/evaluate/uniform_cubic.h"
#include "core/measure/cubic_joint.h"

namespace batten::editor {

/// What the shown active curve lacks for a uniform cubic with equal weights; what is named first is told first.
enum class CubicLack { curve, degree, knots, weights };

/// None where it lacks nothing. Cost O(1), but for knots that are seen the first time.
std::optional<CubicLack> cubic_lack(const EditorState& state);

struct ShownCubic {
    std::size_t segment = 0;
    std::size_t segment_count = 0;
    double t = 0.0;                       ///< how far u is in the segment, 0 to 1
    std::array<std::size_t, 4> points{};  ///< indices of its control points
    core::Anticentroid start{};           ///< the joint where it begins, at its second point
    core::Anticentroid end{};             ///< where it ends, at its third
    /// The joint that is told of in full: at the hovered point, else at the one that is selected, else at the point of
    /// the segment that acts most at u.
    core::Anticentroid focus{};
};

/// Of the shown active curve, which must lack nothing. Cost O(log n).
ShownCubic shown_cubic(const EditorState& state);

/// Whether control point `i` of a uniform cubic has a joint: all but the first and the last of an open one.
bool has_joint(const core::Curve& curve, std::size_t i);

/// Another uniform cubic that the active one may join.
struct JoinedCubic {
    std::size_t index = 0;         ///< of the other curve in the shown document
    core::CurveEnd end{};          ///< which end of the active curve is nearer to the other one
    core::CubicMeeting meeting{};  ///< the end of one and the start of the other, in this order
};

/// The next curve of the document, after the last one the first, where both are visible open uniform cubics with equal
/// weights. Cost as cubic_lack.
std::optional<JoinedCubic> joined_cubic(const EditorState& state);

}  // namespace batten::editor
