// What is seen of a selection over several curves.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

/// The sample, a line along y = -4, and a locked one along y = 4.
EditorState several_curves() {
    EditorState state = test::sample_state();
    core::Document document = state.history.present();
    for (const double y : {-4.0, 4.0})
        document.curves.emplace_back().curve = std::make_shared<const core::Curve>(
            core::Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{-5, y}, {5, y}}}).value());
    document.curves[2].locked = true;
    state.history = History(document);
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    state.view.overlays.show(Overlay::polygon, true);
    return state;
}

std::vector<render::Polyline> bands(const EditorState& state) {
    const Theme theme = theme_of(state.view.theme);
    return test::lines_of(test::canvas_picture(state), render::blended(theme.accent, 0.4, theme.canvas), 11.0F);
}

TEST(SelectionMarks, whole_curves_lie_on_a_band) {
    EditorState state = several_curves();
    EXPECT_TRUE(bands(state).empty());
    state.selection.others = {{1}};
    const auto of_other = bands(state);
    ASSERT_EQ(of_other.size(), 1U);
    EXPECT_LT(test::distance_to(of_other, render::screen_from_world(state.view.camera, {0, -4})), 1e-3);
    state.selection.is_whole = true;
    const auto of_both = bands(state);
    EXPECT_GT(of_both.size(), 1U);
    EXPECT_LT(test::distance_to(of_both, render::screen_from_world(state.view.camera, {-6, -2.2})), 1e-3);
}

TEST(SelectionMarks, points_of_other_curves_are_shown_where_some_are_selected) {
    EditorState state = several_curves();
    state.selection.others = {{1, {1}}};
    const render::DrawList list = test::canvas_picture(state);
    const auto selected = test::markers_of(list, render::MarkerShape::disc, 5.5F);
    ASSERT_EQ(selected.size(), 1U);
    const glm::dvec2 place = render::screen_from_world(state.view.camera, {5, -4});
    EXPECT_NEAR(selected[0].center.x, place.x, 1e-3);
    EXPECT_NEAR(selected[0].center.y, place.y, 1e-3);
    EXPECT_EQ(test::markers_of(list, render::MarkerShape::disc, 3.5F).size(), 1U) << "the other one of the line";
    state.hover = HoveredOtherPoint{1, 1};
    EXPECT_EQ(test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 7.0F).size(), 1U);
}

TEST(SelectionMarks, very_many_points_are_some) {
    EditorState state = several_curves();
    core::Document document = state.history.present();
    const std::size_t count = 100'000;
    core::CurveDefinition many{.degree = 1, .knots = {0}};
    for (std::size_t i = 0; i < count; ++i) {
        many.points.push_back({static_cast<double>(i), static_cast<double>(i % 7)});
        many.knots.push_back(static_cast<double>(i));
    }
    many.knots.push_back(static_cast<double>(count - 1));
    document.curves[1].curve = std::make_shared<const core::Curve>(core::Curve::make(many).value());
    state.history = History(document);
    SelectedPart part{1};
    for (std::size_t i = 0; i < count; ++i) part.points.push_back(i);
    state.selection.others = {part};
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_LE(test::markers_of(list, render::MarkerShape::disc, 5.5F).size(), 4000U);
}

TEST(SelectionMarks, very_many_curves_are_marked_by_no_more_than_a_picture_holds) {
    EditorState state = several_curves();
    core::Document document = state.history.present();
    core::CurveDefinition zigzag{.degree = 1, .knots = {0}};
    for (int i = 0; i < 500; ++i) {
        zigzag.points.push_back({-5 + 0.02 * i, i % 2 == 0 ? 0.0 : 0.5});
        zigzag.knots.push_back(i);
    }
    zigzag.knots.push_back(499);
    document.curves[1].curve = std::make_shared<const core::Curve>(core::Curve::make(zigzag).value());
    for (int k = 0; k < 40; ++k) document.curves.push_back(document.curves[1]);
    state.history = History(document);
    state.selection.others.clear();
    for (std::size_t k = 3; k < document.curves.size(); ++k) state.selection.others.push_back({k});
    const render::DrawList list = test::canvas_picture(state);
    std::size_t places = 0;
    for (const render::Polyline& line : test::all_of<render::Polyline>(list)) places += line.points.size();
    EXPECT_LT(places, 10'000U);
    const Theme theme = theme_of(state.view.theme);
    const auto inks = test::all_of<render::Ink>(list);
    EXPECT_TRUE(std::ranges::any_of(
        inks, [&](const render::Ink& ink) { return ink.color == render::blended(theme.accent, 0.4, theme.canvas); }));
    for (SelectedPart& part : state.selection.others) part.points = {1, 2, 3};
    EXPECT_LE(test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 3.5F).size(), 2000U);
}

