#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/cards/polygon_distance_card.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/scene/polygon_distance_scene.h"
#include "tests/editor/lecture_insertion.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Fill;
using render::Marker;
using render::MarkerShape;
using test::all_of;

constexpr glm::dvec2 plot_size{1048.0, 260.0};

class InsertionScene : public ::testing::Test {
  protected:
    void SetUp() override { test::open_lecture_insertion(editor_); }

    /// The state of the editor with this overlay over the usual ones, seen as a whole.
    EditorState state_with(Overlay overlay) const {
        EditorState state = editor_.state();
        state.view.camera.size_px = {1280.0, 720.0};
        state.view.camera.center = {9.0, 3.0};
        state.view.camera.scale = 50.0;
        state.view.overlays.show(overlay, true);
        return state;
    }

    Editor editor_;
};

glm::dvec2 place_of(const EditorState& state, core::Point point) {
    return render::screen_from_world(state.view.camera, point);
}

std::vector<Marker> diamonds_near(const render::DrawList& list, glm::dvec2 place) {
    std::vector<Marker> found;
    for (const Marker& marker : test::markers_of(list, MarkerShape::diamond, 6.0F))
        if (std::hypot(marker.center.x - place.x, marker.center.y - place.y) < 0.1) found.push_back(marker);
    return found;
}

TEST_F(InsertionScene, marks_the_new_points_on_their_legs) {
    const EditorState state = state_with(Overlay::corner_cutting);
    const render::DrawList list = test::canvas_picture(state);
    for (const core::Point q : {core::Point(6, 1), core::Point(9, 0), core::Point(12, 1)})
        EXPECT_EQ(diamonds_near(list, place_of(state, q)).size(), 1u) << q.x;
    for (const char* text : {"α = 5/6", "α = 1/2", "α = 1/6", "Q_{3}", "Q_{4}", "Q_{5}"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
    // The two corners that go.
    EXPECT_EQ(all_of<Fill>(list).size(), all_of<Fill>(test::canvas_picture(editor_.state())).size() + 2);
    EXPECT_TRUE(test::overlapping_labels(list).empty());
    EXPECT_TRUE(test::faults_of(list, state.view.camera.size_px, 200.0).empty());
}

TEST_F(InsertionScene, keeps_colors_and_places_through_the_insertion) {
    const EditorState before = state_with(Overlay::corner_cutting);
    const auto list_before = test::canvas_picture(before);
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    const EditorState after = state_with(Overlay::corner_cutting);
    const auto list_after = test::canvas_picture(after);
    for (const core::Point q : {core::Point(6, 1), core::Point(9, 0), core::Point(12, 1)}) {
        const auto old_marks = diamonds_near(list_before, place_of(before, q));
        const auto marks = diamonds_near(list_after, place_of(after, q));
        ASSERT_EQ(old_marks.size(), 1u);
        ASSERT_EQ(marks.size(), 1u);
        EXPECT_EQ(marks[0].fill, old_marks[0].fill);
    }
    EXPECT_TRUE(test::has_text(list_after, "α = 5/6"));
    // The corners that went have their old names; the first corner has the same one, the last one another.
    for (const char* name : {"(P_{3})", "(P_{4})", "(P_{5})"}) EXPECT_TRUE(test::has_text(list_after, name)) << name;
    EXPECT_FALSE(test::has_text(list_after, "(P_{2})"));
    EXPECT_TRUE(test::overlapping_labels(list_after).empty());
}

TEST_F(InsertionScene, tells_the_place_on_the_leg_that_weights_make) {
    ASSERT_TRUE(editor_.run(SetWeight{.index = 3, .weight = 2.0}));
    // 5/6 2 / (1/6 + 5/6 2) = 10/11
    EXPECT_TRUE(
        test::has_text(test::canvas_picture(state_with(Overlay::corner_cutting)), "α = 5/6, at 10/11 of the leg"));
}

TEST_F(InsertionScene, slides_with_the_parameter) {
    ASSERT_TRUE(editor_.run(SetParameter{.u = 0.45}));
    const EditorState state = state_with(Overlay::corner_cutting);
    const auto list = test::canvas_picture(state);
    // α_3 = 0.45/0.6, on the leg from (6, 6) to (6, 0).
    EXPECT_EQ(diamonds_near(list, place_of(state, {6, 1.5})).size(), 1u);
    EXPECT_TRUE(test::has_text(list, "α = 3/4"));
}

TEST_F(InsertionScene, draws_the_functions_on_the_other_side) {
    // After the insertion N'_3, over 0, 0.2, 0.4, 0.5, 0.6, is at its highest between 0.2 and 0.4.
    const EditorState state = state_with(Overlay::corner_cutting);
    const auto plain = test::plot_picture(editor_.state(), PlotIdle{}, plot_size);
    const auto list = test::plot_picture(state, PlotIdle{}, plot_size);
    const std::size_t more = all_of<render::Polyline>(list).size() - all_of<render::Polyline>(plain).size();
    // Five functions of four spans each, of which those at the ends are clipped by the domain's ends: N'_2..N'_6.
    EXPECT_GE(more, 15u);
    EXPECT_LE(more, 20u);
    EXPECT_TRUE(test::faults_of(list, plot_size, 200.0).empty());
}

TEST_F(InsertionScene, shows_the_rounds_and_the_distance) {
    const EditorState state = state_with(Overlay::polygon_distance);
    const auto list = test::canvas_picture(state);
    const Theme theme = theme_of(state.view.theme);
    for (const std::size_t r : {1u, 2u, 3u})
        EXPECT_FALSE(test::lines_of(list, round_color(theme, r), 1.5F).empty()) << r;
    EXPECT_TRUE(test::faults_of(list, state.view.camera.size_px, 200.0).empty());
}

// The Bezier curve (0, 0) (3, 6) (6, 0) is at (3, 3) halfway, 3 below its corner.
TEST_F(InsertionScene, has_the_distance_in_the_unit) {
    ASSERT_TRUE(editor_.run(NewCurve{.points = {{0, 0}, {3, 6}, {6, 0}}, .degree = 2}));
    EXPECT_TRUE(test::has_text(test::canvas_picture(state_with(Overlay::polygon_distance)), "3"));
    ASSERT_TRUE(run_typed(editor_, "set-units mm 10"));
    const EditorState state = state_with(Overlay::polygon_distance);
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "0.3 mm"));
    const Card card = polygon_distance_card(state);
    EXPECT_EQ(std::get<CardLine>(card.blocks.at(0)).text.text, "The control polygon is at most 0.3 mm from the curve.");
}

