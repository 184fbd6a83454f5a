// The views of the curve's shape, as they are drawn: curvature, parts, hulls, support, crossings.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/pointer/comb_tooth.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/plot_layout.h"
#include "app/editor/scene/bend_marks.h"
#include "core/measure/arc_length.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Marker;
using render::MarkerShape;

using test::dark;

// Only `overlay`, so that nothing else has its marks.
EditorState showing(EditorState state, std::initializer_list<Overlay> overlays) {
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    for (const Overlay overlay : overlays) state.view.overlays.show(overlay, true);
    return state;
}

EditorState showing(core::CurveDefinition definition, std::initializer_list<Overlay> overlays) {
    return showing(test::scene_state(std::move(definition)), overlays);
}

// Points (-4,-2) (-2,2) (0,-2) (2,2) (4,-2); y = 0 is passed at u = 1/3, 1, 2, 8/3, where x is -25/9, -1, 1, 25/9.
core::CurveDefinition zigzag() {
    return {.degree = 2, .knots = {0, 0, 0, 1, 2, 3, 3, 3}, .points = {{-4, -2}, {-2, 2}, {0, -2}, {2, 2}, {4, -2}}};
}

core::CurveDefinition circle(double radius) {
    const double w = std::sqrt(0.5);
    const double r = radius;
    return {.degree = 2,
            .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
            .points = {{r, 0}, {r, r}, {0, r}, {-r, r}, {-r, 0}, {-r, -r}, {0, -r}, {r, -r}, {r, 0}},
            .weights = {1, w, 1, w, 1, w, 1, w, 1}};
}

using test::screen;

bool has_mark(const std::vector<Marker>& marks, glm::dvec2 place) {
    return std::ranges::any_of(
        marks, [&](const Marker& mark) { return glm::distance(glm::dvec2(mark.center), place) < 0.01; });
}

void expect_no_faults(const EditorState& state) {
    const auto faults = test::faults_of(test::canvas_picture(state), state.view.camera.size_px, 4000.0);
    EXPECT_TRUE(faults.empty()) << faults.front();
    const glm::dvec2 dock(1048.0, 420.0);
    const auto plot_faults = test::faults_of(test::plot_picture(state, PlotIdle{}, dock), dock, 4000.0);
    EXPECT_TRUE(plot_faults.empty()) << plot_faults.front();
}

TEST(VariationScene, marks_crossings_of_curve_and_polygon) {
    EditorState state = showing(zigzag(), {Overlay::variation});
    const render::DrawList list = test::canvas_picture(state);
    const auto discs = test::markers_of(list, MarkerShape::disc, 6.0F);
    ASSERT_EQ(discs.size(), 4U);
    for (const double x : {-25.0 / 9.0, -1.0, 1.0, 25.0 / 9.0})
        EXPECT_TRUE(has_mark(discs, screen(state, {x, 0.0}))) << x;
    for (const Marker& disc : discs) EXPECT_EQ(disc.fill, dark().parameter);
    const auto squares = test::markers_of(list, MarkerShape::square, 6.0F);
    ASSERT_EQ(squares.size(), 4U);
    for (const double x : {-3.0, -1.0, 1.0, 3.0}) EXPECT_TRUE(has_mark(squares, screen(state, {x, 0.0}))) << x;
    // Higher it crosses the polygon alone; along the highest points it touches: -2 + 8t - 6t^2 is 2/3 at t = 2/3.
    state.view.shape.line = ProbeLine{{0, 1}, {1, 1}};
    EXPECT_TRUE(test::markers_of(test::canvas_picture(state), MarkerShape::disc, 6.0F).empty());
    EXPECT_EQ(test::markers_of(test::canvas_picture(state), MarkerShape::square, 6.0F).size(), 4U);
    state.view.shape.line = ProbeLine{{0, 2.0 / 3.0}, {1, 2.0 / 3.0}};
    const auto touches = test::markers_of(test::canvas_picture(state), MarkerShape::disc, 6.0F);
    ASSERT_EQ(touches.size(), 2U);
    EXPECT_EQ(touches[0].fill, dark().canvas);
}

TEST(VariationScene, line_passes_its_handles_and_the_whole_picture_at_any_zoom) {
    for (const double scale : {1e-6, 1.0, 66.0, 1e7, 1e12}) {
        EditorState state = showing(zigzag(), {Overlay::variation});
        state.view.shape.line = ProbeLine{{-1, -0.5}, {3, 0.5}};
        state.view.camera.scale = scale;
        state.view.camera.center = {1.0, 0.0};
        const auto lines = test::lines_of(test::canvas_picture(state), dark().accent, 2.0F);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_LT(test::distance_to(lines, 0.5 * state.view.camera.size_px), 0.5) << scale;
        const glm::dvec2 along = glm::dvec2(lines[0].points.back()) - glm::dvec2(lines[0].points.front());
        EXPECT_NEAR(along.y / along.x, -0.25, 1e-4) << scale;
        EXPECT_GE(std::abs(along.x), state.view.camera.size_px.x) << scale;
    }
}

