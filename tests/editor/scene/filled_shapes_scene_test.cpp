// What closed curves enclose, as it is filled, and their directions.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/editor/sample_editor.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Region;

core::CurveDefinition square(core::Point lower, double side, bool is_clockwise = false) {
    const core::Point upper = lower + core::Vector(side, side);
    std::vector<core::Point> points{lower, {upper.x, lower.y}, upper, {lower.x, upper.y}, lower};
    if (is_clockwise) std::reverse(points.begin(), points.end());
    return {.degree = 1, .knots = {0, 0, 1, 2, 3, 4, 4}, .points = std::move(points)};
}

EditorState showing(std::vector<core::CurveDefinition> curves, Overlay overlay) {
    EditorState state = test::scene_state(curves.front());
    core::Document document = state.history.present();
    for (std::size_t i = 1; i < curves.size(); ++i) {
        core::DocumentCurve added = document.curves.front();
        added.name = std::to_string(i);
        added.curve = std::make_shared<const core::Curve>(core::Curve::make(curves[i]).value());
        document.curves.push_back(added);
    }
    state.history = History(document);
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    state.view.overlays.show(overlay, true);
    return state;
}

// In units of the world.
double filled_area(const EditorState& state) {
    double sum = 0.0;
    for (const Region& region : test::all_of<Region>(test::canvas_picture(state)))
        sum += std::accumulate(region.map->values().begin(), region.map->values().end(), 0.0) / 255.0;
    return sum / (state.view.camera.scale * state.view.camera.scale);
}

TEST(FilledShapes, follow_their_rule) {
    const auto outer = square({-2, -2}, 4);
    EXPECT_NEAR(filled_area(showing({outer}, Overlay::fill)), 16.0, 0.01);
    EXPECT_NEAR(filled_area(showing({outer, square({-1, -1}, 2)}, Overlay::fill)), 16.0, 0.01);
    EXPECT_NEAR(filled_area(showing({outer, square({-1, -1}, 2, true)}, Overlay::fill)), 12.0, 0.01);
    EXPECT_NEAR(filled_area(showing({outer, square({-1, -1}, 2)}, Overlay::even_odd_fill)), 12.0, 0.01);
    EXPECT_TRUE(test::all_of<Region>(test::canvas_picture(showing({outer}, Overlay::grid))).empty());
}

TEST(FilledShapes, are_those_of_closed_visible_curves) {
    const core::CurveDefinition open{.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 1}}};
    EXPECT_TRUE(test::all_of<Region>(test::canvas_picture(showing({open}, Overlay::fill))).empty());
    EditorState state = showing({square({-2, -2}, 2), square({0, 0}, 1)}, Overlay::fill);
    core::Document document = state.history.present();
    document.curves[0].visible = false;
    state.history = History(document);
    EXPECT_NEAR(filled_area(state), 1.0, 0.01);
}

// The picture lies inside a square of a million, or on its corner, whatever is left out of view.
TEST(FilledShapes, reach_beyond_the_picture) {
    EditorState state = showing({square({-1e6, -1e6}, 2e6)}, Overlay::fill);
    const glm::dvec2 size = state.view.camera.size_px;
    const double picture = size.x * size.y / (state.view.camera.scale * state.view.camera.scale);
    EXPECT_NEAR(filled_area(state), picture, 1e-9);
    EXPECT_EQ(test::faults_of(test::canvas_picture(state), size, 100.0), std::vector<std::string>());
    state = showing({square({state.view.camera.center.x, state.view.camera.center.y}, 1e6)}, Overlay::fill);
    EXPECT_NEAR(filled_area(state), 0.25 * picture, 0.02);
    // A ring around the picture.
    state = showing({square({-1e3, -1e3}, 2e3), square({-500, -500}, 1e3)}, Overlay::even_odd_fill);
    EXPECT_NEAR(filled_area(state), 0.0, 1e-9);
}

TEST(FilledShapes, are_kept_while_nothing_changes) {
    EditorState state = showing({square({-2, -2}, 4)}, Overlay::fill);
    SceneCache cache;
    const auto map = [&] { return test::all_of<Region>(canvas_scene(state, CanvasIdle{}, cache))[0].map; };
    const auto first = map();
    EXPECT_EQ(map(), first);
    state.view.camera.scale *= 1.5;
    EXPECT_NE(map(), first);
}

TEST(Directions, point_along_the_curve) {
    const EditorState state = showing({square({-2, -2}, 4)}, Overlay::directions);
    // Chevrons are lines of three points, the one in the middle ahead of the others.
    const glm::dvec2 center = render::screen_from_world(state.view.camera, {0.0, 0.0});
    int count = 0;
    for (const auto& line : test::all_of<render::Polyline>(test::canvas_picture(state))) {
        if (line.points.size() != 3) continue;
        ++count;
        const glm::dvec2 tip(line.points[1]);
        const glm::dvec2 back = 0.5 * (glm::dvec2(line.points[0]) + glm::dvec2(line.points[2]));
        const glm::dvec2 arm = tip - center;
        const glm::dvec2 along = tip - back;
        // Counter-clockwise, with y down.
        EXPECT_LT(arm.x * along.y - arm.y * along.x, 0.0);
    }
    // Of 1056 px, from 50 px on.
    EXPECT_EQ(count, 11);
}

}  // namespace
}  // namespace batten::editor
