#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/scene/uniform_cubics.h"
#include "render/clip.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

constexpr std::array cubic_overlays{Overlay::anticentroids, Overlay::ferguson, Overlay::end_vertices,
                                    Overlay::joined_cubics};

EditorState state_with(core::CurveDefinition definition, std::initializer_list<Overlay> overlays) {
    EditorState state = test::scene_state(std::move(definition));
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    for (const Overlay overlay : overlays) state.view.overlays.show(overlay, true);
    return state;
}

core::CurveDefinition coons() {
    return {.degree = 3, .knots = {-3, -2, -1, 0, 1, 2, 3, 4}, .points = {{-3, -2}, {-2, 1}, {1, 1}, {2, -3}}};
}

using test::screen;

bool has_marker(const render::DrawList& list, const EditorState& state, core::Point place, float radius_px) {
    for (const render::Marker& marker : test::markers_of(list, render::MarkerShape::disc, radius_px))
        if (glm::distance(glm::dvec2(marker.center), screen(state, place)) < 1e-3) return true;
    return false;
}

/// Whether an arrow's head, a triangle, has its tip there.
bool has_tip(const render::DrawList& list, const EditorState& state, core::Point place) {
    for (const render::Fill& fill : test::all_of<render::Fill>(list))
        if (fill.points.size() == 3 && glm::distance(glm::dvec2(fill.points[0]), screen(state, place)) < 1e-3)
            return true;
    return false;
}

bool has_segment(const render::DrawList& list, const EditorState& state, core::Point a, core::Point b) {
    for (const render::Polyline& line : test::all_of<render::Polyline>(list))
        if (glm::distance(glm::dvec2(line.points.front()), screen(state, a)) < 1e-3 &&
            glm::distance(glm::dvec2(line.points.back()), screen(state, b)) < 1e-3)
            return true;
    return false;
}

TEST(UniformCubicsScene, anticentroids_stand_a_third_along_the_medians) {
    EditorState state = state_with(coons(), {Overlay::anticentroids});
    state.view.parameter = 0.25;
    const render::DrawList list = test::canvas_picture(state);
    // ((-3, -2) + 4 (-2, 1) + (1, 1)) / 6 and ((-2, 1) + 4 (1, 1) + (2, -3)) / 6.
    EXPECT_TRUE(has_marker(list, state, {-10.0 / 6.0, 0.5}, 5.0F));
    EXPECT_TRUE(has_marker(list, state, {4.0 / 6.0, 2.0 / 6.0}, 5.0F));
    EXPECT_TRUE(has_segment(list, state, {-2, 1}, {-1, -0.5})) << "the median";
    EXPECT_TRUE(has_segment(list, state, {-3, -2}, {1, 1})) << "the base";
    EXPECT_TRUE(has_tip(list, state, {-10.0 / 6.0 + 2.0, 0.5 + 1.5})) << "S' is half of the base";
    EXPECT_TRUE(has_tip(list, state, {0, -2})) << "S'' is the diagonal";
    EXPECT_TRUE(has_segment(list, state, {-3, -2}, {0, -2})) << "a side of the parallelogram";
    for (const char* text : {"S", "M", "S′", "S″", "1/3", "2/3"}) EXPECT_TRUE(test::has_text(list, text)) << text;
    EXPECT_EQ(test::overlapping_labels(list), std::vector<std::string>{});
}

TEST(UniformCubicsScene, names_stand_off_the_medians) {
    const EditorState state = state_with({.degree = 3,
                                          .knots = {0, 1, 2, 3, 4, 5, 6},
                                          .points = {{4, 0}, {2.5, 3}, {-1, 2.5}, {-4, 1}, {-3, -2.5}, {1.5, -3}},
                                          .periodic = true},
                                         {Overlay::polygon, Overlay::labels, Overlay::anticentroids});
    const render::DrawList list = test::canvas_picture(state);
    for (const render::Label& label : test::all_of<render::Label>(list)) {
        if (!label.text.starts_with("P_")) continue;
        const render::PixelBox box = test::box_of(label);
        for (const render::Polyline& line : test::all_of<render::Polyline>(list))
            for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
                EXPECT_FALSE(render::clip_segment(box, line.points[k], line.points[k + 1]) && line.width_px != 1.0F)
                    << label.text;
    }
}

TEST(UniformCubicsScene, the_construction_follows_the_pointer) {
    EditorState state = state_with(coons(), {Overlay::anticentroids});
    state.view.parameter = 0.25;
    state.hover = HoveredPoint{2};
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(has_tip(list, state, {4.0 / 6.0 + 2.0, 2.0 / 6.0 - 2.0}));
    EXPECT_FALSE(has_tip(list, state, {-10.0 / 6.0 + 2.0, 0.5 + 1.5}));
}

TEST(UniformCubicsScene, ferguson_form_has_both_tangents) {
    const EditorState state = state_with(coons(), {Overlay::ferguson});
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(has_tip(list, state, {-10.0 / 6.0 + 2.0, 0.5 + 1.5}));
    EXPECT_TRUE(has_tip(list, state, {4.0 / 6.0 + 2.0, 2.0 / 6.0 - 2.0}));
    for (const char* text : {"Q_{0}", "Q_{1}", "Q_{0}′", "Q_{1}′"}) EXPECT_TRUE(test::has_text(list, text)) << text;
    EXPECT_FALSE(test::has_text(list, "")) << "light tangents have no names, not empty ones";
}