TEST(PartsScene, equal_lengths_divide_a_circle_evenly_and_equal_steps_do_not) {
    EditorState state = showing(circle(3.0), {Overlay::equal_steps, Overlay::equal_lengths});
    state.view.shape.part_count = 12;
    const render::DrawList list = test::canvas_picture(state);
    const auto rings = test::markers_of(list, MarkerShape::disc, 7.0F);
    ASSERT_EQ(rings.size(), 13U);
    for (int k = 0; k < 12; ++k) {
        const double angle = k * std::acos(-1.0) / 6.0;
        EXPECT_TRUE(has_mark(rings, screen(state, {3.0 * std::cos(angle), 3.0 * std::sin(angle)}))) << k;
    }
    const auto dots = test::markers_of(list, MarkerShape::disc, 4.5F);
    ASSERT_EQ(dots.size(), 13U);
    // C(1/3): the first quarter at a third of the parameter is not at 30 degrees.
    EXPECT_FALSE(has_mark(dots, screen(state, {3.0 * std::cos(std::acos(-1.0) / 6.0), 1.5})));
    EXPECT_TRUE(has_mark(dots, screen(state, {0.0, 3.0})));
}

TEST(CurvatureScene, extremes_are_named_within_the_comb_and_off_control_points) {
    EditorState state =
        showing(test::sample_state(), {Overlay::polygon, Overlay::curvature_comb, Overlay::curvature_marks});
    for (const double scale : {25.0, 40.0, 66.0}) {
        state.view.camera.scale = scale;
        std::size_t extremes = 0;
        for (const render::Label& label : test::all_of<render::Label>(test::canvas_picture(state))) {
            if (label.text.find("κ = ") == std::string::npos) continue;
            if (label.text.starts_with("m")) ++extremes;
            for (const core::Point point : state.active_curve()->control_points())
                EXPECT_FALSE(test::box_of(label).contains(render::screen_from_world(state.view.camera, point)))
                    << label.text << " " << scale;
        }
        EXPECT_EQ(extremes, 3U) << scale;
    }
}

TEST(CurvatureScene, osculating_circle_of_a_circle_is_the_circle) {
    EditorState state = showing(circle(2.0), {Overlay::osculating_circle});
    state.view.parameter = 0.3;
    const render::DrawList list = test::canvas_picture(state);
    const auto lines = test::lines_of(list, dark().comb, 2.0F);
    ASSERT_EQ(lines.size(), 1U);
    const double radius = 2.0 * state.view.camera.scale;
    const glm::dvec2 center = screen(state, {0.0, 0.0});
    for (const render::Pixel place : lines[0].points)
        EXPECT_NEAR(glm::distance(glm::dvec2(place), center), radius, 1e-3);
    for (double angle = 0.0; angle < 6.28; angle += 0.05)
        EXPECT_LT(test::distance_to(lines, center + radius * glm::dvec2(std::cos(angle), std::sin(angle))), 0.25);
    EXPECT_TRUE(test::has_text(list, "ρ = 2"));
}

// A millimeter is 10 of the world: the circle of radius 2 has one of 0.2 mm and is bent by 5 for each of them.
TEST(CurvatureScene, is_in_the_unit_of_the_document) {
    core::Document document = showing(circle(2.0), {}).shown();
    document.units = core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 10.0};
    EditorState state = showing(circle(2.0), {Overlay::osculating_circle, Overlay::curvature_plot});
    state.history = History(std::move(document));
    state.view.parameter = 0.3;
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "ρ = 1/5 mm"));
    const render::DrawList plot = test::plot_picture(state, PlotIdle{}, {1048.0, 342.0});
    EXPECT_TRUE(test::has_text(plot, "κ = 5"));
    EXPECT_TRUE(test::has_text(plot, "5")) << "the level on which the graph is";
}

TEST(CurvatureScene, extremes_are_in_the_unit_of_the_document) {
    // An ellipse of half axes 2 and 1 has the curvatures 2/1 and 1/4 at its ends.
    core::CurveDefinition ellipse = circle(1.0);
    for (core::Point& point : ellipse.points) point.x *= 2.0;
    EditorState state = showing(ellipse, {Overlay::curvature_marks});
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "max κ = 2"));
    core::Document document = state.shown();
    document.units = core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 10.0};
    state.history = History(std::move(document));
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "max κ = 20"));
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "min κ = 5/2"));
}

