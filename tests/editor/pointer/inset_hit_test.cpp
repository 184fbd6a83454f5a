/// What is pointed at in an inset lights on the canvas, and the other way round.
#include "app/editor/pointer/inset_hit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/derived/lifted_stage.h"
#include "app/editor/pointer/highlight.h"
#include "app/editor/pointer/hit_test.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

EditorState showing(core::CurveDefinition definition, std::initializer_list<Overlay> shown) {
    EditorState state = test::scene_state(std::move(definition));
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    for (const Overlay overlay : shown) state.view.overlays.show(overlay, true);
    return state;
}

/// C' has the control points (3, 6), (6, 0), (3, -6), C'' (6, -12), (-6, -12).
EditorState cubic() {
    core::CurveDefinition definition;
    definition.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    definition.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    return showing(definition, {Overlay::polygon, Overlay::hodograph, Overlay::second_hodograph});
}

/// A quarter of the unit circle.
EditorState arc() {
    core::CurveDefinition definition;
    definition.degree = 2;
    definition.knots = {0, 0, 0, 1, 1, 1};
    definition.points = {{1, 0}, {1, 1}, {0, 1}};
    definition.weights = {1, std::sqrt(0.5), 1};
    return showing(definition, {Overlay::polygon, Overlay::homogeneous});
}

/// The places of the points of a hodograph, of which none is lit.
std::vector<glm::dvec2> places_in(const EditorState& state, Overlay inset) {
    const render::PixelBox box = inset_box(state, inset).value();
    std::vector<glm::dvec2> places;
    for (const render::Marker& disc : test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 2.75F))
        if (box.contains(disc.center)) places.emplace_back(disc.center);
    return places;
}

/// Where the marks of a hovered parameter are.
std::vector<glm::dvec2> marks_of(const EditorState& state) {
    std::vector<glm::dvec2> places;
    for (const render::Marker& disc : test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 4.0F))
        if (disc.outline == shown_theme(state.view).accent) places.emplace_back(disc.center);
    return places;
}

void expect_near(glm::dvec2 a, glm::dvec2 b) {
    EXPECT_LT(glm::distance(a, b), 0.02) << a.x << " " << a.y << " and " << b.x << " " << b.y;
}

using test::screen;

