#include "app/editor/scene/plot_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/evaluate/basis.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Fill;
using render::Label;
using render::Marker;
using render::MarkerShape;
using render::Polyline;
using test::all_of;

using test::dock_size;

using test::dark;

/// The lines of graph i, whether it is dimmed or not.
std::vector<Polyline> graph(const render::DrawList& list, std::size_t i) {
    std::vector<Polyline> lines = test::lines_of(list, dark().point(i), 2.25F);
    for (const Polyline& line : test::lines_of(list, dark().resting_point(i), 1.25F)) lines.push_back(line);
    return lines;
}

EditorState with_knots(std::vector<double> knots) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = std::move(knots);
    return test::scene_state(definition);
}

EditorState with_many_knots() {
    core::CurveDefinition definition;
    definition.degree = 3;
    definition.knots = {0, 0, 0};
    for (int k = 0; k <= 200; ++k) definition.knots.push_back(k);
    definition.knots.insert(definition.knots.end(), {200, 200, 200});
    for (std::size_t i = 0; i + 4 < definition.knots.size(); ++i)
        definition.points.push_back({static_cast<double>(i), i % 2 == 0 ? 0.0 : 1.0});
    EditorState state = test::scene_state(definition);
    state.view.parameter = 100.5;
    return state;
}

TEST(PlotScene, graphs_are_true_to_a_quarter_of_a_pixel) {
    const EditorState state = test::sample_state();
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    for (std::size_t i = 0; i < 7; ++i)
        for (int k = 0; k <= 400; ++k) {
            const double u = k / 400.0;
            const double value = core::basis_function(state.active_curve()->knots(), i, u);
            if (value == 0.0) continue;
            const glm::dvec2 place{x_from_parameter(layout, u), y_from_value(layout, value)};
            EXPECT_LT(test::distance_to(graph(list, i), place), 0.25) << "N_" << i << "(" << u << ")";
        }
}

TEST(PlotScene, graphs_are_drawn_only_where_they_are_not_zero) {
    const EditorState state = test::sample_state();
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    const std::vector<core::Interval> supports{{0, .25}, {0, .5}, {0, .75}, {0, 1}, {.25, 1}, {.5, 1}, {.75, 1}};
    for (std::size_t i = 0; i < supports.size(); ++i) {
        const auto lines = graph(list, i);
        ASSERT_EQ(lines.size(), 1U) << i;
        EXPECT_NEAR(lines[0].points.front().x, x_from_parameter(layout, supports[i].lower), 1e-3);
        EXPECT_NEAR(lines[0].points.back().x, x_from_parameter(layout, supports[i].upper), 1e-3);
    }
}

TEST(PlotScene, graphs_need_few_segments) {
    std::size_t segments = 0;
    for (const Polyline& line : all_of<Polyline>(test::plot_picture(test::sample_state())))
        segments += line.points.size() - 1;
    EXPECT_LT(segments, 250U);
}

/// The values follow from the alphas 0.8, 8/15, 0.2 / 0.8, 0.3 / 0.6 of the worked example.
TEST(PlotScene, discs_stand_where_the_line_at_u_meets_the_graphs) {
    const EditorState state = test::sample_state();
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    const auto discs = test::markers_of(list, MarkerShape::disc, 4.0F);
    ASSERT_EQ(discs.size(), 4U);
    const std::vector<double> values{0.016, 0.4093333333333333, 0.5386666666666667, 0.036};
    for (std::size_t j = 0; j < values.size(); ++j) {
        EXPECT_NEAR(discs[j].center.x, x_from_parameter(layout, 0.4), 1e-3);
        EXPECT_NEAR(discs[j].center.y, y_from_value(layout, values[j]), 1e-3);
        EXPECT_EQ(discs[j].fill, dark().point(j + 1));
    }
    const auto line = test::lines_of(list, dark().parameter, 2.0F);
    ASSERT_EQ(line.size(), 1U);
    EXPECT_LT(line[0].points.front().y, layout.top_px);
    EXPECT_GT(line[0].points.back().y, layout.strip_px);
}

TEST(PlotScene, numbers_of_the_graphs_keep_clear_of_the_line_at_u) {
    EditorState state = test::sample_state();
    for (int k = 0; k <= 200; ++k) {
        state.view.parameter = k / 200.0;
        const double line = x_from_parameter(plot_layout(state, dock_size), state.parameter());
        std::size_t count = 0;
        for (const Label& label : all_of<Label>(test::plot_picture(state))) {
            if (label.font != render::LabelFont::bold || label.text.size() != 1) continue;
            ++count;
            const render::PixelBox box = test::box_of(label);
            EXPECT_TRUE(box.upper_px.x < line - 1.0 || box.lower_px.x > line + 1.0)
                << label.text << " at u = " << k / 200.0;
        }
        EXPECT_EQ(count, 7U) << k;
    }
}

