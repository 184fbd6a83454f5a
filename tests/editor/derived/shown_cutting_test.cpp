#include "app/editor/derived/shown_cutting.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/state/point_hues.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"
#include "tests/editor/lecture_insertion.h"

namespace batten::editor {
namespace {

using Hues = std::vector<std::size_t>;

class ShownCuttings : public ::testing::Test {
  protected:
    void SetUp() override { test::open_lecture_insertion(editor_); }
    ShownCutting shown() const { return shown_cutting(editor_.state()).value(); }

    Editor editor_;
};

TEST_F(ShownCuttings, is_what_inserting_u_would_do) {
    const ShownCutting before = shown();
    EXPECT_FALSE(before.has_happened);
    EXPECT_EQ(before.cutting.cuts[1].point, core::Point(9, 0));
    EXPECT_EQ(before.corner_hues, (Hues{2, 3, 4, 5}));
    EXPECT_EQ(before.cut_hues, (Hues{3, 0, 4}));
    EXPECT_EQ(document(editor_).active_curve()->curve->control_points().size(), 8u);
}

TEST_F(ShownCuttings, slides_with_the_parameter) {
    ASSERT_TRUE(editor_.run(SetParameter{.u = 0.45}));
    EXPECT_NEAR(shown().cutting.cuts[0].alpha, 0.75, 1e-15);
    EXPECT_EQ(shown().cutting.u, 0.45);
}

TEST_F(ShownCuttings, stays_after_the_insertion_with_the_same_colors) {
    const ShownCutting before = shown();
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    const ShownCutting after = shown();
    EXPECT_TRUE(after.has_happened);
    EXPECT_LT(after.deviation, 1e-13);
    EXPECT_EQ(after.cut_hues, before.cut_hues);
    EXPECT_EQ(after.corner_hues, before.corner_hues);
    for (std::size_t j = 0; j < 4; ++j)
        EXPECT_LT(core::distance(after.cutting.corners[j].point, before.cutting.corners[j].point), 1e-13);
}

TEST_F(ShownCuttings, stays_where_a_knot_came_in_elsewhere_until_the_parameter_moves) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.3}));
    EXPECT_TRUE(shown().has_happened);
    EXPECT_EQ(shown().cutting.u, 0.3);
    ASSERT_TRUE(editor_.run(SetParameter{.u = 0.55}));
    EXPECT_FALSE(shown().has_happened);
    EXPECT_EQ(shown().cutting.u, 0.55);
}

TEST_F(ShownCuttings, follows_a_drag_and_says_how_far_it_is_off) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    const Command drag = SetPoint{.index = 4, .position = {9, 2}};
    ASSERT_TRUE(editor_.run(drag, Phase::preview));
    EXPECT_TRUE(shown().has_happened);
    EXPECT_GT(shown().deviation, 0.1);
    const core::Point followed = shown().cutting.corners[1].point;
    EXPECT_GT(followed.y, 0.1);
    ASSERT_TRUE(editor_.run(drag));
    EXPECT_EQ(shown().cutting.corners[1].point, followed);
    // A far point does nothing to it.
    ASSERT_TRUE(editor_.run(SetPoint{.index = 0, .position = {-5, -5}}));
    EXPECT_EQ(shown().cutting.corners[1].point, followed);
}

TEST_F(ShownCuttings, goes_with_undo_and_comes_with_redo) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    ASSERT_TRUE(editor_.run(Undo{}));
    EXPECT_FALSE(shown().has_happened);
    ASSERT_TRUE(editor_.run(Redo{}));
    EXPECT_TRUE(shown().has_happened);
}

TEST_F(ShownCuttings, is_none_of_several_knots) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    ASSERT_TRUE(editor_.run(InsertMidpoints{}));
    EXPECT_FALSE(editor_.state().inserted);
}

TEST_F(ShownCuttings, does_not_take_added_points_for_insertions) {
    ASSERT_TRUE(run_typed(editor_, "add-point 4 9 3")) << editor_.state().message.text;
    EXPECT_FALSE(editor_.state().inserted);
}

TEST_F(ShownCuttings, says_why_there_is_none) {
    ASSERT_TRUE(editor_.run(SetParameter{.u = 1.0}));
    EXPECT_EQ(shown_cutting(editor_.state()).error(), "1 has multiplicity 4 already");
    EXPECT_EQ(shown_cutting(Editor().state()).error(), "there is no curve");
}

TEST(ShownCuttingsOfAll, have_the_colors_that_points_then_have) {
    core::RandomCurves random(7);
    std::size_t compared = 0;
    for (int k = 0; k < 400; ++k) {
        const core::Curve curve = random.open_curve();
        core::Document document;
        document.curves.emplace_back();
        document.curves[0].curve = std::make_shared<const core::Curve>(curve);
        Editor editor(std::move(document));
        editor.run(SetParameter{.u = random.parameter(curve)});
        const auto before = shown_cutting(editor.state());
        if (!before || before->cutting.u == curve.domain().lower || before->cutting.u == curve.domain().upper) continue;
        ASSERT_TRUE(editor.run(InsertKnot{.u = before->cutting.u}));
        const auto after = shown_cutting(editor.state());
        ASSERT_TRUE(after);
        EXPECT_TRUE(after->has_happened);
        EXPECT_EQ(after->cut_hues, before->cut_hues) << k;
        EXPECT_EQ(after->corner_hues, before->corner_hues) << k;
        ++compared;
    }
    EXPECT_GT(compared, 150u);
}

}  // namespace
}  // namespace batten::editor
