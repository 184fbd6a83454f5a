#include "app/editor/pointer/hit_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <random>

#include "app/editor/pointer/weight_ring.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

/// Degree 2 over 0,0,0,1,2,3,3,3; at 64 px a unit, (0, 0) at (640, 360). C(1) = (-1, 0), C(1.5) = (0, -1), C(2) = (1,
/// 0).
EditorState zigzag() {
    core::CurveDefinition definition;
    definition.degree = 2;
    definition.knots = {0, 0, 0, 1, 2, 3, 3, 3};
    definition.points = {{-4, -2}, {-2, 2}, {0, -2}, {2, 2}, {4, -2}};
    EditorState state = test::state_with(definition);
    state.view.parameter = 1.5;
    return state;
}

using test::px;

void hide(EditorState& state, Overlay overlay) {
    state.view.overlays.show(overlay, false);
}

TEST(HitCanvas, finds_a_point_within_nine_pixels) {
    const EditorState state = zigzag();
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(8.5, 0)), Hover{HoveredPoint{1}});
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(0, -9.5)), Hover{HoveredNothing{}});
}

TEST(HitCanvas, reaches_twice_as_far_at_twice_the_interface_scale) {
    EditorState state = zigzag();
    state.view.interface_scale = 2.0;
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(0, -17.5)), Hover{HoveredPoint{1}});
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(0, -18.5)), Hover{HoveredNothing{}});
}

TEST(HitCanvas, finds_the_point_of_the_parameter) {
    EXPECT_EQ(hit_canvas(zigzag(), px(0, -1) + glm::dvec2(0, 8.5)), Hover{HoveredParameter{}});
}

TEST(HitCanvas, prefers_a_point_to_a_parameter_at_the_same_place) {
    EditorState state = zigzag();
    state.view.parameter = 0.0;
    EXPECT_EQ(hit_canvas(state, px(-4, -2)), Hover{HoveredPoint{0}});
    hide(state, Overlay::polygon);
    EXPECT_EQ(hit_canvas(state, px(-4, -2)), Hover{HoveredParameter{}});
}

TEST(HitCanvas, finds_a_knot_by_the_topmost_of_its_stack) {
    EditorState state = zigzag();
    EXPECT_EQ(hit_canvas(state, px(-1, 0) + glm::dvec2(7.5, 0)), Hover{HoveredKnot{3}});
    hide(state, Overlay::polygon);
    state.view.parameter = 1.5;
    EXPECT_EQ(hit_canvas(state, px(-4, -2)), Hover{HoveredKnot{2}});
    hide(state, Overlay::knots);
    EXPECT_TRUE(std::holds_alternative<HoveredCurve>(hit_canvas(state, px(-1, 0))));
}

TEST(HitCanvas, finds_a_point_of_the_construction_within_seven_pixels) {
    // At u = 1.5 P_2^1 = (-1/2, -1) by 3/4, and P_3^1 = (1/2, -1) by 1/4.
    EditorState state = zigzag();
    EXPECT_EQ(hit_canvas(state, px(-0.5, -1) + glm::dvec2(0, 6.5)), (Hover{HoveredCell{1, 0}}));
    EXPECT_EQ(hit_canvas(state, px(0.5, -1) + glm::dvec2(0, 6.5)), (Hover{HoveredCell{1, 1}}));
    EXPECT_EQ(hit_canvas(state, px(0.5, -1) + glm::dvec2(4, 6.5)), Hover{HoveredNothing{}});
    state.view.level = 0;
    EXPECT_EQ(hit_canvas(state, px(0.5, -1)), Hover{HoveredLeg{2}});
    state.view.level.reset();
    hide(state, Overlay::construction);
    EXPECT_EQ(hit_canvas(state, px(0.5, -1)), Hover{HoveredLeg{2}});
}

TEST(HitCanvas, prefers_points_and_knots_to_the_construction) {
    EditorState state = zigzag();
    EXPECT_EQ(hit_canvas(state, px(-1, 0)), Hover{HoveredKnot{3}});
    state.view.parameter = 1.0;  // P_2^1 is C(u)
    EXPECT_EQ(hit_canvas(state, px(-1, 0)), Hover{HoveredParameter{}});
    state.view.parameter = 2.0 + 1e-9;  // P_3^1 is nearly the knot
    EXPECT_EQ(hit_canvas(state, px(2, 2)), Hover{HoveredPoint{3}});
}