TEST(CurvatureScene, tangent_and_normal_stand_square_on_each_other) {
    EditorState state = showing(circle(2.0), {Overlay::tangent_normal});
    state.view.parameter = 1.0;  // (0, 2), going left
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(test::has_text(list, "T"));
    EXPECT_TRUE(test::has_text(list, "N"));
    const auto tangent = test::lines_of(list, dark().level(1), 3.0F);
    const auto normal = test::lines_of(list, dark().level(2), 3.0F);
    ASSERT_EQ(tangent.size(), 1U);
    ASSERT_EQ(normal.size(), 1U);
    const auto direction = [](const render::Polyline& line) {
        return glm::normalize(glm::dvec2(line.points.back()) - glm::dvec2(line.points.front()));
    };
    EXPECT_LT(glm::distance(direction(tangent[0]), {-1.0, 0.0}), 1e-4);
    EXPECT_LT(glm::distance(direction(normal[0]), {0.0, 1.0}), 1e-4) << "down the picture, to the center";
}

TEST(CurvatureScene, inflection_and_extremes_of_a_cubic_graph) {
    // y = x^3 from -1 to 2; its inflection is at (0, 0). With x = 45^(-1/4) the curvature is greatest, and least at -x.
    EditorState state =
        showing({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{-1, -1}, {0, 2}, {1, -4}, {2, 8}}},
                {Overlay::curvature_marks});
    const render::DrawList list = test::canvas_picture(state);
    const auto rings = test::markers_of(list, MarkerShape::disc, 6.0F);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_TRUE(has_mark(rings, screen(state, {0.0, 0.0})));
    const auto squares = test::markers_of(list, MarkerShape::square, 5.0F);
    ASSERT_EQ(squares.size(), 2U);
    const double x = std::pow(45.0, -0.25);
    EXPECT_TRUE(has_mark(squares, screen(state, {x, x * x * x})));
    EXPECT_TRUE(has_mark(squares, screen(state, {-x, -x * x * x})));
    EXPECT_TRUE(test::has_text(list, "κ = 0"));
}

TEST(SupportScene, band_ends_where_the_support_does) {
    EditorState state = showing(test::cubic(), {Overlay::support});
    EXPECT_TRUE(test::markers_of(test::canvas_picture(state), MarkerShape::disc, 6.0F).empty());
    state.selection.points = {4};  // [u_4, u_8] = [1/4, 1]
    const render::DrawList list = test::canvas_picture(state);
    const auto ends = test::markers_of(list, MarkerShape::disc, 6.0F);
    ASSERT_EQ(ends.size(), 2U);
    EXPECT_TRUE(has_mark(ends, screen(state, core::point_at(*state.active_curve(), 0.25))));
    EXPECT_TRUE(has_mark(ends, screen(state, {6.2, 2.8})));
    EXPECT_TRUE(test::has_text(list, "u = 1/4"));
    const auto bands = test::lines_of(list, render::blended(dark().point(4), 0.45, dark().canvas), 12.0F);
    ASSERT_FALSE(bands.empty());
    const glm::dvec2 first(bands.front().points.front());
    EXPECT_LT(glm::distance(first, screen(state, core::point_at(*state.active_curve(), 0.25))), 0.5);
    // The strip of the plot is as long.
    const glm::dvec2 dock(1048.0, 260.0);
    const PlotLayout layout = plot_layout(state, dock);
    const auto strips = test::lines_of(test::plot_picture(state, PlotIdle{}, dock), dark().point(4), 5.0F);
    ASSERT_EQ(strips.size(), 1U);
    EXPECT_NEAR(strips[0].points.front().x, x_from_parameter(layout, 0.25), 0.01);
    EXPECT_NEAR(strips[0].points.back().x, x_from_parameter(layout, 1.0), 0.01);
}

TEST(HullScene, each_span_has_the_hull_of_its_points) {
    const EditorState state = showing(zigzag(), {Overlay::span_hulls});
    const auto fills = test::all_of<render::Fill>(test::canvas_picture(state));
    ASSERT_EQ(fills.size(), 3U);
    for (const render::Fill& fill : fills) EXPECT_EQ(fill.points.size(), 3U);
    for (const core::Point corner : {core::Point(-2, 2), core::Point(0, -2), core::Point(2, 2)})
        EXPECT_TRUE(std::ranges::any_of(fills[1].points, [&](render::Pixel place) {
            return glm::distance(glm::dvec2(place), screen(state, corner)) < 0.01;
        }));
}

