#include "app/editor/words/cubic_sentences.h"

#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

std::string doubled_sentence(const core::Anticentroid& joint, const std::array<std::string, 3>& names) {
    const bool equals_before = core::distance(joint.before, joint.vertex) <= core::distance(joint.vertex, joint.after);
    return sentence(
        "{vertex} equals {neighbor}: the joint is one sixth along the leg to {other}, and the curve touches the leg "
        "there without curvature.",
        {{"vertex", names[1]},
         {"neighbor", equals_before ? names[0] : names[2]},
         {"other", equals_before ? names[2] : names[0]}});
}

const char* start_pattern(std::optional<core::EndVertex> vertex) {
    if (!vertex)
        return "The curve begins in the anticentroid beside {inner}, one third of the median from there, not in "
               "{outer}.";
    switch (*vertex) {
        case core::EndVertex::doubled:
            return "It begins one sixth along the leg from {outer} to {inner}, in the direction of the leg and without "
                   "curvature.";
        case core::EndVertex::tripled:
            return "It begins in {outer}, with speed 0, and is straight up to one sixth of the leg to {inner}.";
        case core::EndVertex::phantom:
            break;
    }
    return "It begins in {outer}, in the direction of {inner} and without curvature.";
}

const char* end_pattern(std::optional<core::EndVertex> vertex) {
    if (!vertex)
        return "The curve ends in the anticentroid beside {inner}, one third of the median from there, not in {outer}.";
    switch (*vertex) {
        case core::EndVertex::doubled:
            return "It ends one sixth along the leg from {outer} to {inner}, in the direction of the leg and without "
                   "curvature.";
        case core::EndVertex::tripled:
            return "It ends in {outer}, with speed 0, and is straight from one sixth of the leg to {inner} on.";
        case core::EndVertex::phantom:
            break;
    }
    return "It ends in {outer}, coming from the direction of {inner} and without curvature.";
}

}  // namespace

std::string lack_sentence(const EditorState& state, CubicLack lack) {
    if (lack == CubicLack::curve)
        return "There is no visible curve; a uniform cubic has degree 3 and equally spaced knots.";
    const core::Place name("name", state.shown().active_curve()->name);
    switch (lack) {
        case CubicLack::degree:
            return sentence("'{name}' has degree {degree}; a uniform cubic has degree 3 and equally spaced knots.",
                            {name, {"degree", state.active_curve()->degree()}});
        case CubicLack::weights:
            return sentence("The weights of '{name}' differ; the constructions of a uniform cubic need equal ones.",
                            {name});
        case CubicLack::curve:
        case CubicLack::knots:
            break;
    }
    return sentence(
        "The knots of '{name}' are not equally spaced; those of a uniform cubic are, all of them, with no multiple "
        "knots "
        "at the ends.",
        {name});
}

std::string joint_sentence(const core::Anticentroid& joint, const std::array<std::string, 3>& names) {
    const core::Place before("before", names[0]);
    const core::Place vertex("vertex", names[1]);
    const core::Place after("after", names[2]);
    switch (core::case_of(joint)) {
        case core::CubicJointCase::triangle:
            break;
        case core::CubicJointCase::collinear:
            return sentence(
                "{before}, {vertex} and {after} are on one line: the curve touches it at the joint, without curvature.",
                {before, vertex, after});
        case core::CubicJointCase::centered:
            return sentence(
                "{vertex} is midway between {before} and {after}: the curve passes through it, and the second "
                "derivative is 0 there.",
                {before, vertex, after});
        case core::CubicJointCase::doubled:
            return doubled_sentence(joint, names);
        case core::CubicJointCase::folded:
            return sentence(
                "{before} equals {after}: the joint is one third along the leg from {vertex}, and the speed is 0 "
                "there.",
                {before, vertex, after});
        case core::CubicJointCase::tripled:
            return sentence(
                "{before}, {vertex} and {after} are equal: the curve passes through them with speed 0, straight on "
                "both "
                "sides, and may turn in a corner.",
                {before, vertex, after});
    }
    return sentence(
        "The joint is one third of the median from {vertex}, and the tangent there is parallel to {before} {after}.",
        {before, vertex, after});
}

std::string end_sentence(core::CurveEnd end, std::optional<core::EndVertex> vertex,
                         const std::array<std::string, 2>& names) {
    const char* pattern = end == core::CurveEnd::start ? start_pattern(vertex) : end_pattern(vertex);
    return core::filled_as_needed(pattern, {{"outer", names[0]}, {"inner", names[1]}});
}

std::string meeting_sentence(const core::CubicMeeting& meeting) {
    switch (meeting.continuity) {
        case 0:
            return "They join with C⁰: the joints are equal, the tangents are not.";
        case 1:
            return meeting.has_equal_steps
                       ? "They join with C¹: joints and tangents are equal, the second derivatives are not."
                       : "They join with C¹ if u is counted in knot steps; as these differ, it is G¹.";
        case 2:
            return meeting.has_equal_steps
                       ? "They join with C²: the three vertices are common to both."
                       : "They join with C² if u is counted in knot steps; as these differ, it is G².";
        default:
            return "They do not join; they would with C² if the three last vertices of the one were the three first of "
                   "the other.";
    }
}

}  // namespace batten::editor
