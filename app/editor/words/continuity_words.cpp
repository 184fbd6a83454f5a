#include "app/editor/words/continuity_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::JointContinuity;
using core::Place;
using core::sentence;

// The whole turn of a cusp, but for rounding.
constexpr double nearly_straight_back = 3.1415;

std::string class_text(const char* letter, int level) {
    return plain_text(fmt::format("{}^{{{}}}", letter, level));
}

bool is_cusp(const JointContinuity& joint) {
    return joint.geometric == 0 && joint.angle && std::abs(*joint.angle) > nearly_straight_back;
}

// What a shape has where no word is for it.
struct FoundPatterns {
    const char* gap;
    const char* cusp;
    const char* corner;
    const char* stop;
    const char* one_level;
    const char* both_levels;
};

constexpr FoundPatterns beside_promise{"{promised} by its knots, a gap by its shape",
                                       "{promised} by its knots, a cusp by its shape",
                                       "{promised} by its knots, a corner by its shape",
                                       "{promised} by its knots, a stop by its shape",
                                       "{promised} by its knots, {level} by its shape",
                                       "{promised} by its knots, {parametric} and {geometric} by its shape"};

constexpr FoundPatterns beside_tear{
    "torn by its knots, a gap by its shape",    "torn by its knots, a cusp by its shape",
    "torn by its knots, a corner by its shape", "torn by its knots, a stop by its shape",
    "torn by its knots, {level} by its shape",  "torn by its knots, {parametric} and {geometric} by its shape"};

constexpr FoundPatterns of_ends{"the ends do not meet",       "the ends meet in a cusp",
                                "the ends meet in a corner",  "the ends meet in a stop",
                                "the ends meet with {level}", "the ends meet with {parametric} and {geometric}"};

constexpr FoundPatterns of_curves{"the curves do not meet",       "the curves meet in a cusp",
                                  "the curves meet in a corner",  "the curves meet in a stop",
                                  "the curves meet with {level}", "the curves meet with {parametric} and {geometric}"};

const FoundPatterns& patterns_of(const JointContinuity& joint) {
    if (joint.kind == core::JointKind::ends) return of_ends;
    if (joint.kind == core::JointKind::curves) return of_curves;
    return joint.promised < 0 ? beside_tear : beside_promise;
}

const char* found_pattern(const FoundPatterns& patterns, const JointContinuity& joint) {
    if (joint.geometric < 0) return patterns.gap;
    if (is_cusp(joint)) return patterns.cusp;
    if (joint.geometric == 0) return joint.angle ? patterns.corner : patterns.stop;
    const bool tells_both = joint.parametric > std::max(joint.promised, 0) && joint.geometric > joint.parametric;
    return tells_both ? patterns.both_levels : patterns.one_level;
}

std::string better_level(const JointContinuity& joint) {
    return joint.geometric > joint.parametric ? class_text("G", joint.geometric) : class_text("C", joint.parametric);
}

// Nothing is to be said beside what the knots promise; what is found goes up to 2.
bool is_as_promised(const JointContinuity& joint) {
    const bool are_ends = joint.kind == core::JointKind::ends || joint.kind == core::JointKind::curves;
    if (are_ends || joint.promised < 1 || joint.geometric < 1) return false;
    return std::max(joint.parametric, joint.geometric) <= joint.promised;
}

std::string turn_in_degrees(double radians, const Notation& notation) {
    return sentence("{degrees}°", {{"degrees", exact_text(notation, std::abs(radians) * 180.0 / std::numbers::pi)}});
}

std::string speed_reason(const JointContinuity& joint, const Notation& notation) {
    const auto ratio = core::speed_ratio(joint);
    if (!ratio) return "the same direction; the speed is zero on one side";
    const Place times("ratio", exact_text(notation, *ratio));
    return joint.geometric < 2 ? sentence("the same direction; {ratio} times as fast beyond it", {times})
                               : sentence("the same direction and curvature; {ratio} times as fast beyond it", {times});
}

std::string acceleration_reason(const JointContinuity& joint, const Notation& notation) {
    if (joint.geometric > 1) return "C′ and the curvature agree; C″ jumps along the tangent";
    if (!joint.before || !joint.after) return "C′ agrees; C″ jumps";
    return sentence("C′ agrees; the curvature jumps from {before} to {after}",
                    {{"before", exact_text(notation, *joint.before)}, {"after", exact_text(notation, *joint.after)}});
}

}  // namespace

std::string continuity_verdict(const JointContinuity& joint) {
    const Place promised("promised", class_text("C", joint.promised));
    if (is_as_promised(joint)) return sentence("{promised} by its knots", {promised});
    return core::filled_as_needed(found_pattern(patterns_of(joint), joint),
                                  {promised,
                                   {"level", better_level(joint)},
                                   {"parametric", class_text("C", joint.parametric)},
                                   {"geometric", class_text("G", joint.geometric)}});
}

std::string continuity_reason(const JointContinuity& joint, const Notation& notation) {
    if (joint.geometric < 0) return sentence("a gap of {gap}", {{"gap", exact_text(notation, joint.position.size)}});
    if (is_cusp(joint) && joint.parametric > 0) return "the speed falls to zero, and the curve turns back";
    if (joint.geometric == 0 && !joint.angle) return "a piece beside it is a single point";
    if (joint.geometric == 0)
        return sentence("the direction turns by {angle}", {{"angle", turn_in_degrees(*joint.angle, notation)}});
    if (joint.parametric == 0) return speed_reason(joint, notation);
    return joint.parametric == 1 ? acceleration_reason(joint, notation) : "C′ and C″ agree";
}

std::string jump_text(const core::Jump& jump, const Notation& notation) {
    return jump.is_rounding() ? "0" : exact_text(notation, jump.size);
}

std::string turn_text(const JointContinuity& joint, const Notation& notation) {
    if (!joint.angle) return "–";
    return turn_in_degrees(joint.geometric > 0 ? 0.0 : *joint.angle, notation);
}

std::string curvature_jump_text(const JointContinuity& joint, const Notation& notation) {
    if (!joint.before || !joint.after) return "–";
    return joint.geometric > 1 ? "0" : exact_text(notation, std::abs(*joint.after - *joint.before));
}

}  // namespace batten::editor
