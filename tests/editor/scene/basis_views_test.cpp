/// The teaching views of the basis functions in the plot.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Fill;
using render::Label;
using render::Polyline;

using test::dock_size;

using test::dark;

EditorState shown(core::CurveDefinition definition, Overlay overlay, double u) {
    EditorState state = test::scene_state(std::move(definition));
    state.view.overlays.show(overlay, true);
    state.view.parameter = u;
    return state;
}

core::CurveDefinition uniform() {
    core::CurveDefinition definition;
    definition.degree = 3;
    definition.knots = {0, 1, 2, 3, 4, 5, 6, 7};
    definition.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    return definition;
}

core::CurveDefinition arc() {
    core::CurveDefinition definition;
    definition.degree = 2;
    definition.knots = {0, 0, 0, 1, 1, 1};
    definition.points = {{0, 0}, {1, 2}, {3, 2}};
    definition.weights = {1, 3, 1};
    return definition;
}

render::DrawList plot_of(const EditorState& state) {
    return test::plot_picture(state);
}

/// Whether a fill of this color covers the place.
bool is_filled(const render::DrawList& list, glm::dvec2 place, render::Color color) {
    for (const Fill& fill : test::all_of<Fill>(list)) {
        if (fill.color != color || fill.points.size() != 4) continue;
        const double left = fill.points[0].x;
        const double right = fill.points[3].x;
        if (place.x < left || place.x > right) continue;
        const double share = (place.x - left) / (right - left);
        const double bottom = fill.points[0].y + share * (fill.points[3].y - fill.points[0].y);
        const double top = fill.points[1].y + share * (fill.points[2].y - fill.points[1].y);
        if (top < place.y && place.y < bottom) return true;
    }
    return false;
}

}  // namespace

TEST(BasisViews, areas_are_stacked_to_one_in_the_domain_and_to_less_beyond) {
    const EditorState state = shown(uniform(), Overlay::basis_values, 3.5);
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = plot_of(state);
    const auto color = [](std::size_t i) { return render::blended(dark().point(i), 0.55, dark().panel); };
    const auto at = [&](double u, double value) {
        return glm::dvec2(x_from_parameter(layout, u), y_from_value(layout, value));
    };
    // At 3.3 the sums are 0.343/6, (0.343 + 3.541)/6 ...: (1 - t)^3 and 3 t^3 - 6 t^2 + 4 with t = 0.3.
    EXPECT_TRUE(is_filled(list, at(3.3, 0.03), color(0)));
    EXPECT_FALSE(is_filled(list, at(3.3, 0.08), color(0)));
    EXPECT_TRUE(is_filled(list, at(3.3, 0.08), color(1)));
    EXPECT_TRUE(is_filled(list, at(3.3, 0.62), color(1)));
    EXPECT_TRUE(is_filled(list, at(3.3, 0.68), color(2)));
    EXPECT_TRUE(is_filled(list, at(3.3, 0.98), color(2)));
    EXPECT_TRUE(is_filled(list, at(3.3, 0.998), color(3)));
    // Before the domain only N_0 = u^3 / 6 is there on [0, 1].
    EXPECT_TRUE(is_filled(list, at(0.9, 0.1), color(0)));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_FALSE(is_filled(list, at(0.9, 0.2), color(i)));
}

TEST(BasisViews, values_stand_on_the_line_at_u) {
    const render::DrawList list = plot_of(shown(uniform(), Overlay::basis_values, 3.5));
    EXPECT_TRUE(test::has_text(list, "N_{1,3} = 23/48"));
    EXPECT_TRUE(test::has_text(list, "N_{2,3} = 23/48"));
    EXPECT_FALSE(test::has_text(list, "N_{0,3} = 1/48")) << "too low for a text";
    EXPECT_TRUE(test::has_text(list, "sum 1"));
}

TEST(BasisViews, names_of_areas_stay_in_the_plot) {
    const EditorState state = shown(test::cubic(), Overlay::basis_values, 0.4);
    const PlotLayout layout = plot_layout(state, dock_size);
    std::size_t count = 0;
    for (const render::Label& label : test::all_of<render::Label>(plot_of(state))) {
        if (label.text != "N_{0,3}" && label.text != "N_{6,3}") continue;
        ++count;
        EXPECT_GE(test::box_of(label).lower_px.x, layout.left_px) << label.text;
        EXPECT_LE(test::box_of(label).upper_px.x, layout.right_px) << label.text;
    }
    EXPECT_EQ(count, 2U);
}

TEST(BasisViews, rational_functions_are_dashed_where_weights_differ) {
    EditorState state = shown(arc(), Overlay::rational_basis, 0.5);
    const PlotLayout layout = plot_layout(state, dock_size);
    std::vector<Polyline> dashed;
    for (const Polyline& line : test::all_of<Polyline>(plot_of(state)))
        if (line.dash_px == 6.0F && line.color == dark().point(1)) dashed.push_back(line);
    ASSERT_EQ(dashed.size(), 1U);
    // R_1 = 3/4 at 1/2, and 2 t (1 - t) 3 / (1 + 4 t (1 - t)) at 1/4: 9/14.
    EXPECT_LT(test::distance_to(dashed, {x_from_parameter(layout, 0.5), y_from_value(layout, 0.75)}), 0.3);
    EXPECT_LT(test::distance_to(dashed, {x_from_parameter(layout, 0.25), y_from_value(layout, 9.0 / 14)}), 0.3);
    core::CurveDefinition equal = arc();
    equal.weights = {};
    state = shown(equal, Overlay::rational_basis, 0.5);
    for (const Polyline& line : test::all_of<Polyline>(plot_of(state))) EXPECT_NE(line.dash_px, 6.0F);
}