TEST(InsetHit, control_points_of_hodographs_are_differences_of_points) {
    EditorState state = cubic();
    const auto first = places_in(state, Overlay::hodograph);
    const auto second = places_in(state, Overlay::second_hodograph);
    ASSERT_EQ(first.size(), 3U);
    ASSERT_EQ(second.size(), 2U);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(hit_canvas(state, first[k]), (Hover{HoveredHodograph{1, k, {}}})) << k;
    EXPECT_EQ(hit_canvas(state, second[1]), (Hover{HoveredHodograph{2, 1, {}}}));
    state.hover = HoveredHodograph{1, 2, {}};
    EXPECT_EQ(highlight(state).points, (std::vector<std::size_t>{2, 3}));
    const auto leg = test::lines_of(test::canvas_picture(state), shown_theme(state.view).accent, 2.0F);
    ASSERT_EQ(leg.size(), 1U);
    expect_near(glm::dvec2(leg[0].points.front()), screen(state, {3, 2}));
    expect_near(glm::dvec2(leg[0].points.back()), screen(state, {4, 0}));
    state.hover = HoveredHodograph{2, 0, {}};
    EXPECT_EQ(highlight(state).points, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(InsetHit, a_place_of_a_hodograph_is_marked_on_the_curve_and_the_other_way_round) {
    EditorState state = cubic();
    const auto places = places_in(state, Overlay::hodograph);
    ASSERT_EQ(places.size(), 3U);
    // C'(1/4) = (33/8, 3): three eighths of the way from (3, 6) to (6, 0) across, half of it down.
    const glm::dvec2 place = places[0] + glm::dvec2(0.375, 0.5) * (places[1] - places[0]);
    const Hover hit = hit_canvas(state, place);
    ASSERT_TRUE(std::holds_alternative<HoveredHodograph>(hit));
    ASSERT_TRUE(hovered_u(hit).has_value());
    EXPECT_NEAR(*hovered_u(hit), 0.25, 1e-6);
    for (const Hover& hover : {hit, Hover{HoveredCurve{0.25}}}) {
        state.hover = hover;
        const auto marks = marks_of(state);
        ASSERT_EQ(marks.size(), 3U) << "on the curve and on both hodographs";
        // C(1/4) = 27/64 (1, 2) + 9/64 (3, 2) + 1/64 (4, 0)
        expect_near(marks[0], screen(state, {58.0 / 64.0, 72.0 / 64.0}));
        expect_near(marks[1], place);
    }
}

TEST(InsetHit, a_place_of_the_lifted_curve_or_of_its_shadow_is_marked_on_the_curve) {
    EditorState state = arc();
    const LiftedStage stage = lifted_stage(state, inset_box(state, Overlay::homogeneous).value());
    const double half = std::sqrt(0.5);
    // In the middle the weight is (1 + sqrt(1/2)) / 2.
    for (const double weight : {1.0, 0.5 * (1.0 + half)}) {
        const Hover hit = hit_canvas(state, stage.screen({half, half}, weight));
        ASSERT_TRUE(std::holds_alternative<HoveredLifted>(hit));
        EXPECT_FALSE(std::get<HoveredLifted>(hit).index.has_value());
        ASSERT_TRUE(hovered_u(hit).has_value()) << weight;
        EXPECT_NEAR(*hovered_u(hit), 0.5, 0.02) << weight;
    }
    state.hover = HoveredLifted{std::nullopt, 0.5};
    const auto marks = marks_of(state);
    ASSERT_EQ(marks.size(), 3U);
    expect_near(marks[0], screen(state, {half, half}));
    expect_near(marks[1], stage.screen({half, half}, 1.0));
    expect_near(marks[2], stage.screen({half, half}, 0.5 * (1.0 + half)));
}

TEST(InsetHit, of_a_periodic_curve_the_last_difference_closes_the_polygon) {
    core::CurveDefinition definition;
    definition.periodic = true;
    definition.knots = {0, 1, 2, 3, 4};
    definition.points = {{0, 0}, {2, 0}, {3, 2}, {-1, 1}};
    EditorState state = showing(definition, {Overlay::polygon, Overlay::hodograph});
    const auto places = places_in(state, Overlay::hodograph);
    ASSERT_GE(places.size(), 4U);
    // The differences are (2, 0), (1, 2), (-4, -1), (1, -1).
    expect_near(places[1] - places[0], (places[3] - places[0]) * glm::dvec2(1.0, -2.0));
    EXPECT_EQ(hit_canvas(state, places[3]), (Hover{HoveredHodograph{1, 3, {}}}));
    state.hover = HoveredHodograph{1, 3, {}};
    EXPECT_EQ(highlight(state).points, (std::vector<std::size_t>{0, 3}));
}

TEST(InsetHit, what_no_points_make_is_not_hit_and_a_long_curve_costs_nothing) {
    EditorState rational = arc();
    rational.view.overlays.show(Overlay::hodograph, true);
    for (const glm::dvec2 place : places_in(rational, Overlay::hodograph)) {
        const Hover hit = hit_canvas(rational, place);
        ASSERT_TRUE(std::holds_alternative<HoveredHodograph>(hit));
        EXPECT_FALSE(std::get<HoveredHodograph>(hit).index.has_value());
    }
    core::CurveDefinition longer;
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 3, 10000).value();
    longer.knots = {knots.values().begin(), knots.values().end()};
    longer.points = test::scattered_points(10000, {8.0, 4.0});
    const EditorState state = showing(longer, {Overlay::hodograph});
    const render::PixelBox box = inset_box(state, Overlay::hodograph).value();
    EXPECT_EQ(hit_canvas(state, 0.5 * (box.lower_px + box.upper_px)), (Hover{HoveredHodograph{1, {}, {}}}));
}

TEST(InsetHit, of_the_worst_curves_is_an_answer) {
    for (const double size : {0.0, 1e-300, 1e300}) {
        core::CurveDefinition definition;
        definition.knots = {0, 0, 0, 0, 1, 1, 1, 1};
        definition.points = {{0, 0}, {size, 2 * size}, {3 * size, 2 * size}, {4 * size, 0}};
        const EditorState state =
            showing(definition, {Overlay::hodograph, Overlay::second_hodograph, Overlay::homogeneous});
        for (const InsetPlace& inset : inset_places(state))
            for (const double share : {0.1, 0.5, 0.9}) {
                const Hover hit = hit_inset(state, inset, glm::mix(inset.box.lower_px, inset.box.upper_px, share));
                EXPECT_FALSE(std::holds_alternative<HoveredNothing>(hit));
                const double u = hovered_u(hit).value_or(0.5);
                EXPECT_TRUE(0.0 <= u && u <= 1.0) << u;
            }
    }
}

}  // namespace
}  // namespace batten::editor
