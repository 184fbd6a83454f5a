#include "app/editor/scene/ratio_bar.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using test::dock_size;

EditorState state_of(const core::CurveDefinition& definition, double u, const Hover& hover) {
    EditorState state = test::scene_state(definition);
    state.view.parameter = u;
    state.hover = hover;
    return state;
}

/// From where to where, in parameters, the boxes of the bar reach that are filled so strongly in the level's color.
std::vector<core::Interval> parts_of(const EditorState& state, std::size_t level, double opacity) {
    const Theme theme = theme_of(state.view.theme);
    const PlotLayout layout = plot_layout(state, dock_size);
    std::vector<core::Interval> parts;
    for (const auto& fill : test::all_of<render::Fill>(test::plot_picture(state))) {
        if (fill.color != render::blended(theme.level(level), opacity, theme.panel)) continue;
        const auto [left, right] = std::minmax_element(fill.points.begin(), fill.points.end(),
                                                       [](const auto& a, const auto& b) { return a.x < b.x; });
        parts.push_back({parameter_from_x(layout, left->x), parameter_from_x(layout, right->x)});
    }
    std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.lower < b.lower; });
    return parts;
}

void expect_parts(const std::vector<core::Interval>& parts, const std::vector<core::Interval>& expected) {
    ASSERT_EQ(parts.size(), expected.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
        EXPECT_NEAR(parts[k].lower, expected[k].lower, 1e-3);
        EXPECT_NEAR(parts[k].upper, expected[k].upper, 1e-3);
    }
}

TEST(RatioBar, is_the_interval_of_the_lecture_cut_at_u) {
    const EditorState state = state_of(test::cubic(), 0.4, HoveredCell{1, 1});
    expect_parts(parts_of(state, 1, 0.7), {{0.0, 0.4}});
    expect_parts(parts_of(state, 1, 0.35), {{0.4, 0.75}});
    const render::DrawList list = test::plot_picture(state);
    EXPECT_TRUE(test::has_text(list, "8/15 P_{3}"));
    EXPECT_TRUE(test::has_text(list, "7/15 P_{2}"));
    const auto cut = test::lines_of(list, theme_of(state.view.theme).parameter, 3.0F);
    ASSERT_EQ(cut.size(), 1U);
    EXPECT_NEAR(cut[0].points[0].x, x_from_parameter(plot_layout(state, dock_size), 0.4), 0.01);
}

TEST(RatioBar, of_a_rational_curve_has_shares_of_weighted_points) {
    core::CurveDefinition definition = test::cubic();
    definition.weights = {1, 1, 1, 2, 1, 1, 1};
    const render::DrawList list = test::plot_picture(state_of(definition, 0.4, HoveredCell{1, 1}));
    EXPECT_TRUE(test::has_text(list, "8/15 w_{3} P_{3}"));
    EXPECT_TRUE(test::has_text(list, "7/15 w_{2} P_{2}"));
}

TEST(RatioBar, of_a_later_level_is_shorter) {
    const EditorState state = state_of(test::cubic(), 0.4, HoveredCell{3, 0});
    expect_parts(parts_of(state, 3, 0.7), {{0.25, 0.4}});
    expect_parts(parts_of(state, 3, 0.35), {{0.4, 0.5}});
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "3/5 P_{4}^{2}"));
}

TEST(RatioBar, stands_below_the_values_in_the_picture_and_covers_no_text) {
    for (const double height : {160.0, 260.0, 500.0}) {
        const EditorState state = state_of(test::cubic(), 0.4, HoveredCell{1, 1});
        const glm::dvec2 dock{1048.0, height};
        const render::DrawList list = test::plot_picture(state, PlotIdle{}, dock);
        for (const std::string& pair : test::overlapping_labels(list))
            EXPECT_EQ(pair.find("15 P_"), std::string::npos) << pair << " at " << height;
        EXPECT_EQ(test::faults_of(list, dock, 1.0), std::vector<std::string>{}) << height;
        EXPECT_TRUE(test::has_text(list, "0.75"));
        EXPECT_FALSE(test::has_text(list, "C^{2}"));
    }
    const EditorState resting = state_of(test::cubic(), 0.4, HoveredCell{0, 1});
    EXPECT_TRUE(test::has_text(test::plot_picture(resting), "C^{2}"));
}

TEST(RatioBar, comes_in_again_on_a_closed_curve) {
    const EditorState state = state_of(test::closed_cubic(), 0.5, HoveredCell{1, 0});  // [-2, 1]
    expect_parts(parts_of(state, 1, 0.7), {{0.0, 0.5}, {4.0, 6.0}});
    expect_parts(parts_of(state, 1, 0.35), {{0.5, 1.0}});
    const EditorState at_end = state_of(test::closed_cubic(), 5.5, HoveredCell{1, 2});  // [5, 8]
    expect_parts(parts_of(at_end, 1, 0.35), {{0.0, 2.0}, {5.5, 6.0}});
}

TEST(RatioBar, says_no_more_than_there_is_room_for) {
    const EditorState state = state_of(test::cubic(), 0.25123, HoveredCell{3, 0});
    const render::DrawList list = test::plot_picture(state);
    EXPECT_FALSE(test::has_text(list, "0.005 P_{4}^{2}"));
    EXPECT_TRUE(test::has_text(list, "0.995 P_{3}^{2}"));
    EXPECT_TRUE(parts_of(state_of(test::cubic(), 0.4, HoveredCell{0, 0}), 1, 0.7).empty());
    EXPECT_TRUE(parts_of(state_of(test::cubic(), 0.4, HoveredNothing{}), 1, 0.7).empty());
}

TEST(RatioBar, is_cut_to_what_the_plot_shows) {
    EditorState state = state_of(test::cubic(), 0.4, HoveredCell{1, 1});
    state.view.plot_range = core::Interval{0.3, 0.5};
    expect_parts(parts_of(state, 1, 0.7), {{0.3, 0.4}});
    expect_parts(parts_of(state, 1, 0.35), {{0.4, 0.5}});
}

}  // namespace
}  // namespace batten::editor
