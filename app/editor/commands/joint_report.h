/// Sentences about what became of the smoothness of curves.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/editor/words/length.h"
#include "core/curve/control_box.h"
#include "core/measure/meeting.h"
#include "core/measure/smoothness.h"
#include "core/refine/join.h"
#include "core/refine/match.h"

namespace batten::editor {

/// The sentences one after the other, with semicolons between them; none where there are none.
std::optional<std::string> told_in_turn(std::span<const std::string> sentences);

/// "the curve now has a corner of 2.4° at u = 0.5"; none where nothing was lost.
std::optional<std::string> lost_smoothness(const Units& units, std::span<const core::SmoothnessLoss> losses);

/// What a joint was and is, run through from the curve that was named first into the other one.
struct JointChange {
    core::Meeting before;
    core::Meeting after;
};
JointChange change_of(const core::JoinedCurve& joined);
JointChange change_of(const core::MatchedCurve& matched);

/// The meeting of curves in this box with 0 for all that is not above rounding, and a turn to the left or the right
/// alike.
core::Meeting without_noise(core::Meeting meeting, const core::Box& box);

/// The meeting with its gap in the document's unit, and curvatures and their changes in its inverse and the square.
core::Meeting in_units(const Units& units, core::Meeting meeting);

/// What a join did: which way the other curve, called `name`, was turned and where it stands, what the joint was and
/// is, how far the curve changed, and the degree where it is no longer `degree`.
std::string join_report(const std::string& name, const core::JoinedCurve& joined, int degree, const Units& units);

/// What matching an end of the curve called `name` did: what the joint was and is, how far the curve changed, and the
/// degree where it is no longer `degree`.
std::string match_report(const std::string& name, const core::MatchedCurve& matched, int degree,
                         core::GeometricContinuity continuity, const Units& units);

/// "G²", or "gap".
std::string level_text(int level);

}  // namespace batten::editor