TEST(PlotScene, texts_are_not_cut_by_the_edges) {
    EditorState state = test::sample_state();
    for (const glm::dvec2 picture : {dock_size, glm::dvec2(400.0, 160.0), glm::dvec2(250.0, 140.0)})
        for (const Label& label : all_of<Label>(test::plot_picture(state, PlotIdle{}, picture))) {
            const render::PixelBox box = test::box_of(label);
            EXPECT_GE(box.lower_px.x, -0.01) << label.text;
            EXPECT_LE(box.upper_px.x, picture.x + 0.01) << label.text;
        }
}

TEST(PlotScene, graphs_that_do_not_act_are_dimmed_and_lit_ones_thick) {
    EditorState state = test::sample_state();
    render::DrawList list = test::plot_picture(state);
    for (const std::size_t i : {1U, 2U, 3U, 4U})
        EXPECT_EQ(test::lines_of(list, dark().point(i), 2.25F).size(), 1U) << i;
    for (const std::size_t i : {0U, 5U, 6U}) EXPECT_TRUE(test::lines_of(list, dark().point(i), 2.25F).empty()) << i;
    state.hover = HoveredPoint{5};
    list = test::plot_picture(state);
    EXPECT_EQ(test::lines_of(list, dark().point(5), 3.5F).size(), 1U);
}

TEST(PlotScene, titles_tell_degree_parameter_and_speed) {
    EditorState state = test::sample_state();
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "Basis functions N_{i,3}(u)"));
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "u = 0.400"));
    state.view.playback.is_playing = true;
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "▶ 0.5× u = 0.400"));
}

TEST(PlotScene, functions_of_a_bezier_curve_are_bernstein_polynomials) {
    core::CurveDefinition definition{.degree = 2, .knots = {2, 2, 2, 5, 5, 5}, .points = {{0, 0}, {1, 2}, {2, 0}}};
    EXPECT_TRUE(test::has_text(test::plot_picture(test::scene_state(definition)), "Bernstein polynomials B_{i,2}(u)"));
    definition.knots = {2, 2, 2, 5, 5, 6};
    EXPECT_TRUE(test::has_text(test::plot_picture(test::scene_state(definition)), "Basis functions N_{i,2}(u)"));
}

TEST(PlotScene, titles_tell_what_is_dashed) {
    core::CurveDefinition definition{
        .degree = 2, .knots = {2, 2, 2, 5, 5, 5}, .points = {{0, 0}, {1, 2}, {2, 0}}, .weights = {1, 3, 1}};
    EditorState state = test::scene_state(definition);
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "Bernstein polynomials B_{i,2}(u)"));
    state.view.overlays.show(Overlay::rational_basis, true);
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "Bernstein polynomials B_{i,2}(u), dashed: R_{i,2}(u)"));
    definition.weights = {};
    state = test::scene_state(definition);
    state.view.overlays.show(Overlay::rational_basis, true);
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "Bernstein polynomials B_{i,2}(u)")) << "R is B";
}

TEST(PlotScene, knots_are_fractions_where_decimals_have_no_end) {
    EditorState state = with_knots({0, 0, 0, 0, 1.0 / 3.0, 0.5, 2.0 / 3.0, 1, 1, 1, 1});
    const render::DrawList list = test::plot_picture(state);
    for (const char* text : {"0", "1/3", "0.5", "2/3", "1"}) EXPECT_TRUE(test::has_text(list, text)) << text;
    state.view.notation.numbers = NumberStyle::decimals;
    EXPECT_TRUE(test::has_text(test::plot_picture(state), "0.3333"));
}