TEST(UniformCubicsScene, end_vertices_show_where_the_curve_would_begin) {
    const EditorState state = state_with(coons(), {Overlay::end_vertices});
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(has_marker(list, state, {-3.0 + 1.0 / 6.0, -1.5}, 5.0F)) << "double: a sixth of the leg";
    EXPECT_TRUE(has_marker(list, state, {-3, -2}, 5.0F)) << "triple and phantom";
    EXPECT_TRUE(has_marker(list, state, {3, -7}, 6.0F) || screen(state, {3, -7}).y > 566.0) << "2 P3 - P2";
    // The new part leads to where the curve began.
    EXPECT_TRUE(has_segment(list, state, {-3.0 + 1.0 / 6.0, -1.5}, {-10.0 / 6.0, 0.5}));
    EXPECT_TRUE(has_segment(list, state, {-3, -2}, {-10.0 / 6.0, 0.5})) << "by the phantom";
    EXPECT_TRUE(test::has_text(list, "double"));
}

TEST(UniformCubicsScene, end_vertices_that_were_added_have_their_name) {
    core::CurveDefinition definition = coons();
    definition.points.insert(definition.points.begin(), {-4, -5});  // 2 (-3, -2) - (-2, 1)
    definition.knots.insert(definition.knots.begin(), -4);
    const render::DrawList list = test::canvas_picture(state_with(definition, {Overlay::end_vertices}));
    const auto count_of = [&](const std::string& text) { return std::ranges::count(test::texts_of(list), text); };
    EXPECT_EQ(count_of("midway vertex"), 1);
    EXPECT_EQ(count_of("double"), 1) << "at the other end alone";
    EXPECT_EQ(count_of("triple"), 1);
}

TEST(UniformCubicsScene, long_second_derivatives_are_shortened_alike) {
    EditorState state =
        state_with({.degree = 3, .knots = {-3, -2, -1, 0, 1, 2, 3, 4}, .points = {{-6, -2}, {-5, 2}, {-2, 3}, {0, 0}}},
                   {Overlay::joined_cubics});
    core::Document document = state.shown();
    document.curves.push_back(document.curves.front());
    document.curves.back().curve = std::make_shared<const core::Curve>(*core::Curve::make(
        {.degree = 3, .knots = {-3, -2, -1, 0, 1, 2, 3, 4}, .points = {{-5, 0}, {-2, 4}, {0, -2}, {4, 2}}}));
    state.preview = document;
    const render::DrawList list = test::canvas_picture(state);
    // C″ is (-1, -4) and (-1, -10), longer than the six vertices are apart: 5 across, 6 up.
    const core::Point joint{-13.0 / 6.0, 7.0 / 3.0};
    EXPECT_TRUE(has_tip(list, state, joint + core::Vector(-0.5, -2)));
    EXPECT_TRUE(has_tip(list, state, joint + core::Vector(-0.5, -5)));
    EXPECT_TRUE(test::has_text(list, "C″/2"));
    EXPECT_FALSE(test::has_text(list, "C″"));
}

TEST(UniformCubicsScene, tells_of_equal_and_collinear_vertices) {
    core::CurveDefinition definition{.degree = 3,
                                     .points = {{-4, 0}, {-2, 2}, {-2, 2}, {1, 2}, {3, 2}, {4, 2}, {5, -1}}};
    for (int i = 0; i < 11; ++i) definition.knots.push_back(i);
    const EditorState state = state_with(definition, {Overlay::end_vertices});
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(test::has_text(list, "double vertex"));
    EXPECT_TRUE(test::has_text(list, "collinear"));
    EXPECT_TRUE(has_marker(list, state, {-2.0 - 2.0 / 6.0, 2.0 - 2.0 / 6.0}, 5.0F)) << "a sixth of the leg to P0";
    // P2 to P5 are on one line: (-2 + 4 + 3) / 6 to (1 + 12 + 4) / 6.
    EXPECT_TRUE(has_segment(list, state, {5.0 / 6.0, 2}, {17.0 / 6.0, 2}));
}

TEST(UniformCubicsScene, draws_nothing_for_other_curves) {
    for (const Overlay overlay : cubic_overlays) {
        EditorState with = state_with(test::cubic(), {overlay});
        EditorState without = state_with(test::cubic(), {});
        EXPECT_EQ(test::canvas_picture(with).commands.size(), test::canvas_picture(without).commands.size());
    }
}

TEST(UniformCubicsScene, stays_finite_and_bounded) {
    core::CurveDefinition huge = coons();
    for (core::Point& point : huge.points) point = {1e300 * point.x, -1e300 * point.y};
    core::CurveDefinition far = coons();
    for (core::Point& point : far.points) point += core::Vector(1e6, -1e6);
    core::CurveDefinition one_place = coons();
    one_place.points.assign(4, {1, 1});
    core::CurveDefinition two{.degree = 3, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 1}}, .periodic = true};
    core::CurveDefinition many{.degree = 3, .points = test::scattered_points(10000, {14, 8})};
    for (std::size_t i = 0; i < 10004; ++i) many.knots.push_back(static_cast<double>(i));
    for (const core::CurveDefinition& definition : {coons(), huge, far, one_place, two, many}) {
        EditorState state = state_with(
            definition, {Overlay::anticentroids, Overlay::ferguson, Overlay::end_vertices, Overlay::joined_cubics});
        const render::DrawList list = test::canvas_picture(state);
        EXPECT_EQ(test::faults_of(list, state.view.camera.size_px, 2000.0), std::vector<std::string>{});
        EXPECT_LT(list.commands.size(), 2000u);
    }
}

}  // namespace
}  // namespace batten::editor