/// The topmost knot of the domain whose place is nearest, within eight pixels, looked at one by one.
std::optional<std::size_t> knot_one_by_one(const EditorState& state, glm::dvec2 pointer_px) {
    const core::Curve& curve = *state.active_curve();
    const auto stored = curve.knots().stored();
    std::optional<std::size_t> found;
    double least = 8.0;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if ((i + 1 < stored.size() && stored[i] == stored[i + 1]) || !curve.domain().contains(stored[i])) continue;
        const core::Point place = core::point_at(curve, stored[i]);
        const double distance = glm::distance(pointer_px, render::screen_from_world(state.view.camera, place));
        if (distance > least || (found && distance == least)) continue;
        least = distance;
        found = i;
    }
    return found;
}

TEST(HitCanvas, finds_the_same_knots_as_looking_at_all_of_them) {
    core::CurveDefinition torn{.degree = 2, .tears = core::Tears::allow};
    torn.knots = {0, 0, 1, 1, 2, 2, 2, 3, 4, 5};
    torn.points = {{-4, -2}, {-3, 2}, {-2, -2}, {-1, 2}, {1, -2}, {3, 2}, {4, 1}};
    for (const core::CurveDefinition& definition : {torn, test::closed_cubic()}) {
        EditorState state = test::state_with(definition);
        hide(state, Overlay::polygon);
        state.view.parameter = state.active_curve()->domain().lower;
        int found = 0;
        for (double x = -5.0; x < 5.0; x += 0.05)
            for (double y = -3.0; y < 3.0; y += 0.05) {
                const Hover hit = hit_canvas(state, px(x, y));
                if (hit == Hover{HoveredParameter{}}) continue;
                const auto* knot = std::get_if<HoveredKnot>(&hit);
                const auto expected = knot_one_by_one(state, px(x, y));
                ASSERT_EQ(knot == nullptr ? std::nullopt : std::optional(knot->index), expected) << x << " " << y;
                found += expected ? 1 : 0;
            }
        EXPECT_GT(found, 30);
    }
}

TEST(HitCanvas, finds_the_curve_and_the_parameter_there) {
    EditorState state = zigzag();
    const core::Point at = core::point_at(*state.active_curve(), 0.5);
    const Hover hit = hit_canvas(state, px(at.x, at.y));
    ASSERT_TRUE(std::holds_alternative<HoveredCurve>(hit));
    EXPECT_NEAR(std::get<HoveredCurve>(hit).u, 0.5, 1e-9);
}

TEST(HitCanvas, finds_a_leg_within_five_pixels) {
    const EditorState state = zigzag();
    // The leg from (-4, -2) to (-2, 2) at a quarter, then across it: (2, -1)/sqrt(5) is its normal to the right, in the
    // world.
    const glm::dvec2 across = glm::dvec2(2.0, 1.0) / std::sqrt(5.0);
    EXPECT_EQ(hit_canvas(state, px(-3, 0) - 4.5 * across), Hover{HoveredLeg{0}});
    EXPECT_EQ(hit_canvas(state, px(-3, 0) - 5.5 * across), Hover{HoveredNothing{}});
}

TEST(HitCanvas, finds_the_closing_leg_of_a_periodic_curve) {
    EditorState state = test::state_with(test::closed_cubic());
    state.view.parameter = 3.0;
    EXPECT_EQ(hit_canvas(state, px(1.9, -0.2)), Hover{HoveredLeg{5}});
}

TEST(HitCanvas, finds_a_weight_ring_outside_its_point) {
    EditorState state = zigzag();
    EXPECT_FALSE(weight_ring_radius_px(1.0, 1.0));
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(0, -12)), Hover{HoveredNothing{}});
    state.selection.points = {1};
    const double radius = weight_ring_radius_px(state, 1).value();
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(0, -radius - 3.5)), Hover{HoveredWeightRing{1}});
    EXPECT_EQ(hit_canvas(state, px(-2, 2) + glm::dvec2(0, -radius - 4.5)), Hover{HoveredNothing{}});
}

TEST(HitCanvas, finds_other_curves_that_are_visible) {
    EditorState state = zigzag();
    core::Document document = state.history.present();
    document.curves.push_back(document.curves.front());
    core::CurveDefinition line;
    line.degree = 1;
    line.knots = {0, 0, 1, 1};
    line.points = {{-4, 4}, {4, 4}};
    document.curves[1].curve = std::make_shared<const core::Curve>(core::Curve::make(line).value());
    state.history = History(document);
    EXPECT_EQ(hit_canvas(state, px(1, 4) + glm::dvec2(0, 5)), Hover{HoveredOtherCurve{1}});
    EXPECT_EQ(hit_canvas(state, px(1, 4) + glm::dvec2(0, 7)), Hover{HoveredNothing{}});
    document.curves[1].visible = false;
    state.history = History(document);
    EXPECT_EQ(hit_canvas(state, px(1, 4)), Hover{HoveredNothing{}});
}