TEST(PlotScene, stack_has_as_many_diamonds_as_the_knot_is_multiple) {
    const EditorState state = with_knots({0, 0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1, 1});
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    int at_half = 0;
    int at_start = 0;
    for (const Marker& marker : all_of<Marker>(list)) {
        if (marker.shape != MarkerShape::diamond) continue;
        if (std::abs(marker.center.x - x_from_parameter(layout, 0.5)) < 1e-3) {
            ++at_half;
            EXPECT_EQ(marker.fill, dark().panel) << "hollow inside the domain";
        }
        if (std::abs(marker.center.x - x_from_parameter(layout, 0.0)) < 1e-3) {
            ++at_start;
            EXPECT_EQ(marker.fill, dark().dim);
        }
    }
    EXPECT_EQ(at_half, 2);
    EXPECT_EQ(at_start, 4);
    for (const char* text : {"0", "0.25", "0.5", "1", "×4 clamped", "C^{2}", "×2 C^{1}"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
}

TEST(PlotScene, full_multiplicity_says_so) {
    EXPECT_TRUE(test::has_text(test::plot_picture(with_knots({0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1})), "×3 C^{0}"));
}

TEST(PlotScene, dragged_knot_shows_what_would_become_of_it) {
    EditorState state = test::sample_state();
    core::Document moved = state.shown();
    moved.curves[0].curve = with_knots({0, 0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1, 1}).shown().curves[0].curve;
    EXPECT_FALSE(test::has_text(test::plot_picture(state), "×2 C^{1}"));
    state.preview = moved;
    const render::DrawList list = test::plot_picture(state, DraggingKnot{6, 0.0, 0.0, true}, dock_size);
    EXPECT_TRUE(test::has_text(list, "×2 C^{1}"));
    EXPECT_FALSE(test::has_text(list, "0.75"));
    int accented = 0;
    for (const Marker& marker : all_of<Marker>(list)) accented += marker.outline == dark().accent ? 1 : 0;
    EXPECT_EQ(accented, 2) << "both diamonds of the stack that the dragged knot joined";
}

TEST(PlotScene, knots_outside_of_the_domain_are_gray_and_the_plot_is_shaded) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EditorState state = test::scene_state(definition);
    state.view.parameter = 5.5;
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    int gray = 0;
    for (const Marker& marker : all_of<Marker>(list))
        gray += marker.shape == MarkerShape::diamond && marker.outline == dark().dim ? 1 : 0;
    EXPECT_EQ(gray, 6);
    const auto fills = all_of<Fill>(list);
    ASSERT_EQ(fills.size(), 3U) << "before, after, active span";
    EXPECT_NEAR(fills[0].points[0].x, x_from_parameter(layout, 0.0), 1e-3);
    EXPECT_NEAR(fills[0].points[2].x, x_from_parameter(layout, 3.0), 1e-3);
    EXPECT_NEAR(fills[2].points[0].x, x_from_parameter(layout, 5.0), 1e-3);
    EXPECT_NEAR(fills[2].points[2].x, x_from_parameter(layout, 6.0), 1e-3);
}

TEST(PlotScene, functions_of_a_uniform_vector_are_the_first_one_shifted) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = {0, 1, 2, 3, 4, 5, 6, 7};
    definition.points.resize(4);
    const EditorState state = test::scene_state(definition);
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    // u^3 / 6 and its mirror image, and (-3 t^3 + 3 t^2 + 3 t + 1) / 6 and its own.
    const std::vector<std::pair<double, double>> shape{{0.5, 1.0 / 48},  {1, 1.0 / 6}, {1.5, 23.0 / 48}, {2, 4.0 / 6},
                                                       {2.5, 23.0 / 48}, {3, 1.0 / 6}, {3.5, 1.0 / 48}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto lines = graph(list, i);
        ASSERT_EQ(lines.size(), 1U) << i;
        const auto shift = static_cast<double>(i);
        EXPECT_NEAR(lines[0].points.front().x, x_from_parameter(layout, shift), 1e-3);
        EXPECT_NEAR(lines[0].points.back().x, x_from_parameter(layout, shift + 4), 1e-3);
        for (const auto& [t, value] : shape)
            EXPECT_LT(test::distance_to(lines, {x_from_parameter(layout, shift + t), y_from_value(layout, value)}),
                      0.25)
                << i << " " << t;
    }
}

TEST(PlotScene, functions_beyond_the_domain_are_drawn_where_they_alone_are_seen) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EditorState state = test::scene_state(definition);
    state.view.plot_range = core::Interval{0.25, 1.5};
    const render::DrawList list = test::plot_picture(state);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(graph(list, i).size(), i < 2 ? 1U : 0U) << i;
}

