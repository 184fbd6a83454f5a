/// What the drawing mode hides and thins.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/editor.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/scene/thinned_points.h"
#include "app/editor/state/settings.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Marker;
using render::MarkerShape;
using Indices = std::vector<std::size_t>;

EditorState state_of(std::vector<core::Point> points) {
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 3, points.size()).value();
    EditorState state = test::scene_state(core::Curve::make(knots, std::move(points), {}).value().definition());
    state.view.overlays.set_drawing(true);
    return state;
}

/// At 66 px a unit.
std::vector<core::Point> row(std::size_t count, double apart_px) {
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(-5.0 + static_cast<double>(i) * apart_px / 66.0, 1.0);
    return points;
}

std::vector<MarkPlace> places(std::size_t count, double apart_px) {
    std::vector<MarkPlace> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back({i, {static_cast<double>(i) * apart_px, 0.0}});
    return result;
}

Indices indices_of(const std::vector<MarkPlace>& marks) {
    Indices indices;
    for (const MarkPlace& mark : marks) indices.push_back(mark.index);
    return indices;
}

/// The control points that a pointer finds along the row.
Indices hit_along(const EditorState& state, double length_px) {
    Indices found;
    const glm::dvec2 start = render::screen_from_world(state.view.camera, {-5.0, 1.0});
    for (double x = 0.0; x <= length_px; x += 0.5)
        if (const auto hit = hit_canvas(state, start + glm::dvec2(x, 0.0)); std::holds_alternative<HoveredPoint>(hit))
            if (const std::size_t i = std::get<HoveredPoint>(hit).index; found.empty() || found.back() != i)
                found.push_back(i);
    return found;
}

TEST(ThinnedPoints, keep_every_fourth_of_a_row_two_pixels_apart) {
    // A point is hidden by one that is divided by a higher power of two within 6 pixels.
    EXPECT_EQ(indices_of(thinned(places(17, 2.0), 6.0, {0, 0})), (Indices{0, 4, 8, 12, 16}));
    EXPECT_EQ(indices_of(thinned(places(9, 5.0), 6.0, {0, 0})), (Indices{0, 2, 4, 6, 8}));
    EXPECT_EQ(thinned(places(9, 6.0), 6.0, {0, 0}).size(), 9U);
    EXPECT_EQ(indices_of(thinned(places(1000, 0.0), 6.0, {0, 0})), (Indices{0}));
}

TEST(ThinnedPoints, are_never_nearer_than_the_gap_and_stay_while_the_view_moves) {
    std::vector<MarkPlace> scattered;
    std::size_t i = 0;
    for (const core::Point point : test::scattered_points(4000, {300.0, 200.0})) scattered.push_back({i++, point});
    const std::vector<MarkPlace> kept = thinned(scattered, 6.0, {0, 0});
    EXPECT_GT(kept.size(), 300U);
    for (const MarkPlace& a : kept)
        for (const MarkPlace& b : kept)
            if (a.index < b.index) {
                EXPECT_GE(glm::distance(a.place, b.place), 6.0) << a.index << " " << b.index;
            }
    const glm::dvec2 moved(12.25, -7.5);
    for (MarkPlace& place : scattered) place.place += moved;
    EXPECT_EQ(indices_of(thinned(scattered, 6.0, moved)), indices_of(kept));
}

TEST(ThinnedPoints, stand_for_a_run_by_the_index_that_lasts_longest) {
    EXPECT_EQ(lasting_index(5, 1), 5U);
    EXPECT_EQ(lasting_index(5, 3), 6U);
    EXPECT_EQ(lasting_index(5, 4), 8U);
    EXPECT_EQ(lasting_index(0, 100), 0U);
    EXPECT_EQ(lasting_index(17, 16), 32U);
    EXPECT_EQ(lasting_index(33, 16), 48U);
}

TEST(DrawingMode, thins_what_is_drawn_and_hit) {
    EditorState state = state_of(row(65, 2.0));
    state.view.parameter = 1.0;
    EXPECT_EQ(hit_along(state, 128.0), (Indices{0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64}));
    state.view.overlays.set_drawing(false);
    EXPECT_EQ(hit_along(state, 128.0).size(), 65U);
}

TEST(DrawingMode, always_shows_what_is_selected_or_hovered) {
    EditorState state = state_of(row(65, 2.0));
    state.selection.points = {5};
    const auto has_mark = [&](std::size_t i) {
        const glm::dvec2 place =
            render::screen_from_world(state.view.camera, {-5.0 + 2.0 * static_cast<double>(i) / 66.0, 1.0});
        for (const Marker& marker : test::all_of<Marker>(test::canvas_picture(state)))
            if (glm::distance(glm::dvec2(marker.center), place) < 0.5) return true;
        return false;
    };
    EXPECT_TRUE(has_mark(5));
    EXPECT_FALSE(has_mark(6));
    EXPECT_FALSE(has_mark(7));
    state.hover = HoveredPoint{7};
    EXPECT_TRUE(has_mark(7));
    EXPECT_EQ(hit_canvas(state, render::screen_from_world(state.view.camera, {-5.0 + 10.0 / 66.0, 1.0})),
              Hover(HoveredPoint{5}));
}

TEST(DrawingMode, draws_no_more_than_without_it_of_a_million_points) {
    EditorState state = state_of(test::scattered_points(100'000, {12.0, 7.0}));
    const std::size_t drawn = test::all_of<Marker>(test::canvas_picture(state)).size();
    EXPECT_GT(drawn, 100U);
    EXPECT_LT(drawn, 2000U);
}

TEST(DrawingMode, hides_what_is_in_the_way_and_shows_it_again) {
    Editor editor = test::zigzag_editor();
    const Overlays before = editor.state().view.overlays;
    ASSERT_TRUE(before.is_shown(Overlay::hull));
    editor.run(ToggleDrawing{});
    for (const Overlay hidden : {Overlay::hull, Overlay::construction, Overlay::labels, Overlay::knots})
        EXPECT_FALSE(editor.state().view.overlays.is_shown(hidden)) << core::name_of(hidden);
    EXPECT_TRUE(editor.state().view.overlays.is_shown(Overlay::polygon));
    EXPECT_TRUE(editor.state().view.overlays.is_shown(Overlay::grid));
    EXPECT_FALSE(shows_dock(editor.state().view));
    EXPECT_FALSE(editor.run(ToggleOverlay<Overlay::hull>{}));
    EXPECT_EQ(editor.state().message.text, "the drawing mode hides it; end the drawing mode to see it");
    EXPECT_FALSE(editor.run(ToggleDock{}));
    EXPECT_TRUE(editor.run(ToggleOverlay<Overlay::grid>{}));
    EXPECT_TRUE(editor.run(ToggleOverlay<Overlay::grid>{}));
    editor.run(ToggleDrawing{});
    EXPECT_EQ(editor.state().view.overlays, before);
    EXPECT_TRUE(shows_dock(editor.state().view));
}

TEST(DrawingMode, is_neither_in_settings_nor_changes_them) {
    Editor editor = test::zigzag_editor();
    const std::string before = format_settings(settings_of(editor.state()));
    editor.run(ToggleDrawing{});
    EXPECT_EQ(format_settings(settings_of(editor.state())), before);
}

}  // namespace
}  // namespace batten::editor