TEST(HitCanvas, finds_nothing_of_a_hidden_curve) {
    EditorState state = zigzag();
    core::Document document = state.history.present();
    document.curves[0].visible = false;
    state.history = History(document);
    EXPECT_EQ(hit_canvas(state, px(-2, 2)), Hover{HoveredNothing{}});
    EXPECT_EQ(hit_canvas(EditorState(), px(0, 0)), Hover{HoveredNothing{}});
}

TEST(HitCanvas, is_exact_over_twelve_decades_of_zoom) {
    EditorState state = zigzag();
    hide(state, Overlay::polygon);
    hide(state, Overlay::knots);
    const core::Point at = core::point_at(*state.active_curve(), 0.5);
    state.view.camera.center = at;
    for (double scale = 64.0; scale <= 1e12; scale *= 10.0) {
        state.view.camera.scale = scale;
        const Hover hit = hit_canvas(state, {640.0, 362.0});
        ASSERT_TRUE(std::holds_alternative<HoveredCurve>(hit)) << scale;
        EXPECT_NEAR(std::get<HoveredCurve>(hit).u, 0.5, 3.0 / scale) << scale;
        EXPECT_EQ(hit_canvas(state, {640.0, 380.0}), Hover{HoveredNothing{}}) << scale;
    }
}

TEST(WeightRing, grows_with_the_weight_between_nine_and_twenty_two_pixels) {
    double last = 9.0;
    for (const double weight : {1e-6, 0.01, 0.1, 0.5, 2.0, 10.0, 100.0}) {
        const double radius = weight_ring_radius_px(weight, 1.0).value();
        EXPECT_GT(radius, last);
        last = radius;
    }
    EXPECT_DOUBLE_EQ(last, 22.0);
    EXPECT_DOUBLE_EQ(weight_ring_radius_px(1e6, 1.0).value(), 22.0);
    EXPECT_DOUBLE_EQ(weight_ring_radius_px(100.0, 1.5).value(), 33.0);
}

/// What lies under the pointer by a look at everything; the knots hidden.
Hover hit_by_looking_at_all(const EditorState& state, glm::dvec2 position) {
    const core::Curve& curve = *state.active_curve();
    const auto away = [&](core::Point point) {
        return glm::distance(position, render::screen_from_world(state.view.camera, point));
    };
    const auto points = curve.control_points();
    const auto nearest = std::ranges::min_element(points, {}, away);
    const double to_parameter = away(core::point_at(curve, state.parameter()));
    if (away(*nearest) <= std::min(9.0, to_parameter))
        return HoveredPoint{static_cast<std::size_t>(nearest - points.begin())};
    if (to_parameter <= 9.0) return HoveredParameter{};
    const auto on_curve =
        core::nearest_point(curve, core::Point(render::world_from_screen(state.view.camera, position)));
    if (away(on_curve.point) <= 6.0) return HoveredCurve{on_curve.u};
    return HoveredNothing{};
}

TEST(HitCanvas, finds_among_thousands_what_a_look_at_all_finds) {
    std::mt19937 engine(9);
    std::uniform_real_distribution<double> step(-0.6, 0.6);
    core::CurveDefinition definition;
    definition.knots.assign(4, 0.0);
    core::Point at(0.0, 0.0);
    for (int i = 0; i < 1000; ++i) {
        const double x = step(engine);
        definition.points.push_back(at = at + core::Vector(x, step(engine)));
        if (i > 3) definition.knots.push_back(i - 3);
    }
    definition.knots.insert(definition.knots.end(), 4, 997.0);
    EditorState state = test::state_with(definition);
    hide(state, Overlay::knots);
    std::uniform_real_distribution<double> x_of(0.0, 1280.0);
    std::uniform_real_distribution<double> y_of(0.0, 720.0);
    std::array<int, 3> found{};
    for (int i = 0; i < 300; ++i) {
        const double x = x_of(engine);
        const glm::dvec2 position(x, y_of(engine));
        const Hover hit = hit_canvas(state, position);
        const Hover expected = hit_by_looking_at_all(state, position);
        if (std::holds_alternative<HoveredLeg>(hit)) continue;
        const auto* on_curve = std::get_if<HoveredCurve>(&expected);
        ++found.at(on_curve != nullptr ? 0U : std::holds_alternative<HoveredPoint>(expected) ? 1U : 2U);
        if (on_curve == nullptr) {
            EXPECT_EQ(hit, expected);
        } else {
            ASSERT_TRUE(std::holds_alternative<HoveredCurve>(hit));
            EXPECT_NEAR(std::get<HoveredCurve>(hit).u, on_curve->u, 1e-9);
        }
    }
    for (const int count : found) EXPECT_GT(count, 5);
}

/// The dock of the cubic example: 1048 x 260, u = 0.4, one domain from x = 32 to 1016.
class HitPlot : public testing::Test {
  protected:
    Hover hit(double x, double y) const { return hit_plot(state, plot_layout(state, {1048.0, 260.0}), {x, y}); }