TEST(CombHandle, stands_at_the_tip_and_stretches_the_comb) {
    EditorState state = showing(circle(2.0), {Overlay::curvature_comb});
    state.view.parameter = 1.0;  // (0, 2)
    const auto handle = comb_handle(state, 1.0).value();
    EXPECT_LT(glm::distance(handle.foot_px, screen(state, {0.0, 2.0})), 1e-9);
    EXPECT_LT(glm::distance(handle.place_px, handle.foot_px - glm::dvec2(0.0, 60.0)), 1e-6) << "outward";
    EXPECT_NEAR(dragged_comb_factor(state, 1.0, {0.0, -60.0}), 2.0, 1e-9);
    EXPECT_NEAR(dragged_comb_factor(state, 1.0, {35.0, 30.0}), 0.5, 1e-9);
    EXPECT_EQ(dragged_comb_factor(state, 1.0, {0.0, 5000.0}), comb_factors.lower);
    state.view.shape.comb_factor = 2.0;
    const auto tips = test::lines_of(test::canvas_picture(state), dark().comb, 1.5F);
    ASSERT_FALSE(tips.empty());
    const double radius = 2.0 * state.view.camera.scale + 120.0;
    for (const render::Pixel tip : tips.front().points)
        EXPECT_NEAR(glm::distance(glm::dvec2(tip), screen(state, {0.0, 0.0})), radius, 0.01);
    EXPECT_FALSE(comb_handle(showing(circle(2.0), {}), 1.0));
}

TEST(QuantityPlots, stand_below_the_strip_on_its_axis) {
    EditorState state = showing(circle(2.0), {Overlay::curvature_plot, Overlay::speed_plot});
    EXPECT_EQ(height_of_plots(state.view), 164.0);
    const glm::dvec2 dock(1048.0, 260.0 + 164.0);
    const PlotLayout layout = plot_layout(state, dock);
    ASSERT_EQ(layout.graphs.size(), 2U);
    EXPECT_GT(layout.graphs[0].lower_px.y, layout.strip_px + layout.labels_px - 1.0);
    EXPECT_GT(layout.graphs[1].lower_px.y, layout.graphs[0].upper_px.y);
    EXPECT_LE(layout.graphs[1].upper_px.y, dock.y);
    const PlotLayout plain = plot_layout(showing(circle(2.0), {}), {1048.0, 260.0});
    EXPECT_EQ(plain.strip_px, layout.strip_px) << "the basis plot stays as it was";
    const render::DrawList list = test::plot_picture(state, PlotIdle{}, dock);
    const auto graphs = test::lines_of(list, dark().comb, 2.25F);
    ASSERT_EQ(graphs.size(), 4U) << "one for each span";
    for (const render::Polyline& graph : graphs)
        for (const render::Pixel place : graph.points)
            EXPECT_NEAR(place.y, graphs[0].points[0].y, 0.01) << "the curvature of a circle is 1/2 everywhere";
    EXPECT_NEAR(graphs[1].points.front().x, x_from_parameter(layout, 1.0), 0.01);
    EXPECT_TRUE(test::has_text(list, "κ = 0.5"));
    EXPECT_TRUE(test::has_text(list, "Speed |C′(u)|"));
}

TEST(QuantityPlots, mark_inflections_and_extremes_and_take_the_parameter) {
    // y = x^3 from -1 to 2 has x = 3u - 1; its inflection is at u = 1/3.
    EditorState state =
        showing({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{-1, -1}, {0, 2}, {1, -4}, {2, 8}}},
                {Overlay::curvature_plot, Overlay::curvature_marks});
    state.view.parameter = 0.75;
    const glm::dvec2 dock(1048.0, 342.0);
    const PlotLayout layout = plot_layout(state, dock);
    const render::DrawList list = test::plot_picture(state, PlotIdle{}, dock);
    std::vector<Marker> rings = test::markers_of(list, MarkerShape::disc, 4.5F);
    std::erase_if(rings, [](const Marker& ring) { return ring.fill != dark().panel; });
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_NEAR(rings[0].center.x, x_from_parameter(layout, 1.0 / 3.0), 0.01);
    const auto squares = test::markers_of(list, MarkerShape::square, 4.0F);
    ASSERT_EQ(squares.size(), 2U);
    EXPECT_LT(squares[1].center.y, rings[0].center.y) << "the maximum is above zero, to the right";
    EXPECT_GT(squares[0].center.y, rings[0].center.y);
    const double y = 0.5 * (layout.graphs[0].lower_px.y + layout.graphs[0].upper_px.y);
    EXPECT_EQ(hit_plot(state, layout, {x_from_parameter(layout, 0.75), y}), Hover(HoveredParameter{}));
    EXPECT_EQ(hit_plot(state, layout, {x_from_parameter(layout, 0.5), y}), Hover(HoveredNothing{}));
}