TEST(BasisViews, pieces_have_colors_of_their_own) {
    EditorState state = shown(uniform(), Overlay::basis_pieces, 3.5);
    state.selection.points = {0};
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = plot_of(state);
    const std::vector<double> values{1.0 / 48, 23.0 / 48, 23.0 / 48};
    for (std::size_t n = 0; n < 3; ++n) {
        const double u = 0.5 + static_cast<double>(n);
        const glm::dvec2 place{x_from_parameter(layout, u), y_from_value(layout, values[n])};
        EXPECT_LT(test::distance_to(test::lines_of(list, dark().level(n + 1), 4.0F), place), 0.3) << n;
    }
    // The first polynomial, u^3 / 6, goes on to u = 1.6.
    const glm::dvec2 beyond{x_from_parameter(layout, 1.5), y_from_value(layout, 3.375 / 6)};
    EXPECT_LT(test::distance_to(test::lines_of(list, dark().level(1), 1.5F), beyond), 0.5);
}

TEST(BasisViews, a_cell_shows_its_functions_and_ramps) {
    EditorState state = shown(uniform(), Overlay::recurrence, 3.5);
    EXPECT_FALSE(test::has_text(plot_of(state), "N_{1,2}"));
    state.hover = HoveredBasisCell{1, 2};
    const PlotLayout layout = plot_layout(state, dock_size);
    const render::DrawList list = plot_of(state);
    for (const char* text : {"N_{1,2}", "N_{1,1}", "N_{2,1}",
                             "N_{1,2} = (u − u_{1})/(u_{3} − u_{1}) N_{1,1} + (u_{4} − u)/(u_{4} − u_{2}) N_{2,1}"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
    const auto at = [&](double u, double value) {
        return glm::dvec2(x_from_parameter(layout, u), y_from_value(layout, value));
    };
    const auto whole = test::lines_of(list, dark().point(1), 3.5F);
    EXPECT_LT(test::distance_to(whole, at(2.5, 0.75)), 0.3);
    EXPECT_LT(test::distance_to(whole, at(1.5, 0.125)), 0.3);
    EXPECT_LT(test::distance_to(test::lines_of(list, dark().point(1), 2.0F), at(1.5, 0.5)), 0.3);
    EXPECT_LT(test::distance_to(test::lines_of(list, dark().point(2), 2.0F), at(3.5, 0.5)), 0.3);
    EXPECT_LT(test::distance_to(test::lines_of(list, dark().point(1), 1.5F), at(2.5, 0.75)), 0.3) << "rises to 3";
    EXPECT_LT(test::distance_to(test::lines_of(list, dark().point(2), 1.5F), at(2.5, 0.75)), 0.3) << "falls to 4";
    for (const std::string& pair : test::overlapping_labels(list)) ADD_FAILURE() << pair;
}

TEST(BasisViews, a_ramp_between_equal_knots_is_not_drawn) {
    core::CurveDefinition definition = arc();
    definition.weights = {};
    EditorState state = shown(definition, Overlay::recurrence, 0.5);
    state.hover = HoveredBasisCell{0, 2};
    const render::DrawList list = plot_of(state);
    EXPECT_TRUE(test::lines_of(list, dark().point(0), 1.5F).empty());
    EXPECT_FALSE(test::lines_of(list, dark().point(1), 1.5F).empty());
    EXPECT_FALSE(test::has_text(list, "N_{0,1}")) << "it vanishes";
}

TEST(BasisViews, take_every_sort_of_curve) {
    std::vector<core::CurveDefinition> definitions{uniform(), arc()};
    core::CurveDefinition many;
    many.degree = 3;
    for (int k = 0; k < 10004; ++k) many.knots.push_back(1e6 + k);
    many.points.resize(10000);
    definitions.push_back(many);
    core::CurveDefinition high;
    high.degree = 25;
    for (int k = 0; k < 60; ++k) high.knots.push_back(k);
    high.points.resize(34);
    high.weights.assign(34, 1.0);
    high.weights[3] = 1e6;
    definitions.push_back(high);
    core::CurveDefinition closed;
    closed.degree = 2;
    closed.knots = {0, 1, 2};
    closed.points = {{0, 0}, {1, 0}};
    closed.periodic = true;
    definitions.push_back(closed);
    for (const core::CurveDefinition& definition : definitions) {
        EditorState state = test::scene_state(definition);
        const core::Interval domain = state.active_curve()->domain();
        for (const Overlay overlay :
             {Overlay::basis_values, Overlay::rational_basis, Overlay::basis_pieces, Overlay::recurrence})
            state.view.overlays.show(overlay, true);
        for (const double share : {0.0, 0.4, 1.0})
            for (const std::size_t k : {0U, 1U, 2U}) {
                state.view.parameter = domain.lower + share * domain.length();
                state.hover = HoveredBasisCell{2, k};
                const render::DrawList list = plot_of(state);
                EXPECT_LT(list.commands.size(), 20000U);
                const auto faults = test::faults_of(list, dock_size, 70.0);
                EXPECT_TRUE(faults.empty()) << faults.front();
            }
    }
}

}  // namespace batten::editor