TEST(PlotScene, functions_of_a_periodic_curve_go_on_at_the_start) {
    EditorState state = test::scene_state(test::closed_cubic());
    state.view.parameter = 2.5;
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    const auto lines = graph(list, 0);
    ASSERT_EQ(lines.size(), 2U) << "N_0 acts on [3, 6] and [0, 1]";
    EXPECT_NEAR(lines[0].points.front().x, x_from_parameter(layout, 0.0), 1e-3);
    EXPECT_NEAR(lines[0].points.back().x, x_from_parameter(layout, 1.0), 1e-3);
    EXPECT_NEAR(lines[1].points.front().x, x_from_parameter(layout, 3.0), 1e-3);
    EXPECT_NEAR(lines[1].points.back().x, x_from_parameter(layout, 6.0), 1e-3);
    EXPECT_NEAR(lines[0].points.front().y, lines[1].points.back().y, 1e-3);
    EXPECT_NEAR(lines[0].points.front().y, y_from_value(layout, 1.0 / 6.0), 1e-3);
}

TEST(PlotScene, zoomed_plot_stays_in_its_rectangle) {
    EditorState state = test::sample_state();
    state.view.plot_range = core::Interval{0.3, 0.45};
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = test::plot_picture(state);
    for (std::size_t i = 0; i < 7; ++i)
        for (const Polyline& line : graph(list, i))
            for (const render::Pixel place : line.points) {
                EXPECT_GE(place.x, layout.left_px - 1e-3);
                EXPECT_LE(place.x, layout.right_px + 1e-3);
                EXPECT_GE(place.y, layout.top_px - 1e-3);
                EXPECT_LE(place.y, layout.bottom_px + 1e-3);
            }
    EXPECT_TRUE(test::markers_of(list, MarkerShape::diamond, 8.0F).empty()) << "no knot between 0.3 and 0.45";
    state.view.plot_range = core::Interval{0.6, 0.7};
    EXPECT_TRUE(test::lines_of(test::plot_picture(state), dark().parameter, 2.0F).empty());
}

TEST(PlotScene, labels_never_cover_one_another) {
    EXPECT_EQ(test::overlapping_labels(test::plot_picture(test::sample_state())), std::vector<std::string>{});
    EditorState state = with_many_knots();
    EXPECT_EQ(test::overlapping_labels(test::plot_picture(state)), std::vector<std::string>{});
    state.view.plot_range = core::Interval{90.0, 110.0};
    EXPECT_EQ(test::overlapping_labels(test::plot_picture(state)), std::vector<std::string>{});
}

TEST(PlotScene, many_knots_stay_apart_and_are_all_named_when_zoomed) {
    EditorState state = with_many_knots();
    float largest = 0.0F;
    for (const Marker& marker : all_of<Marker>(test::plot_picture(state)))
        if (marker.shape == MarkerShape::diamond) largest = std::max(largest, marker.radius_px);
    EXPECT_LE(2.0F * largest, 984.0F / 200.0F);
    state.view.plot_range = core::Interval{90.0, 110.0};
    const render::DrawList list = test::plot_picture(state);
    for (int k = 90; k <= 110; ++k) EXPECT_TRUE(test::has_text(list, std::to_string(k))) << k;
    EXPECT_EQ(test::markers_of(list, MarkerShape::diamond, 8.0F).size(), 21U);
}

TEST(PlotScene, near_knots_are_told_apart_when_zoomed) {
    EditorState state = with_knots({0, 0, 0, 0, 0.5, 0.500001, 0.75, 1, 1, 1, 1});
    state.view.plot_range = core::Interval{0.499999, 0.500002};
    const render::DrawList list = test::plot_picture(state);
    EXPECT_TRUE(test::has_text(list, "0.5"));
    EXPECT_TRUE(test::has_text(list, "0.500001"));
}

TEST(PlotScene, sizes_follow_the_interface_scale) {
    const render::DrawList one = test::plot_picture(test::sample_state());
    const render::DrawList two = test::plot_picture(test::doubled(test::sample_state()), PlotIdle{}, 2.0 * dock_size);
    const auto small = all_of<Marker>(one);
    const auto large = all_of<Marker>(two);
    ASSERT_EQ(small.size(), large.size());
    for (std::size_t i = 0; i < small.size(); ++i) {
        EXPECT_FLOAT_EQ(large[i].radius_px, 2.0F * small[i].radius_px);
        EXPECT_NEAR(large[i].center.x, 2.0F * small[i].center.x, 1e-3);
        EXPECT_NEAR(large[i].center.y, 2.0F * small[i].center.y, 1e-3);
    }
    EXPECT_EQ(test::texts_of(one), test::texts_of(two));
}

TEST(PlotScene, is_empty_without_a_curve) {
    EXPECT_TRUE(test::plot_picture(EditorState()).commands.empty());
}

}  // namespace
}  // namespace batten::editor
