/// Derivatives on the canvas: at joints, at ends, and as hodographs.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/scene/insets.h"
#include "app/editor/words/formula.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using test::all_of;

using test::dark;

EditorState showing(core::CurveDefinition definition, std::initializer_list<Overlay> shown) {
    EditorState state = test::scene_state(std::move(definition));
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    for (const Overlay overlay : shown) state.view.overlays.show(overlay, true);
    return state;
}

core::CurveDefinition two_cubics(double size = 1.0) {
    core::CurveDefinition definition;
    definition.knots = {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1};
    for (const core::Point point : std::vector<core::Point>{{-3, 0}, {-2, 2}, {-1, 1}, {0, 1}, {2, 1}, {3, 3}, {4, 0}})
        definition.points.push_back(core::tip_of(size * core::vector_to(point)));
    return definition;
}

// The tips of arrows of this color: the first corners of their heads.
std::vector<glm::dvec2> tips_of(const render::DrawList& list, render::Color color) {
    std::vector<glm::dvec2> tips;
    for (const render::Fill& fill : all_of<render::Fill>(list))
        if (fill.color == color && fill.points.size() == 3) tips.emplace_back(fill.points.front());
    return tips;
}

void expect_near(glm::dvec2 a, glm::dvec2 b) {
    EXPECT_LT(glm::distance(a, b), 0.01) << a.x << " " << a.y << " and " << b.x << " " << b.y;
}

TEST(ContinuityMarks, are_the_derivatives_before_and_behind_the_knot) {
    const EditorState state = showing(two_cubics(), {Overlay::continuity});
    const auto screen = [&](core::Point world) { return render::screen_from_world(state.view.camera, world); };
    const render::DrawList list = test::canvas_picture(state);
    // Four spans of 1/4 on average, so velocities are drawn by 1/12: (1/2, 0) arrives, (1, 0) leaves.
    const auto before = tips_of(list, dark().error);
    const auto behind = tips_of(list, dark().comb);
    ASSERT_EQ(before.size(), 2U);
    ASSERT_EQ(behind.size(), 2U);
    expect_near(before[0], screen({0, 1}));
    expect_near(behind[0], screen({1, 1}));
    const auto tails = test::lines_of(list, dark().error, 2.5F);
    ASSERT_EQ(tails.size(), 1U);
    expect_near(tails[0].points.front(), screen({-0.5, 1}));
    // And accelerations by 1/12^2 3/2: (0, 24) and (-24, 48).
    expect_near(before[1], screen({0, 1.25}));
    expect_near(behind[1], screen({-0.25, 1.5}));
    EXPECT_TRUE(test::has_text(list, "C⁰ by its knots, G¹ by its shape"));
    EXPECT_TRUE(test::has_text(list, "C′(u−)"));
}

TEST(ContinuityMarks, stay_in_proportion_and_in_the_picture_however_fast_the_curve_is) {
    EditorState state = showing(two_cubics(), {Overlay::continuity});
    state.view.camera.scale = 1e4;
    state.view.camera.center = {0.0, 1.0};
    const auto knot = render::screen_from_world(state.view.camera, {0, 1});
    const render::DrawList list = test::canvas_picture(state);
    const auto behind = tips_of(list, dark().comb);
    ASSERT_EQ(behind.size(), 2U);
    expect_near(behind[0], knot + glm::dvec2(180.0, 0.0));
    expect_near(test::lines_of(list, dark().error, 2.5F)[0].points.front(), knot - glm::dvec2(90.0, 0.0));
}

TEST(ContinuityMarks, show_the_gap_of_a_tear) {
    core::CurveDefinition torn;
    torn.degree = 1;
    torn.knots = {0, 0, 1, 1, 2, 2};
    torn.points = {{-2, 0}, {0, 0}, {0, 2}, {2, 2}};
    torn.tears = core::Tears::allow;
    const EditorState state = showing(torn, {Overlay::continuity});
    const auto gaps = test::lines_of(test::canvas_picture(state), dark().text, 1.5F);
    ASSERT_EQ(gaps.size(), 1U);
    expect_near(gaps[0].points.front(), render::screen_from_world(state.view.camera, {0, 0}));
    expect_near(gaps[0].points.back(), render::screen_from_world(state.view.camera, {0, 2}));
}

