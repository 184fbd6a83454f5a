/// What is said of how smooth curves are where two pieces meet.
#pragma once

#include <string>

#include "app/editor/state/notation.h"
#include "core/measure/continuity.h"

namespace batten::editor {

/// What the knot promises and what the shape has: "C⁰ by its knots, G¹ by its shape", "C² by its knots, a cusp by its
/// shape". Of ends only what they have: "the ends meet with C¹ and G²". What is found goes up to 2.
std::string continuity_verdict(const core::JointContinuity& joint);

/// What agrees on both sides and what does not, with numbers: "the same direction, 2 times as fast beyond it".
std::string continuity_reason(const core::JointContinuity& joint, const Notation& notation);

/// The length of a jump; "0" where it is nothing but rounding.
std::string jump_text(const core::Jump& jump, const Notation& notation);

/// By how much the tangent turns, "90°"; "–" where a side has no direction.
std::string turn_text(const core::JointContinuity& joint, const Notation& notation);

/// By how much the curvature jumps; "–" where a side has none.
std::string curvature_jump_text(const core::JointContinuity& joint, const Notation& notation);

}  // namespace batten::editor
