/// The joints that the continuity meter shows: knots of the active curve, its ends, and where it meets other curves.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/state/state.h"
#include "core/measure/continuity.h"

namespace batten::editor {

/// A knot inside the domain, or the seam.
struct KnotJoint {
    std::size_t knot = 0;  ///< the topmost of its stack, in stored()
    core::JointContinuity joint{};
};

/// Another curve that begins or ends where the active one does, or nearly there.
struct CurveMeeting {
    std::size_t other = 0;  ///< its index in the document
    core::JoinedEnds ends{};
    core::JointContinuity joint{};  ///< from the active curve into the other
};

struct ContinuityMeter {
    std::size_t count = 0;             ///< of distinct knots inside the domain
    std::size_t first = 0;             ///< how many of them lie before the rows
    std::vector<KnotJoint> rows{};     ///< those around the one that was chosen, all where they are few
    std::optional<KnotJoint> focus{};  ///< the knot that is hovered or selected, else that nearest to the parameter
    std::optional<core::JointContinuity> ends{};  ///< where the ends meet
    std::vector<CurveMeeting> meetings{};
};

/// The joints of the shown active curve, which must be there, at most `most_rows` (>= 1) of them as rows. The cost does
/// not grow with the number of its points.
ContinuityMeter continuity_meter(const EditorState& state, std::size_t most_rows);

}  // namespace batten::editor
