#include "app/editor/words/cubic_sentences.h"

#include <gtest/gtest.h>

#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

std::string told(core::Point before, core::Point vertex, core::Point after) {
    return joint_sentence(core::anticentroid_of(before, vertex, after), {"P₀", "P₁", "P₂"});
}

TEST(CubicSentences, say_what_a_curve_lacks) {
    EditorState state = test::sample_state();
    const std::string name = state.active_curve() == nullptr ? "" : state.shown().active_curve()->name;
    const auto with_name = [&](const std::string& before, const std::string& after) {
        std::string text = before;
        text.append(name).append(after);
        return text;
    };
    EXPECT_EQ(lack_sentence(state, CubicLack::degree),
              with_name("'", "' has degree 3; a uniform cubic has degree 3 and equally spaced knots."));
    EXPECT_EQ(
        lack_sentence(state, CubicLack::knots),
        with_name("The knots of '",
                  "' are not equally spaced; those of a uniform cubic are, all of them, with no multiple knots at "
                  "the ends."));
    EXPECT_EQ(lack_sentence(state, CubicLack::weights),
              with_name("The weights of '", "' differ; the constructions of a uniform cubic need equal ones."));
    const EditorState empty;
    EXPECT_EQ(lack_sentence(empty, CubicLack::curve),
              "There is no visible curve; a uniform cubic has degree 3 and equally spaced knots.");
}

TEST(CubicSentences, say_what_vertices_do_to_a_joint) {
    EXPECT_EQ(told({0, 0}, {6, 12}, {12, 6}),
              "The joint is one third of the median from P₁, and the tangent there is parallel to P₀ P₂.");
    EXPECT_EQ(told({0, 0}, {6, 12}, {9, 18}),
              "P₀, P₁ and P₂ are on one line: the curve touches it at the joint, without curvature.");
    EXPECT_EQ(told({0, 0}, {6, 12}, {12, 24}),
              "P₁ is midway between P₀ and P₂: the curve passes through it, and the second derivative is 0 there.");
    EXPECT_EQ(told({0, 0}, {6, 12}, {6, 12}),
              "P₁ equals P₂: the joint is one sixth along the leg to P₀, and the curve touches the leg there without "
              "curvature.");
    EXPECT_EQ(told({6, 12}, {6, 12}, {0, 0}),
              "P₁ equals P₀: the joint is one sixth along the leg to P₂, and the curve touches the leg there without "
              "curvature.");
    EXPECT_EQ(told({0, 0}, {6, 12}, {0, 0}),
              "P₀ equals P₂: the joint is one third along the leg from P₁, and the speed is 0 there.");
    EXPECT_EQ(
        told({0, 0}, {0, 0}, {0, 0}),
        "P₀, P₁ and P₂ are equal: the curve passes through them with speed 0, straight on both sides, and may turn "
        "in a corner.");
}

TEST(CubicSentences, say_what_end_vertices_do) {
    using core::CurveEnd;
    EXPECT_EQ(end_sentence(CurveEnd::start, {}, {"P₀", "P₁"}),
              "The curve begins in the anticentroid beside P₁, one third of the median from there, not in P₀.");
    EXPECT_EQ(end_sentence(CurveEnd::start, core::EndVertex::doubled, {"P₀", "P₁"}),
              "It begins one sixth along the leg from P₀ to P₁, in the direction of the leg and without curvature.");
    EXPECT_EQ(end_sentence(CurveEnd::end, core::EndVertex::tripled, {"P₄", "P₃"}),
              "It ends in P₄, with speed 0, and is straight from one sixth of the leg to P₃ on.");
    EXPECT_EQ(end_sentence(CurveEnd::end, core::EndVertex::phantom, {"P₄", "P₃"}),
              "It ends in P₄, coming from the direction of P₃ and without curvature.");
}

TEST(CubicSentences, say_how_two_curves_join) {
    core::CubicMeeting meeting;
    meeting.has_equal_steps = true;
    EXPECT_EQ(meeting_sentence(meeting),
              "They do not join; they would with C² if the three last vertices of the one were the three first of the "
              "other.");
    meeting.continuity = 0;
    EXPECT_EQ(meeting_sentence(meeting), "They join with C⁰: the joints are equal, the tangents are not.");
    meeting.continuity = 2;
    EXPECT_EQ(meeting_sentence(meeting), "They join with C²: the three vertices are common to both.");
    meeting.has_equal_steps = false;
    EXPECT_EQ(meeting_sentence(meeting), "They join with C² if u is counted in knot steps; as these differ, it is G².");
}

}  // namespace
}  // namespace batten::editor