    EditorState state = [] {
        EditorState result = test::state_with(test::cubic());
        result.view.parameter = 0.4;
        return result;
    }();
};

TEST_F(HitPlot, finds_knots_on_the_strip) {
    EXPECT_EQ(hit(278, 206), Hover{HoveredKnot{4}});
    EXPECT_EQ(hit(285.5, 206), Hover{HoveredKnot{4}});
    EXPECT_EQ(hit(287, 206), Hover{HoveredSpan{4}});
}

TEST_F(HitPlot, gives_the_topmost_knot_for_any_of_a_stack) {
    EXPECT_EQ(hit(32, 206), Hover{HoveredKnot{3}});
    EXPECT_EQ(hit(32, 176), Hover{HoveredKnot{3}});
    EXPECT_EQ(hit(1016, 186), Hover{HoveredKnot{10}});
}

TEST_F(HitPlot, prefers_a_knot_to_the_line_on_the_strip_and_the_line_above) {
    state.view.parameter = 0.25;
    EXPECT_EQ(hit(278, 206), Hover{HoveredKnot{4}});
    EXPECT_EQ(hit(278, 130), Hover{HoveredParameter{}});
    EXPECT_EQ(hit(284, 100), Hover{HoveredNothing{}});
}

TEST_F(HitPlot, finds_the_graph_nearest_to_the_pointer) {
    // At u = 1/2 the functions 2, 3, 4 are 1/6, 2/3, 1/6 and N_3 has its top: y = 152 - 72.
    EXPECT_EQ(hit(524, 80), Hover{HoveredBasis{3}});
    EXPECT_EQ(hit(524, 85), Hover{HoveredBasis{3}});
    EXPECT_EQ(hit(524, 90), Hover{HoveredNothing{}});
    // N_0 falls from 1 at u = 0 as (1 - 4u)^3: at 1/16 it is 27/64.
    EXPECT_EQ(hit(32.0 + 984.0 / 16.0, 152.0 - 108.0 * 27.0 / 64.0), Hover{HoveredBasis{0}});
}

TEST_F(HitPlot, finds_the_span_on_the_strip) {
    EXPECT_EQ(hit(130, 206), Hover{HoveredSpan{3}});
    EXPECT_EQ(hit(900, 212), Hover{HoveredSpan{6}});
    EXPECT_EQ(hit(900, 240), Hover{HoveredNothing{}});
    EXPECT_EQ(hit(10, 206), Hover{HoveredNothing{}});
}

TEST_F(HitPlot, numbers_the_graphs_of_a_periodic_curve_as_its_points) {
    state = test::state_with(test::closed_cubic());
    state.view.parameter = 2.5;
    // N_0 has its middle knot at -1, which is 5: value 2/3.
    EXPECT_EQ(hit(32.0 + 984.0 * 5.0 / 6.0, 80), Hover{HoveredBasis{0}});
}

TEST_F(HitPlot, finds_graphs_beyond_the_domain) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = {0, 1, 2, 3, 4, 5, 6, 7};
    definition.points.resize(4);
    state = test::state_with(definition);
    // Each has its top, 2/3, at its middle knot: y = 152 - 72; N_3 outside the domain [3, 4].
    EXPECT_EQ(hit(32.0 + 984.0 * 2.0 / 7.0, 80), Hover{HoveredBasis{0}});
    EXPECT_EQ(hit(32.0 + 984.0 * 5.0 / 7.0, 80), Hover{HoveredBasis{3}});
    EXPECT_EQ(hit(32.0 + 984.0 * 6.99 / 7.0, 100), Hover{HoveredNothing{}});
}

TEST_F(HitPlot, finds_the_area_where_functions_are_stacked) {
    state.view.overlays.show(Overlay::basis_values, true);
    // At u = 1/2 the sums are 1/6, 5/6, 1 of functions 2, 3, 4.
    const auto at_value = [&](double value) { return hit(524, 152.0 - 108.0 * value); };
    EXPECT_EQ(at_value(0.1), Hover{HoveredBasis{2}});
    EXPECT_EQ(at_value(0.2), Hover{HoveredBasis{3}});
    EXPECT_EQ(at_value(0.8), Hover{HoveredBasis{3}});
    EXPECT_EQ(at_value(0.9), Hover{HoveredBasis{4}});
    EXPECT_EQ(at_value(1.05), Hover{HoveredNothing{}});
}

TEST_F(HitPlot, finds_nothing_without_a_curve) {
    state = EditorState();
    EXPECT_EQ(hit(278, 206), Hover{HoveredNothing{}});
}

}  // namespace
}  // namespace batten::editor
