/// Sentences about what became of the smoothness of curves.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/measure/smoothness.h"
#include "core/refine/join.h"
#include "core/refine/match.h"

namespace batten::editor {

/// The sentences one after the other, with semicolons between them; none where there are none.
std::optional<std::string> told_in_turn(std::span<const std::string> sentences);

/// "the curve now has a corner of 2.4° at u = 0.5"; none where nothing was lost.
std::optional<std::string> lost_smoothness(std::span<const core::SmoothnessLoss> losses);

/// What a join did: which way the other curve, called `name`, was turned and where it stands, what the joint was and
/// is, how far the curve changed, and the degree where it is no longer `degree`.
std::string join_report(const std::string& name, const core::JoinedCurve& joined, int degree);

/// What matching an end of the curve called `name` did: what the joint was and is, how far the curve changed, and the
/// degree where it is no longer `degree`.
std::string match_report(const std::string& name, const core::MatchedCurve& matched, int degree,
                         core::GeometricContinuity continuity);

/// "G²", or "gap".
std::string level_text(int level);

}  // namespace batten::editor
