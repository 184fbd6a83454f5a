#include "app/editor/pointer/plot_layout.h"

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

TEST(PlotLayout, stands_as_drawn_at_the_usual_size) {
    const PlotLayout layout = plot_layout(test::state_with(test::cubic()), {1048.0, 260.0});
    EXPECT_EQ(layout.range, (core::Interval{0.0, 1.0}));
    EXPECT_DOUBLE_EQ(layout.left_px, 32.0);
    EXPECT_DOUBLE_EQ(layout.right_px, 1016.0);
    EXPECT_DOUBLE_EQ(layout.top_px, 44.0);
    EXPECT_DOUBLE_EQ(layout.bottom_px, 152.0);
    EXPECT_DOUBLE_EQ(layout.strip_px, 206.0);
}

TEST(PlotLayout, scales_with_the_interface) {
    EditorState state = test::state_with(test::cubic());
    state.view.interface_scale = 2.0;
    const PlotLayout layout = plot_layout(state, {2096.0, 520.0});
    EXPECT_DOUBLE_EQ(layout.left_px, 64.0);
    EXPECT_DOUBLE_EQ(layout.right_px, 2032.0);
    EXPECT_DOUBLE_EQ(layout.top_px, 88.0);
    EXPECT_DOUBLE_EQ(layout.bottom_px, 304.0);
    EXPECT_DOUBLE_EQ(layout.strip_px, 412.0);
    EXPECT_DOUBLE_EQ(layout.diamond_px, 16.0);
    EXPECT_DOUBLE_EQ(layout.stack_px, 20.0);
}

TEST(PlotLayout, shows_all_of_a_curve_that_a_preview_adds_and_follows_no_knot_that_it_moves) {
    EditorState state = test::state_with(test::cubic());
    core::Document moved = state.history.present();
    const core::Curve longer =
        core::Curve::make({.degree = 1, .knots = {2, 2, 5, 5}, .points = {{0, 0}, {1, 0}}}).value();
    moved.curves.front().curve = std::make_shared<const core::Curve>(longer);
    state.preview = moved;
    EXPECT_EQ(plot_layout(state, {1048.0, 260.0}).range, (core::Interval{0.0, 1.0}));
    core::Document added = state.history.present();
    added.curves.push_back(moved.curves.front());
    added.active = 1;
    state.preview = added;
    EXPECT_EQ(plot_layout(state, {1048.0, 260.0}).range, (core::Interval{2.0, 5.0}));
}

TEST(PlotLayout, stays_usable_at_every_size) {
    const EditorState state = test::state_with(test::cubic());
    for (double height = 160.0; height <= 600.0; height += 20.0) {
        const PlotLayout layout = plot_layout(state, {400.0, height});
        EXPECT_GE(layout.top_px, 34.0) << height;
        EXPECT_GE(layout.bottom_px - layout.top_px, 40.0) << height;
        EXPECT_GE(layout.strip_px - layout.bottom_px, 24.0) << height;
        EXPECT_GE(height - layout.strip_px, 40.0) << height;
        EXPECT_GE(layout.right_px - layout.left_px, 300.0) << height;
    }
}

TEST(PlotLayout, survives_a_picture_without_room) {
    const PlotLayout layout = plot_layout(test::state_with(test::cubic()), {0.0, 0.0});
    EXPECT_GT(layout.right_px, layout.left_px);
    EXPECT_GT(layout.bottom_px, layout.top_px);
}

TEST(PlotLayout, maps_parameters_and_values_and_back) {
    const PlotLayout layout = plot_layout(test::state_with(test::cubic()), {1048.0, 260.0});
    EXPECT_DOUBLE_EQ(x_from_parameter(layout, 0.25), 278.0);
    EXPECT_DOUBLE_EQ(parameter_from_x(layout, 278.0), 0.25);
    EXPECT_DOUBLE_EQ(y_from_value(layout, 1.0), 44.0);
    EXPECT_DOUBLE_EQ(y_from_value(layout, 0.5), 98.0);
}