TEST_F(InsertionScene, names_the_bezier_points) {
    const EditorState state = state_with(Overlay::bezier_points);
    const auto list = test::canvas_picture(state);
    for (const char* text : {"b_{6}", "b_{7}", "b_{8}", "b_{9}"}) EXPECT_TRUE(test::has_text(list, text)) << text;
    EXPECT_TRUE(test::overlapping_labels(list).empty());
}

TEST_F(InsertionScene, bears_the_worst_curves) {
    std::vector<core::CurveDefinition> worst;
    core::CurveDefinition many{.degree = 3};
    for (int i = 0; i < 10000; ++i) many.points.push_back({0.01 * i, std::sin(0.1 * i)});
    for (int i = 0; i < 10004; ++i) many.knots.push_back(i);
    worst.push_back(many);
    core::CurveDefinition high{.degree = 25};
    for (int i = 0; i < 40; ++i) high.points.push_back({1e6 + i, 1e6 + i % 3});
    for (int i = 0; i < 66; ++i) high.knots.push_back(i);
    worst.push_back(high);
    worst.push_back({.degree = 3,
                     .knots = {0, 1, 2, 3},
                     .points = {{0, 0}, {2, 0}, {1, 2}},
                     .weights = {1, 1000, 1},
                     .periodic = true});
    worst.push_back({.degree = 5, .knots = {0, 1, 2}, .points = {{0, 0}, {2, 0}}, .periodic = true});
    worst.push_back(
        {.degree = 3, .knots = {0, 0, 0, 0, 1, 2, 2, 2, 2}, .points = {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}});
    worst.push_back({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-1e300, 0}, {0, 1e300}, {1e300, 0}}});
    for (const core::CurveDefinition& definition : worst)
        for (const Overlay overlay : {Overlay::corner_cutting, Overlay::polygon_distance, Overlay::bezier_points}) {
            EditorState state = test::scene_state(definition);
            state.view.overlays.show(overlay, true);
            for (const double share : {0.0, 0.3, 0.5, 1.0}) {
                const core::Interval domain = state.active_curve()->domain();
                state.view.parameter = domain.lower + share * domain.length();
                const auto list = test::canvas_picture(state);
                EXPECT_TRUE(test::faults_of(list, state.view.camera.size_px, 1e4).empty());
                const auto plot = test::plot_picture(state, PlotIdle{}, plot_size);
                EXPECT_TRUE(test::faults_of(plot, plot_size, 1e4).empty());
            }
        }
}

}  // namespace
}  // namespace batten::editor
