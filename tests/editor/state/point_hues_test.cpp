#include "app/editor/state/point_hues.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "core/refine/bezier_form.h"
#include "core/refine/knot_insertion.h"
#include "tests/editor/lecture_insertion.h"

namespace batten::editor {
namespace {

using Hues = std::vector<std::size_t>;

Hues hues_of(const core::DocumentCurve& entry) {
    Hues hues;
    for (std::size_t i = 0; i < entry.curve->control_points().size(); ++i) hues.push_back(point_hue(entry, i));
    return hues;
}

core::DocumentCurve entry_of(std::shared_ptr<const core::Curve> curve) {
    core::DocumentCurve entry;
    entry.curve = std::move(curve);
    return entry;
}

class PointHues : public ::testing::Test {
  protected:
    void SetUp() override { test::open_lecture_insertion(editor_); }
    Hues hues() const { return hues_of(*editor_.state().shown().active_curve()); }

    Editor editor_;
};

TEST_F(PointHues, are_those_of_the_indices_at_first) {
    EXPECT_EQ(hues(), (Hues{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST_F(PointHues, stay_with_the_points_when_a_knot_comes_in) {
    // P_3 and P_4 go; Q_3 is near P_3, Q_5 near P_4, and Q_4, midway between both, is the new one. Of the colors 0 is
    // the first that none of 1 to 6 has, which are around.
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    EXPECT_EQ(hues(), (Hues{0, 1, 2, 3, 0, 4, 5, 6, 7}));
}

TEST_F(PointHues, follow_undo_and_stay_while_points_are_dragged) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    const Hues inserted = hues();
    ASSERT_TRUE(editor_.run(SetPoint{.index = 4, .position = {9, 3}}, Phase::preview));
    EXPECT_EQ(hues(), inserted);
    ASSERT_TRUE(editor_.run(SetPoint{.index = 4, .position = {9, 3}}));
    EXPECT_EQ(hues(), inserted);
    ASSERT_TRUE(editor_.run(Undo{}));
    ASSERT_TRUE(editor_.run(Undo{}));
    EXPECT_EQ(hues(), (Hues{0, 1, 2, 3, 4, 5, 6, 7}));
    ASSERT_TRUE(editor_.run(Redo{}));
    EXPECT_EQ(hues(), inserted);
}

TEST_F(PointHues, come_back_when_the_knot_is_taken_out) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    ASSERT_TRUE(run_typed(editor_, "remove-knot 0.5 1")) << editor_.state().message.text;
    EXPECT_EQ(hues(), (Hues{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST_F(PointHues, of_the_others_stay_when_one_is_deleted) {
    ASSERT_TRUE(editor_.run(DeletePoints{.points = {2}}));
    EXPECT_EQ(hues(), (Hues{0, 1, 3, 4, 5, 6, 7}));
}

TEST_F(PointHues, stay_through_bezier_form) {
    // The pieces' ends are new points; those that lay on the old ones keep their colors.
    ASSERT_TRUE(editor_.run(ToBezier{}));
    const Hues all = hues();
    ASSERT_EQ(all.size(), 16u);
    EXPECT_EQ(all[0], 0u);
    EXPECT_EQ(all[1], 1u);
    EXPECT_EQ(all[14], 6u);
    EXPECT_EQ(all[15], 7u);
    Hues old;
    for (std::size_t hue = 0; hue < 8; ++hue)
        for (std::size_t i = hue; i < all.size(); ++i)
            if (all[i] == hue && (old.empty() || i > old.back())) {
                old.push_back(i);
                break;
            }
    EXPECT_EQ(old.size(), 8u);
    for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NE(all[i], all[i - 1]);
}

TEST(PointHuesOfPeriodic, stay_with_the_points) {
    const auto square =
        std::make_shared<const core::Curve>(core::Curve::make({.degree = 3,
                                                               .knots = {0, 1, 2, 3, 4, 5},
                                                               .points = {{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}},
                                                               .periodic = true})
                                                .value());
    for (double u = 0.5; u < 5.0; u += 1.0) {
        core::DocumentCurve entry = entry_of(square);
        const core::Curve refined = core::insert_knot(*square, u).value();
        replace_curve(entry, std::make_shared<const core::Curve>(refined));
        // Every old point that is still there has its color.
        std::size_t kept = 0;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t k = 0; k < 5; ++k)
                if (refined.control_points()[i] == square->control_points()[k]) {
                    EXPECT_EQ(point_hue(entry, i), k) << u;
                    ++kept;
                }
        EXPECT_EQ(kept, 3u);
    }
}

TEST(PointHuesOfMany, are_found_quickly) {
    core::CurveDefinition definition{.degree = 3};
    constexpr int count = 10000;
    for (int i = 0; i < count; ++i) definition.points.push_back({1.0 * i, 1.0 * (i % 7)});
    for (int i = 0; i < count + 4; ++i) definition.knots.push_back(i);
    const core::Curve curve = core::Curve::make(definition).value();
    core::DocumentCurve entry = entry_of(std::make_shared<const core::Curve>(curve));
    replace_curve(entry, std::make_shared<const core::Curve>(core::insert_midpoint_knots(curve).value()));
    ASSERT_EQ(entry.point_hues->size(), entry.curve->control_points().size());
    for (std::size_t i = 1; i < entry.point_hues->size(); ++i)
        ASSERT_NE((*entry.point_hues)[i], (*entry.point_hues)[i - 1]) << i;
}

}  // namespace
}  // namespace batten::editor