TEST(PlotLayout, shows_what_it_is_zoomed_to) {
    EditorState state = test::state_with(test::cubic());
    state.view.plot_range = core::Interval{0.25, 0.5};
    const PlotLayout layout = plot_layout(state, {1048.0, 260.0});
    EXPECT_DOUBLE_EQ(x_from_parameter(layout, 0.25), 32.0);
    EXPECT_DOUBLE_EQ(x_from_parameter(layout, 0.5), 1016.0);
    const std::vector<KnotMark> marks = knot_marks(state, layout);
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_EQ(marks[0].index, 4U);
    EXPECT_EQ(marks[1].index, 5U);
}

TEST(PlotLayout, shows_knots_outside_the_domain_and_one_period) {
    core::CurveDefinition uniform = test::cubic();
    uniform.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EXPECT_EQ(plot_layout(test::state_with(uniform), {1048.0, 260.0}).range, (core::Interval{0.0, 10.0}));
    const EditorState closed = test::state_with(test::closed_cubic());
    const PlotLayout layout = plot_layout(closed, {1048.0, 260.0});
    EXPECT_EQ(layout.range, (core::Interval{0.0, 6.0}));
    EXPECT_EQ(knot_marks(closed, layout).size(), 7U);
}

TEST(PlotLayout, stands_still_while_a_preview_moves_the_last_knot) {
    core::CurveDefinition uniform = test::cubic();
    uniform.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EditorState state = test::state_with(uniform);
    uniform.knots.back() = 12.0;
    state.preview = test::state_with(uniform).history.present();
    EXPECT_EQ(plot_layout(state, {1048.0, 260.0}).range, (core::Interval{0.0, 10.0}));
}

TEST(PlotLayout, without_a_curve_shows_the_unit_interval) {
    EXPECT_EQ(plot_layout(EditorState(), {1048.0, 260.0}).range, (core::Interval{0.0, 1.0}));
    EXPECT_TRUE(knot_marks(EditorState(), plot_layout(EditorState(), {1048.0, 260.0})).empty());
}

TEST(KnotMarks, stand_in_stacks_where_knots_are_equal) {
    const EditorState state = test::state_with(test::cubic());
    const PlotLayout layout = plot_layout(state, {1048.0, 260.0});
    const std::vector<KnotMark> marks = knot_marks(state, layout);
    ASSERT_EQ(marks.size(), 11U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(marks[i].index, i);
        EXPECT_DOUBLE_EQ(marks[i].center_px.x, 32.0);
        EXPECT_DOUBLE_EQ(marks[i].center_px.y, 206.0 - 10.0 * static_cast<double>(i));
    }
    EXPECT_DOUBLE_EQ(marks[4].center_px.x, 278.0);
    EXPECT_DOUBLE_EQ(marks[4].center_px.y, 206.0);
}

TEST(KnotMarks, that_nearly_agree_stand_beside_each_other) {
    core::CurveDefinition definition = test::cubic();
    definition.knots[5] = 0.25 + 1e-9;
    const EditorState state = test::state_with(definition);
    const std::vector<KnotMark> marks = knot_marks(state, plot_layout(state, {1048.0, 260.0}));
    EXPECT_DOUBLE_EQ(marks[4].center_px.y, 206.0);
    EXPECT_DOUBLE_EQ(marks[5].center_px.y, 206.0);
    EXPECT_GT(marks[5].center_px.x, marks[4].center_px.x);
}

TEST(KnotMarks, of_a_high_stack_stay_below_the_plot) {
    core::CurveDefinition definition;
    definition.degree = 25;
    definition.knots.assign(26, 0.0);
    definition.knots.insert(definition.knots.end(), 26, 1.0);
    for (int i = 0; i <= 25; ++i) definition.points.emplace_back(i, i % 3);
    const EditorState state = test::state_with(definition);
    for (const double height : {160.0, 260.0, 600.0}) {
        const PlotLayout layout = plot_layout(state, {1048.0, height});
        for (const KnotMark& mark : knot_marks(state, layout))
            EXPECT_GE(mark.center_px.y - layout.diamond_px, layout.bottom_px) << height;
    }
}

}  // namespace
}  // namespace batten::editor
