#include "app/editor/scene/construction_views.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/editor/scene/halves.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/split.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

EditorState state_at(const core::CurveDefinition& definition, double u, std::initializer_list<Overlay> overlays) {
    EditorState state = test::scene_state(definition);
    state.view.parameter = u;
    for (const Overlay overlay : overlays) state.view.overlays.show(overlay, true);
    return state;
}

using test::screen;

/// The corners of the one line of this color and width.
std::vector<glm::dvec2> corners(const render::DrawList& list, render::Color color, float width) {
    const auto lines = test::lines_of(list, color, width);
    if (lines.size() != 1) return {};
    return {lines[0].points.begin(), lines[0].points.end()};
}

void expect_corners(const std::vector<glm::dvec2>& found, const EditorState& state, const core::Curve& part) {
    const auto points = part.control_points();
    ASSERT_EQ(found.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LT(glm::distance(found[i], screen(state, points[i])), 0.01) << i;
}

TEST(Halves, have_the_polygons_of_the_parts) {
    const EditorState state = state_at(test::cubic(), 0.4, {Overlay::halves});
    const auto parts = core::split(*state.active_curve(), 0.4).value();
    const render::DrawList list = test::canvas_picture(state);
    const HalfColors colors = half_colors(theme_of(state.view.theme));
    expect_corners(corners(list, colors.before, 4.5F), state, parts[0]);
    expect_corners(corners(list, colors.after, 4.5F), state, parts[1]);
}

TEST(Halves, lie_along_the_curve_to_its_point_at_u) {
    const EditorState state = state_at(test::cubic(), 0.4, {Overlay::halves});
    const Theme theme = theme_of(state.view.theme);
    const render::DrawList list = test::canvas_picture(state);
    const auto before = test::lines_of(list, render::blended(half_colors(theme).before, 0.45, theme.canvas), 10.0F);
    const auto after = test::lines_of(list, render::blended(half_colors(theme).after, 0.45, theme.canvas), 10.0F);
    for (double u = 0.0; u <= 1.0; u += 0.01) {
        const glm::dvec2 place = screen(state, core::point_at(*state.active_curve(), u));
        EXPECT_LT(test::distance_to(u < 0.4 ? before : after, place), 0.5) << u;
        if (std::abs(u - 0.4) > 0.05) {
            EXPECT_GT(test::distance_to(u < 0.4 ? after : before, place), 3.0) << u;
        }
    }
}

TEST(Halves, of_any_curve_break_nothing) {
    core::CurveDefinition many{.degree = 3, .knots = {}, .points = test::scattered_points(10000, {10.0, 6.0})};
    for (int i = 0; i < 10004; ++i) many.knots.push_back(i);
    core::CurveDefinition far = test::cubic();
    for (core::Point& point : far.points) point = {point.x + 1e6, point.y - 1e6};
    core::CurveDefinition heavy = test::cubic();
    heavy.weights = {1, 1e3, 1, 1e-3, 1, 1e3, 1};
    core::CurveDefinition same = test::cubic();
    for (core::Point& point : same.points) point = {1, 1};
    const auto all = {Overlay::halves, Overlay::by_insertion, Overlay::blossoms, Overlay::triangle};
    for (const core::CurveDefinition& definition : {many, far, heavy, same, test::closed_cubic()}) {
        EditorState state = state_at(definition, 0.0, all);
        const core::Interval domain = state.active_curve()->domain();
        for (const double share : {0.0, 0.3, 0.5, 1.0}) {
            state.view.parameter = domain.lower + share * domain.length();
            EXPECT_EQ(test::faults_of(test::canvas_picture(state), state.view.camera.size_px, 200.0),
                      std::vector<std::string>{});
        }
    }
}

TEST(InsertedPolygon, is_that_of_inserting_u_as_often_as_levels_are_shown) {
    EditorState state = state_at(test::cubic(), 0.4, {Overlay::by_insertion});
    const Theme theme = theme_of(state.view.theme);
    state.view.level = 1;
    // P_1, the three points of level 1, P_4.
    const auto found = corners(test::canvas_picture(state), render::blended(theme.level(1), 0.5, theme.canvas), 5.0F);
    ASSERT_EQ(found.size(), 5U);
    EXPECT_LT(glm::distance(found[1], screen(state, {-2.2, 3.4})), 0.01);  // 1/5 P_1 + 4/5 P_2
    state.view.level = 0;
    EXPECT_TRUE(
        test::lines_of(test::canvas_picture(state), render::blended(theme.level(1), 0.5, theme.canvas), 5.0F).empty());
    state.view.level.reset();
    EXPECT_EQ(corners(test::canvas_picture(state), render::blended(theme.level(3), 0.5, theme.canvas), 5.0F).size(),
              7U);
}

TEST(BlossomLabels, stand_at_control_points_and_at_points_of_the_construction) {
    EditorState state = state_at(test::cubic(), 0.4, {Overlay::blossoms});
    render::DrawList list = test::canvas_picture(state);
    for (const char* text : {"f(u_{1}, u_{2}, u_{3})", "f(u_{3}, u_{4}, u_{5})", "f(u_{7}, u_{8}, u_{9})",
                             "f(u_{4}, u_{5}, u)", "f(u, u, u)"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
    EXPECT_EQ(test::overlapping_labels(list), std::vector<std::string>{});
    state.view.blossom_values = true;
    state.view.notation.parameter = ParameterLetter::t;
    list = test::canvas_picture(state);
    for (const char* text : {"f(0, 0, 0)", "f(0, 1/4, 1/2)", "f(1/4, 1/2, t)", "f(t, t, t)"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
}

TEST(ConstructionNames, stand_at_the_points_of_the_construction) {
    EditorState state = state_at(test::cubic(), 0.4, {Overlay::triangle});
    const render::DrawList list = test::canvas_picture(state);
    for (const char* text : {"P_{2}^{1}", "P_{3}^{1}", "P_{4}^{1}", "P_{3}^{2}", "P_{4}^{2}"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
    state.view.overlays.show(Overlay::blossoms, true);
    EXPECT_FALSE(test::has_text(test::canvas_picture(state), "P_{2}^{1}"));
}

TEST(ConstructionNames, of_a_high_degree_are_that_of_the_hovered_point) {
    core::CurveDefinition definition{.degree = 9, .knots = std::vector<double>(20, 0.0), .points = {}};
    std::fill(definition.knots.begin() + 10, definition.knots.end(), 1.0);
    for (int i = 0; i < 10; ++i) definition.points.push_back({1.0 * i - 5.0, i % 2 == 0 ? -2.0 : 2.0});
    EditorState state = state_at(definition, 0.4, {Overlay::triangle});
    EXPECT_FALSE(test::has_text(test::canvas_picture(state), "P_{2}^{1}"));
    state.hover = HoveredCell{1, 1};
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "P_{2}^{1}"));
    EXPECT_FALSE(test::has_text(test::canvas_picture(state), "P_{3}^{1}"));
}

}  // namespace
}  // namespace batten::editor