TEST(EndMarks, are_velocities_along_the_legs) {
    core::CurveDefinition cubic;
    cubic.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    cubic.points = {{-3, 0}, {-2, 1}, {1, 2}, {3, 0}};
    EditorState state = showing(cubic, {Overlay::end_derivatives});
    state.view.camera.scale = 40.0;
    const auto screen = [&](core::Point world) { return render::screen_from_world(state.view.camera, world); };
    // Legs, and second differences (2, 0) and (-1, -3).
    const auto tips = tips_of(test::canvas_picture(state), dark().comb);
    ASSERT_EQ(tips.size(), 4U);
    expect_near(tips[0], screen({-2, 1}));
    expect_near(tips[1], screen({-1, 0}));
    expect_near(tips[2], screen({5, -2}));
    expect_near(tips[3], screen({2, -3}));
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "C′(0)"));
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "C″(1)"));
}

core::CurveDefinition cubic_of_known_hodographs() {
    core::CurveDefinition cubic;
    cubic.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    cubic.points = {{0, 0}, {1, 0}, {2, 1}, {2, 2}};
    return cubic;
}

std::vector<render::Marker> polygon_points_of(const render::DrawList& list) {
    auto discs = test::markers_of(list, render::MarkerShape::disc, 2.75F);
    std::erase_if(discs, [](const render::Marker& disc) { return disc.fill != dark().polygon; });
    return discs;
}

TEST(Hodographs, have_their_control_polygons) {
    // 3 (1, 0), 3 (1, 1), 3 (0, 1): the second is right above the first.
    const auto first =
        polygon_points_of(test::canvas_picture(showing(cubic_of_known_hodographs(), {Overlay::hodograph})));
    ASSERT_EQ(first.size(), 3U);
    EXPECT_NEAR(first[0].center.x, first[1].center.x, 1e-3);
    EXPECT_NEAR(first[1].center.y, first[2].center.y, 1e-3);
    EXPECT_LT(first[1].center.y, first[0].center.y);
    EXPECT_LT(first[2].center.x, first[1].center.x);
    // 6 (0, 1) and 6 (-1, 0).
    const auto second =
        polygon_points_of(test::canvas_picture(showing(cubic_of_known_hodographs(), {Overlay::second_hodograph})));
    ASSERT_EQ(second.size(), 2U);
    EXPECT_LT(second[0].center.y, second[1].center.y);
    EXPECT_LT(second[1].center.x, second[0].center.x);
}

TEST(Hodographs, stand_in_boxes_of_their_own) {
    const EditorState state = showing(cubic_of_known_hodographs(), {Overlay::hodograph, Overlay::second_hodograph});
    const auto first = inset_box(state, Overlay::hodograph);
    const auto second = inset_box(state, Overlay::second_hodograph);
    ASSERT_TRUE(first && second);
    EXPECT_FALSE(first->overlaps(*second));
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(test::has_text(list, "C′(u) and its polygon"));
    EXPECT_TRUE(test::has_text(list, "C″(u) and its polygon"));
    EXPECT_EQ(polygon_points_of(list).size(), 5U);
    for (const render::Marker& point : polygon_points_of(list))
        EXPECT_TRUE(first->contains(point.center) || second->contains(point.center));
}

TEST(Hodographs, light_the_control_point_of_the_hovered_leg) {
    EditorState state = showing(cubic_of_known_hodographs(), {Overlay::hodograph});
    state.hover = HoveredLeg{1};
    auto lit = test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 4.5F);
    std::erase_if(lit, [](const render::Marker& disc) { return disc.fill != dark().accent; });
    ASSERT_EQ(lit.size(), 1U);
    EXPECT_EQ(polygon_points_of(test::canvas_picture(state)).size(), 2U);
}

TEST(Hodographs, break_their_polygons_at_tears) {
    // The derivative jumps at 1/2, where two cubics meet.
    const render::DrawList list = test::canvas_picture(showing(two_cubics(), {Overlay::hodograph}));
    const auto legs = test::lines_of(list, dark().polygon, 1.0F);
    ASSERT_EQ(legs.size(), 2U);
    EXPECT_EQ(legs[0].points.size(), 3U);
    EXPECT_EQ(legs[1].points.size(), 3U);
}