TEST(PartsScene, ends_stand_on_the_axis_of_the_plot) {
    EditorState state = showing(zigzag(), {Overlay::equal_steps});
    state.view.shape.part_count = 6;
    const glm::dvec2 dock(1048.0, 260.0);
    const PlotLayout layout = plot_layout(state, dock);
    const auto dots = test::markers_of(test::plot_picture(state, PlotIdle{}, dock), MarkerShape::disc, 4.5F);
    ASSERT_EQ(dots.size(), 7U);
    for (std::size_t k = 0; k < 7; ++k) {
        EXPECT_NEAR(dots[k].center.x, x_from_parameter(layout, 0.5 * static_cast<double>(k)), 0.01);
        EXPECT_NEAR(dots[k].center.y, layout.bottom_px, 0.01);
    }
}

TEST(QuantityPlots, what_goes_to_a_pole_stays_in_its_box) {
    // (t^2, t^3) stands still at u = 1/2.
    EditorState state = showing(
        {.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}},
        {Overlay::curvature_plot});
    const glm::dvec2 dock(1048.0, 342.0);
    const PlotLayout layout = plot_layout(state, dock);
    for (const render::Polyline& graph :
         test::lines_of(test::plot_picture(state, PlotIdle{}, dock), dark().comb, 2.25F))
        for (const render::Pixel place : graph.points) {
            EXPECT_GE(place.y, layout.graphs[0].lower_px.y - 0.01);
            EXPECT_LE(place.y, layout.graphs[0].upper_px.y + 0.01);
        }
}

constexpr std::initializer_list<Overlay> all_of_them{
    Overlay::curvature_comb, Overlay::curvature_plot,  Overlay::speed_plot,  Overlay::osculating_circle,
    Overlay::tangent_normal, Overlay::curvature_marks, Overlay::equal_steps, Overlay::equal_lengths,
    Overlay::span_hulls,     Overlay::support,         Overlay::variation,   Overlay::polygon,
    Overlay::labels};

TEST(ShapeScene, worst_curves_have_finite_pictures) {
    std::vector<core::CurveDefinition> definitions{zigzag(), circle(1e-9), circle(1e9), test::closed_cubic()};
    core::CurveDefinition high{.degree = 25};
    for (int i = 0; i < 26; ++i) high.points.emplace_back(1e6 + std::sin(2.0 * i), 1e6 + std::cos(3.0 * i));
    high.knots.assign(26, 0.0);
    high.knots.insert(high.knots.end(), 26, 1.0);
    for (int i = 0; i < 26; ++i) high.weights.push_back(i % 2 == 0 ? 1.0 : 1e3);
    definitions.push_back(high);
    core::CurveDefinition still = zigzag();
    for (core::Point& point : still.points) point = {1, 1};
    definitions.push_back(still);
    definitions.push_back({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 1}}});
    core::CurveDefinition huge = zigzag();
    for (core::Point& point : huge.points) point = {1e300 * point.x, 1e300 * point.y};
    definitions.push_back(huge);
    for (const core::CurveDefinition& definition : definitions) {
        EditorState state = showing(definition, all_of_them);
        state.selection.points = {0};
        const core::Interval domain = state.active_curve()->domain();
        for (const double share : {0.0, 0.3, 0.5, 1.0}) {
            state.view.parameter = domain.lower + share * domain.length();
            expect_no_faults(state);
        }
    }
}

TEST(ShapeScene, ten_thousand_points_cost_a_bounded_picture) {
    core::CurveDefinition definition{.degree = 3};
    for (int i = 0; i < 10'000; ++i) definition.points.emplace_back(0.01 * i, i % 2);
    for (int i = 0; i < 10'004; ++i) definition.knots.push_back(i);
    EditorState state = showing(definition, all_of_them);
    state.selection.points = {5000};
    expect_no_faults(state);
    EXPECT_FALSE(is_searched_whole(*state.active_curve()));
    EXPECT_LT(test::canvas_picture(state).commands.size(), 20'000U);
    // Close enough, the bends in view are marked.
    state.view.camera.center = {50.0, 0.5};
    state.view.camera.scale = 1000.0;
    EXPECT_FALSE(test::markers_of(test::canvas_picture(state), MarkerShape::square, 5.0F).empty());
}

}  // namespace
}  // namespace batten::editor
