#include "app/editor/commands/refinement_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/curve_ends.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class RefinementCommands : public ::testing::Test {
  protected:
    void SetUp() override { open_text(editor_, bezier_text); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    const std::string& message() const { return editor_.state().message.text; }

    Editor editor_;
};

TEST_F(RefinementCommands, insert_many_knots_at_once) {
    ASSERT_TRUE(run(InsertKnots{.knots = {0.5, 0.25, 0.5}})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1, 1}));
    EXPECT_FALSE(run(InsertKnots{.knots = {0.5, 2.0}}));
    EXPECT_EQ(knots(editor_).size(), 11U);
}

TEST_F(RefinementCommands, remove_what_was_inserted) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run(InsertKnots{.knots = {0.5, 0.5, 0.25}}));
    ASSERT_TRUE(type("remove-knot 0.5 2")) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.25, 1, 1, 1, 1}));
    ASSERT_TRUE(type("remove-knots")) << message();
    EXPECT_EQ(points(editor_), before);
}

TEST_F(RefinementCommands, remove_nothing_over_the_tolerance) {
    ASSERT_TRUE(run(InsertKnot{.u = 0.5}));
    ASSERT_TRUE(run(SetPoint{.index = 2, .position = {2.0, 3.0}}));
    const std::vector<core::Point> before = points(editor_);
    EXPECT_FALSE(run(RemoveKnot{.u = 0.5, .times = 1, .tolerance = 0.01}));
    EXPECT_EQ(message().find("the knot cannot be removed; that would change the curve by "), 0U) << message();
    EXPECT_EQ(points(editor_), before);
    EXPECT_TRUE(run(RemoveKnot{.u = 0.5, .times = 1, .tolerance = 10.0})) << message();
    EXPECT_NE(message().find("Removed knot 0.5; the curve moved by at most"), std::string::npos) << message();
}

TEST_F(RefinementCommands, merge_near_knots) {
    ASSERT_TRUE(run(InsertKnots{.knots = {0.5, 0.500001}}));
    EXPECT_FALSE(type("merge-knots"));
    ASSERT_TRUE(run(MergeKnots{.tolerance = 1e-5})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}));
}

TEST_F(RefinementCommands, domains_are_set_and_normalized) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run(Reparametrize{.begin = 2.0, .end = 6.0})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{2, 2, 2, 2, 6, 6, 6, 6}));
    ASSERT_TRUE(run(Normalize{}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_), before);
    EXPECT_FALSE(run(Reparametrize{.begin = 1.0, .end = 1.0}));
}

TEST_F(RefinementCommands, unclamp_and_clamp) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run(Unclamp{.end = CurveEnds::start})) << message();
    EXPECT_LT(knots(editor_).front(), 0.0);
    EXPECT_EQ(knots(editor_).back(), 1.0);
    ASSERT_TRUE(run(Clamp{.end = CurveEnds::both})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(points(editor_)[i].x, before[i].x, 1e-14);
        EXPECT_NEAR(points(editor_)[i].y, before[i].y, 1e-14);
    }
    EXPECT_FALSE(type("clamp middle"));
    EXPECT_EQ(message(), "end is 'middle'; it must be start, end or both");
}

// A Bézier curve whose points lie anyhow, so that extrapolating it leads far away, to numbers with few digits for
// the curve itself.
Editor tangled_editor(int degree, double far) {
    core::CurveDefinition tangled{.degree = degree};
    for (int i = 0; i <= degree; ++i) tangled.points.emplace_back(far + i * 53 % 97 / 97.0, i * i * 37 % 101 / 101.0);
    tangled.knots.assign(tangled.points.size(), 0.0);
    tangled.knots.insert(tangled.knots.end(), tangled.points.size(), 1.0);
    core::DocumentCurve entry;
    entry.curve = std::make_shared<const core::Curve>(core::Curve::make(tangled).value());
    core::Document document;
    document.curves.push_back(entry);
    return Editor(document);
}

TEST(Unclamping, says_what_rounding_of_far_control_points_does) {
    Editor editor = tangled_editor(14, 0.0);
    ASSERT_TRUE(editor.run(Unclamp{.end = CurveEnds::both}));
    EXPECT_EQ(editor.state().message.text.rfind(
                  "Unclamped both ends; the shape is kept up to rounding of far control points, error at most ", 0),
              0U)
        << editor.state().message.text;
}

TEST(Unclamping, is_refused_where_rounding_would_change_the_curve) {
    Editor editor = tangled_editor(25, 1e6);
    EXPECT_FALSE(editor.run(Unclamp{.end = CurveEnds::both}));
    EXPECT_EQ(editor.state().message.text.rfind("unclamped, the control points would be so far away", 0), 0U)
        << editor.state().message.text;
}

TEST_F(RefinementCommands, make_uniform_spaces_the_knots) {
    ASSERT_TRUE(run(InsertKnots{.knots = {0.25, 0.375}}));
    ASSERT_TRUE(run(MakeUniform{})) << message();
    const std::vector<double> expected{0, 0, 0, 0, 1.0 / 3.0, 2.0 / 3.0, 1, 1, 1, 1};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(knots(editor_)[i], expected[i], 1e-15);
    EXPECT_NE(message().find("the curve moved by at most"), std::string::npos) << message();
}

TEST_F(RefinementCommands, elevate_and_reduce_by_several) {
    const std::vector<core::Point> before = points(editor_);
    ASSERT_TRUE(run(Elevate{.by = 2})) << message();
    EXPECT_EQ(message(), "Raised degree from 3 to 5; the curve is unchanged");
    EXPECT_EQ(curve(editor_).degree(), 5);
    ASSERT_TRUE(run(Reduce{.by = 2, .tolerance = 1e-9})) << message();
    EXPECT_EQ(curve(editor_).degree(), 3);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(points(editor_)[i].y, before[i].y, 1e-13);
    EXPECT_FALSE(run(Reduce{.by = 1, .tolerance = 1e-9}));
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_FALSE(run(Elevate{.by = 0}));
    EXPECT_EQ(message(), "t is 0; it must be 1 or more");
}

TEST_F(RefinementCommands, to_bezier_raises_every_knot) {
    ASSERT_TRUE(run(InsertKnot{.u = 0.5}));
    ASSERT_TRUE(run(ToBezier{})) << message();
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1}));
    // De Casteljau at 1/2: the middle point is (P0 + 3 P1 + 3 P2 + P3) / 8.
    EXPECT_EQ(points(editor_)[3], core::Point(2.0, 1.5));
}

}  // namespace
}  // namespace batten::editor