TEST(Hodographs, of_rational_curves_say_their_degree_and_of_long_ones_leave_the_polygon_out) {
    core::CurveDefinition rational = cubic_of_known_hodographs();
    rational.weights = {1, 2, 1, 1};
    EXPECT_TRUE(
        test::has_text(test::canvas_picture(showing(rational, {Overlay::hodograph})), "C′(u), rational, degree 6"));
    EXPECT_TRUE(test::has_text(test::canvas_picture(showing(rational, {Overlay::second_hodograph})),
                               "C″(u), rational, degree 9"));
    core::CurveDefinition longer;
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 3, 1000).value();
    longer.knots = {knots.values().begin(), knots.values().end()};
    longer.points = test::scattered_points(1000, {8.0, 4.0});
    const render::DrawList list = test::canvas_picture(showing(longer, {Overlay::second_hodograph}));
    EXPECT_TRUE(test::has_text(list, "C″(u) without its polygon"));
    EXPECT_TRUE(polygon_points_of(list).empty());
    const auto many = core::make_knots(core::KnotKind::clamped_uniform, 3, 24003).value();
    longer.knots = {many.values().begin(), many.values().end()};
    longer.points = test::scattered_points(24003, {8.0, 4.0});
    EXPECT_TRUE(test::has_text(test::canvas_picture(showing(longer, {Overlay::second_hodograph})),
                               "C″(u) on 1847 of 24000 spans"));
    longer.weights.assign(24003, 1.0);
    longer.weights[1] = 2.0;
    EXPECT_TRUE(
        test::has_text(test::canvas_picture(showing(longer, {Overlay::hodograph})), "C′(u) on 1847 of 24000 spans"));
}

TEST(Derivatives, of_the_worst_curves_are_drawn_without_fault) {
    std::vector<core::CurveDefinition> worst{two_cubics(1e-300), two_cubics(1e300), two_cubics(0.0)};
    core::CurveDefinition steep = two_cubics();
    steep.knots = {0, 0, 0, 0, 1e-300, 1e-300, 1e-300, 1, 1, 1, 1};
    worst.push_back(steep);
    core::CurveDefinition far = two_cubics();
    for (core::Point& point : far.points) point += core::Vector{1e6, 1e6};
    far.weights = {1, 1e3, 1, 1e-3, 1, 1e3, 1};
    worst.push_back(far);
    core::CurveDefinition high;
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 25, 200).value();
    high.degree = 25;
    high.knots = {knots.values().begin(), knots.values().end()};
    high.points = test::scattered_points(200, {8.0, 4.0});
    worst.push_back(high);
    high.weights.assign(200, 1.0);
    high.weights[70] = 1e3;
    worst.push_back(high);
    core::CurveDefinition line;
    line.degree = 1;
    line.knots = {0, 0, 1, 2, 2};
    line.points = {{0, 0}, {1, 1}, {2, 0}};
    worst.push_back(line);
    for (const core::CurveDefinition& definition : worst) {
        const EditorState state = showing(definition, {Overlay::continuity, Overlay::end_derivatives,
                                                       Overlay::hodograph, Overlay::second_hodograph, Overlay::labels});
        EXPECT_EQ(test::faults_of(test::canvas_picture(state), state.view.camera.size_px, 80.0),
                  std::vector<std::string>{})
            << definition.degree;
    }
}

TEST(HodographScene, titles_stay_in_their_insets) {
    EditorState state =
        showing(two_cubics(), {Overlay::hodograph, Overlay::second_hodograph, Overlay::homogeneous, Overlay::labels});
    for (const double width : {528.0, 1048.0}) {
        state.view.camera.size_px = {width, 338.0};
        const render::DrawList list = test::canvas_picture(state);
        EXPECT_EQ(test::has_text(list, "C″(u) and its polygon"), width > 1000.0);
        for (const render::Label& label : all_of<render::Label>(list)) {
            if (!label.text.starts_with("C′(u)") && !label.text.starts_with("C″(u)")) continue;
            const auto place = inset_at(state, glm::dvec2(label.position));
            ASSERT_TRUE(place) << label.text;
            EXPECT_LE(test::box_of(label).upper_px.x, place->box.upper_px.x) << label.text << " " << width;
        }
    }
}

}  // namespace
}  // namespace batten::editor