/// Fifty waves of 500 points, all selected.
EditorState many_waves() {
    EditorState state = several_curves();
    core::Document document;
    for (int k = 0; k < 50; ++k) {
        core::CurveDefinition wave{.degree = 1, .knots = {0}};
        for (int i = 0; i < 500; ++i) {
            wave.points.push_back({-5 + 0.02 * i, 0.05 * k + (i % 2 == 0 ? 0.0 : 0.5)});
            wave.knots.push_back(i);
        }
        wave.knots.push_back(499);
        document.curves.emplace_back().curve = std::make_shared<const core::Curve>(core::Curve::make(wave).value());
    }
    state.history = History(document);
    state.selection.is_whole = true;
    for (std::size_t k = 1; k < document.curves.size(); ++k) state.selection.others.push_back({k});
    return state;
}

std::vector<std::uint8_t> values_of_ink(const render::DrawList& list, render::Color color) {
    for (const render::Ink& ink : test::all_of<render::Ink>(list))
        if (ink.color == color) return {ink.map->values().begin(), ink.map->values().end()};
    return {};
}

TEST(SelectionMarks, very_much_that_moves_has_no_band_until_it_rests) {
    EditorState state = many_waves();
    const Theme theme = theme_of(state.view.theme);
    const render::Color band = render::blended(theme.accent, 0.4, theme.canvas);
    const render::Color line = render::blended(theme.curve, 0.55, theme.canvas);
    SceneCache cache;
    const render::DrawList before = canvas_scene(state, CanvasIdle{}, cache);
    ASSERT_FALSE(values_of_ink(before, band).empty());
    core::Document moved = state.history.present();
    for (core::DocumentCurve& entry : moved.curves) {
        core::CurveDefinition wave = entry.curve->definition();
        for (core::Point& point : wave.points) point.y -= 3.0;
        entry.curve = std::make_shared<const core::Curve>(core::Curve::make(wave).value());
    }
    state.preview = moved;
    const render::DrawList moving = canvas_scene(state, CanvasIdle{}, cache);
    EXPECT_TRUE(values_of_ink(moving, band).empty());
    EXPECT_FALSE(values_of_ink(moving, line).empty());
    EXPECT_NE(values_of_ink(moving, line), values_of_ink(before, line));
    state.preview.reset();
    const render::DrawList after = canvas_scene(state, CanvasIdle{}, cache);
    EXPECT_EQ(values_of_ink(after, band), values_of_ink(before, band));
    EXPECT_EQ(values_of_ink(after, line), values_of_ink(before, line));
    state.history = History(moved);
    const render::DrawList committed = canvas_scene(state, CanvasIdle{}, cache);
    const render::DrawList anew = test::canvas_picture(state);
    EXPECT_EQ(values_of_ink(committed, band), values_of_ink(anew, band));
    EXPECT_EQ(values_of_ink(committed, line), values_of_ink(anew, line)) << "not as coarse as while it moved";
}

TEST(SelectionMarks, a_locked_curve_is_paler) {
    const EditorState state = several_curves();
    const Theme theme = theme_of(state.view.theme);
    const render::DrawList list = test::canvas_picture(state);
    const auto line_at = [&](double y, double share) {
        const auto lines = test::lines_of(list, render::blended(theme.curve, share, theme.canvas), 2.0F);
        return test::distance_to(lines, render::screen_from_world(state.view.camera, {0, y}));
    };
    EXPECT_LT(line_at(-4, 0.55), 1e-3);
    EXPECT_LT(line_at(4, 0.35), 1e-3);
}

}  // namespace
}  // namespace batten::editor
