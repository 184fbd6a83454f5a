#include "app/editor/commands/subdivision_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "core/measure/deviation.h"
#include "core/refine/bezier_form.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class SubdivisionCommands : public ::testing::Test {
  protected:
    bool type(const std::string& text) { return run_typed(editor_, text); }
    const std::string& message() const { return editor_.state().message.text; }

    Editor editor_;
};

TEST_F(SubdivisionCommands, midpoints_in_rounds_quarter_the_distance) {
    // A parabola of height 2: the distance is 1 at first and 1/16 after two rounds, in which there are 4 spans.
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
        { "name": "arch", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,2],[2,0]] } ] })");
    const core::Curve before = curve(editor_);
    ASSERT_TRUE(type("refine-midpoints 2")) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1}));
    EXPECT_LT(core::largest_deviation(before, curve(editor_)), 1e-15);
    EXPECT_EQ(
        message(),
        "Inserted 3 knots at the midpoints of all spans, in 2 rounds; the curve is unchanged; the control polygon "
        "is at most 0.0625 from it now, 1 before");
    EXPECT_EQ(editor_.state().history.undo_count(), 1u);
}

TEST_F(SubdivisionCommands, midpoints_take_one_round_or_more_but_not_too_many) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(type("refine-midpoints 0"));
    EXPECT_FALSE(type("refine-midpoints 21"));
    ASSERT_TRUE(type("refine-midpoints")) << message();
    EXPECT_EQ(points(editor_).size(), 11u);
    EXPECT_FALSE(type("refine-midpoints 18"));
    EXPECT_EQ(message(), "that would make 2097155 control points; at most 1000000 are made");
}

TEST_F(SubdivisionCommands, bezier_form_comes_step_by_step) {
    open_text(editor_, sample_text);  // 0, 0, 0, 0, 0.2, 0.5, 0.75, 1, 1, 1, 1
    const core::Curve before = curve(editor_);
    ASSERT_TRUE(type("insert-for-bezier")) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.2, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(editor_.state().selection.knot, 5u);
    EXPECT_EQ(message(),
              "Inserted knot 0.2: multiplicity 2, C¹ there; the curve is unchanged; 5 more make all pieces Bézier");
    for (int step = 0; step < 4; ++step) ASSERT_TRUE(type("insert-for-bezier")) << message();
    EXPECT_EQ(message(),
              "Inserted knot 0.75: multiplicity 2, C¹ there; the curve is unchanged; one more makes all pieces Bézier");
    ASSERT_TRUE(type("insert-for-bezier")) << message();
    EXPECT_EQ(message(),
              "Inserted knot 0.75: multiplicity 3, C⁰ there; the curve is unchanged; now the control points are those "
              "of the Bézier pieces");
    const core::Curve expected = core::to_bezier(before).value();
    ASSERT_EQ(points(editor_).size(), expected.control_points().size());
    for (std::size_t i = 0; i < points(editor_).size(); ++i)
        EXPECT_LT(core::distance(points(editor_)[i], expected.control_points()[i]), 1e-13) << i;
    EXPECT_FALSE(type("insert-for-bezier"));
    EXPECT_EQ(message(), "every knot has multiplicity p: the control points are those of the Bézier pieces");
}

TEST_F(SubdivisionCommands, bezier_form_of_closed_curves) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
        { "name": "ring", "degree": 2, "knots": [0,1,2,3], "points": [[0,0],[2,0],[1,2]], "periodic": true } ] })");
    for (int step = 0; step < 3; ++step) ASSERT_TRUE(type("insert-for-bezier")) << message();
    EXPECT_FALSE(type("insert-for-bezier"));
    EXPECT_EQ(points(editor_).size(), 6u);
}

TEST_F(SubdivisionCommands, bezier_form_of_unclamped_curves) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
        { "name": "free", "degree": 2, "knots": [0,1,2,3,4,5], "points": [[0,0],[2,0],[1,2]] } ] })");
    for (int step = 0; step < 2; ++step) ASSERT_TRUE(type("insert-for-bezier")) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 1, 2, 2, 3, 3, 4, 5}));
    EXPECT_FALSE(type("insert-for-bezier"));
}

}  // namespace
}  // namespace batten::editor
