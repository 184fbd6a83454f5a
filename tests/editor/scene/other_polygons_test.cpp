// The control polygons of the curves beside the active one.

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

/// The sample with other curves beside it, of which only polygons and labels are shown.
EditorState state_with_others(const std::vector<core::CurveDefinition>& others) {
    EditorState state = test::sample_state();
    core::Document document = state.history.present();
    for (const core::CurveDefinition& other : others)
        document.curves.emplace_back().curve = std::make_shared<const core::Curve>(core::Curve::make(other).value());
    state.history = History(document);
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    for (const Overlay overlay : {Overlay::other_polygons, Overlay::labels}) state.view.overlays.show(overlay, true);
    return state;
}

core::CurveDefinition line(core::Point from, core::Point to) {
    return {.degree = 1, .knots = {0, 0, 1, 1}, .points = {from, to}};
}

std::size_t dots(const EditorState& state) {
    return test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 3.5F).size();
}

TEST(OtherPolygons, have_points_where_they_are_and_letters_of_their_own) {
    const EditorState state = state_with_others({line({-5, -4}, {5, -4}), line({-5, 4}, {5, 4})});
    const render::DrawList picture = test::canvas_picture(state);
    const auto points = test::markers_of(picture, render::MarkerShape::disc, 3.5F);
    ASSERT_EQ(points.size(), 4U);
    const glm::dvec2 first = render::screen_from_world(state.view.camera, {-5, -4});
    EXPECT_NEAR(points[0].center.x, first.x, 1e-3);
    EXPECT_NEAR(points[0].center.y, first.y, 1e-3);
    for (const char* name : {"Q_{0}", "Q_{1}", "R_{0}", "R_{1}"}) EXPECT_TRUE(test::has_text(picture, name)) << name;
    EXPECT_FALSE(test::has_text(picture, "P_{0}")) << "the active polygon is off";
}

TEST(OtherPolygons, follow_the_letter_of_the_lecture) {
    EditorState state = state_with_others({line({-5, -4}, {5, -4})});
    state.view.notation.points = PointLetter::V;
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "W_{0}"));
    state.view.notation.points = PointLetter::d;
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "e_{1}"));
    state.view.overlays.show(Overlay::labels, false);
    EXPECT_FALSE(test::has_text(test::canvas_picture(state), "e_{1}"));
    EXPECT_EQ(dots(state), 2U);
}

TEST(OtherPolygons, close_with_their_curves) {
    const EditorState state = state_with_others({test::closed_cubic()});
    const Theme theme = theme_of(state.view.theme);
    const render::Color color = render::blended(theme.polygon, 0.6, theme.canvas);
    const auto lines = test::lines_of(test::canvas_picture(state), color, 1.25F);
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(lines[0].points.size(), 7U);
    EXPECT_EQ(lines[0].points.front(), lines[0].points.back());
}

TEST(OtherPolygons, are_left_out_where_they_are_hidden_or_many) {
    EditorState state = state_with_others({line({-5, -4}, {5, -4})});
    core::Document document = state.history.present();
    document.curves[1].visible = false;
    state.history = History(document);
    EXPECT_EQ(dots(state), 0U);
    core::CurveDefinition many{.degree = 1, .knots = {0}, .points = {}};
    for (int i = 0; i < 199; ++i) {
        many.points.emplace_back(0.01 * i, -4.0);
        many.knots.push_back(i);
    }
    many.knots.push_back(198);
    EXPECT_EQ(dots(state_with_others({many})), 199U);
    EXPECT_EQ(dots(state_with_others({many, line({-5, -4}, {5, -4})})), 199U) << "these would be more than 200";
}

}  // namespace
}  // namespace batten::editor
