
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/cards/floating_cards.h"
#include "app/editor/pointer/transform_box.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
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

using test::screen;

double distance(render::Pixel a, glm::dvec2 b) {
    return glm::distance(glm::dvec2(a), b);
}

using test::dark;

void show_only(EditorState& state, std::initializer_list<Overlay> shown) {
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), false);
    for (const Overlay overlay : shown) state.view.overlays.show(overlay, true);
}

void expect_markers(const std::vector<Marker>& markers, const EditorState& state,
                    const std::vector<core::Point>& places) {
    ASSERT_EQ(markers.size(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT(distance(markers[i].center, screen(state, places[i])), 1e-3) << i;
}

std::vector<Marker> discs_of_color(const render::DrawList& list, render::Color color, float radius_px) {
    std::vector<Marker> discs = test::markers_of(list, MarkerShape::disc, radius_px);
    std::erase_if(discs, [&](const Marker& disc) { return disc.fill != color; });
    return discs;
}

TEST(CanvasScene, curve_is_true_to_a_quarter_of_a_pixel) {
    for (const double scale : {66.0, 900.0, 5000.0}) {
        EditorState state = test::sample_state();
        state.view.camera.scale = scale;
        state.view.camera.center = core::point_at(*state.active_curve(), 0.4);
        const auto lines = test::lines_of(test::canvas_picture(state), dark().curve, 3.0F);
        const glm::dvec2 size = state.view.camera.size_px;
        int seen = 0;
        for (int k = 0; k <= 2000; ++k) {
            const glm::dvec2 place = screen(state, core::point_at(*state.active_curve(), k / 2000.0));
            if (place.x < 0.0 || place.y < 0.0 || place.x > size.x || place.y > size.y) continue;
            ++seen;
            EXPECT_LT(test::distance_to(lines, place), 0.251) << "u = " << k / 2000.0 << ", scale " << scale;
        }
        EXPECT_GT(seen, 10);
    }
}

TEST(CanvasScene, active_span_begins_and_ends_at_its_knots) {
    const EditorState state = test::sample_state();
    const auto lines = test::lines_of(test::canvas_picture(state), dark().accent, 4.0F);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LT(distance(lines[0].points.front(), screen(state, core::point_at(*state.active_curve(), 0.25))), 0.01);
    EXPECT_LT(distance(lines[0].points.back(), screen(state, core::point_at(*state.active_curve(), 0.5))), 0.01);
}

/// Points, levels and C(u) of the case "deboor-cimat" of the reference results.
TEST(CanvasScene, construction_stands_where_the_reference_says) {
    core::CurveDefinition definition = test::cubic();
    definition.points = {{-6, -2.25}, {-4.5, 2.5}, {-1.5, 3.5}, {-0.5, -2.5}, {2.5, -3.25}, {3.5, 2.25}, {6.25, 2.75}};
    EditorState state = test::scene_state(definition);
    state.view.parameter = 0.4;
    const render::DrawList list = test::canvas_picture(state);
    const Theme theme = dark();
    expect_markers(discs_of_color(list, theme.level(1), 4.0F), state,
                   {{-2.1, 3.3}, {-0.9666666666666667, 0.3}, {0.1, -2.65}});
    expect_markers(discs_of_color(list, theme.level(2), 4.0F), state,
                   {{-1.1933333333333333, 0.9}, {-0.6466666666666666, -0.585}});
    expect_markers(discs_of_color(list, theme.parameter, 8.0F), state, {{-0.8653333333333332, 0.009}});
    const auto first = test::lines_of(list, theme.level(1), 1.75F);
    ASSERT_EQ(first.size(), 3U);
    EXPECT_LT(distance(first[2].points.front(), screen(state, {-0.5, -2.5})), 1e-3);
    EXPECT_LT(distance(first[2].points.back(), screen(state, {2.5, -3.25})), 1e-3);
    EXPECT_EQ(test::lines_of(list, theme.level(2), 1.75F).size(), 2U);
    EXPECT_EQ(test::lines_of(list, theme.level(3), 1.75F).size(), 1U);
}

TEST(CanvasScene, construction_stops_at_the_level_of_the_view) {
    EditorState state = test::sample_state();
    state.view.level = 1;
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_EQ(discs_of_color(list, dark().level(1), 4.0F).size(), 3U);
    EXPECT_TRUE(discs_of_color(list, dark().level(2), 4.0F).empty());
    EXPECT_TRUE(test::lines_of(list, dark().level(3), 1.75F).empty());
    const auto point = test::markers_of(list, MarkerShape::disc, 8.0F);
    ASSERT_EQ(point.size(), 1U);
    EXPECT_EQ(point[0].fill, dark().canvas) << "C(u) is not reached yet";
    state.view.level = 3;
    EXPECT_EQ(discs_of_color(test::canvas_picture(state), dark().parameter, 8.0F).size(), 1U);
}

TEST(CanvasScene, hovered_cell_lights_the_segment_it_divides) {
    EditorState state = test::sample_state();
    state.hover = HoveredCell{1, 1};
    const auto lit = test::lines_of(test::canvas_picture(state), dark().level(1), 4.0F);
    ASSERT_EQ(lit.size(), 1U);
    EXPECT_LT(distance(lit[0].points.front(), screen(state, {-1.6, 3.6})), 1e-3);
    EXPECT_LT(distance(lit[0].points.back(), screen(state, {-0.4, -2.6})), 1e-3);
}

TEST(CanvasScene, labels_name_the_points_and_keep_apart) {
    const render::DrawList list = test::canvas_picture(test::sample_state());
    for (const char* text :
         {"P_{0}", "P_{1}", "P_{2}", "P_{3}", "P_{4}", "P_{5}", "· w 2", "P_{6}", "C(0.400)", "de Boor"})
        EXPECT_TRUE(test::has_text(list, text)) << text;
    EXPECT_EQ(test::overlapping_labels(list), std::vector<std::string>{});
}

TEST(CanvasScene, legend_of_a_bezier_curve_says_de_casteljau) {
    const core::CurveDefinition definition{
        .degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {2, 0}}};
    const render::DrawList list = test::canvas_picture(test::scene_state(definition));
    EXPECT_TRUE(test::has_text(list, "de Casteljau"));
    EXPECT_FALSE(test::has_text(list, "de Boor"));
}

TEST(CanvasScene, name_of_the_curve_point_covers_no_mark) {
    core::CurveDefinition definition;
    definition.degree = 3;
    definition.knots = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    definition.points = {{0, 0}, {-2, 0}, {-3, 3}, {-1, 7}, {5, 6}, {6, 1}};
    EditorState state = test::scene_state(definition);
    state.view.camera.center = {1.5, 3.5};
    for (int k = 0; k <= 300; ++k) {
        state.view.parameter = 0.01 * k;
        const render::DrawList list = test::canvas_picture(state);
        const auto labels = test::all_of<render::Label>(list);
        const auto name = std::find_if(labels.begin(), labels.end(),
                                       [](const render::Label& label) { return label.text.starts_with("C("); });
        ASSERT_NE(name, labels.end()) << k;
        for (const render::Marker& mark : test::all_of<render::Marker>(list)) {
            const glm::dvec2 center(mark.center);
            const glm::dvec2 reach(static_cast<double>(mark.radius_px) - 1.0);
            const bool is_in_legend = center.x < 300.0 && center.y > 500.0;
            EXPECT_TRUE(is_in_legend || !test::box_of(*name).overlaps({center - reach, center + reach}))
                << name->text << " at " << center.x << ", " << center.y;
        }
    }
}

TEST(CanvasScene, labels_keep_clear_of_the_grips_of_the_transform_box) {
    EditorState state = test::sample_state();
    state.tool = Tool::transform;
    const TransformBox box = transform_box(state).value();
    for (int k = 0; k <= 100; ++k) {
        state.view.parameter = 0.01 * k;
        for (const auto& label : test::all_of<render::Label>(test::canvas_picture(state))) {
            if (!label.text.starts_with("C(") && !label.text.starts_with("P")) continue;
            for (const TransformGrip grip : visible_grips(box)) {
                const glm::dvec2 place = grip_place(state, box, grip);
                EXPECT_FALSE(test::box_of(label).overlaps({place - 5.0, place + 5.0})) << label.text << " at u = " << k;
            }
        }
    }
}

TEST(CanvasScene, name_of_the_curve_point_stays_inside_and_off_control_points_in_a_small_canvas) {
    EditorState state = test::sample_state();
    state.view.interface_scale = 2.0;
    state.view.camera.size_px = {560.0, 300.0};
    state.view.camera.scale = 40.0;
    for (int k = 0; k <= 100; ++k) {
        state.view.parameter = 0.01 * k;
        const render::DrawList list = test::canvas_picture(state);
        for (const render::Label& label : test::all_of<render::Label>(list)) {
            if (!label.text.starts_with("C(")) continue;
            const render::PixelBox box = test::box_of(label);
            EXPECT_GE(box.lower_px.x, 0.0) << k;
            EXPECT_GE(box.lower_px.y, 0.0) << k;
            EXPECT_LE(box.upper_px.x, 560.0) << k;
            EXPECT_LE(box.upper_px.y, 300.0) << k;
            for (const core::Point point : state.active_curve()->control_points()) {
                const glm::dvec2 place = render::screen_from_world(state.view.camera, point);
                EXPECT_FALSE(box.overlaps({place - 12.0, place + 12.0})) << k;
            }
        }
    }
}

TEST(CanvasScene, labels_stay_while_a_point_moves_away_from_them) {
    const EditorState before = test::sample_state();
    EditorState after = before;
    core::Document moved = before.shown();
    moved.curves[0].curve =
        std::make_shared<const core::Curve>(core::set_control_point(*before.active_curve(), 6, {6.3, 2.9}).value());
    after.preview = moved;
    const auto offset = [](const EditorState& state, std::size_t i) {
        for (const Label& label : all_of<Label>(test::canvas_picture(state)))
            if (label.text == "P_{" + std::to_string(i) + "}")
                return glm::dvec2(label.position) - screen(state, state.active_curve()->control_points()[i]);
        return glm::dvec2(1e9);
    };
    for (std::size_t i = 0; i < 7; ++i) EXPECT_LT(glm::distance(offset(before, i), offset(after, i)), 1e-3) << i;
}

TEST(CanvasScene, sizes_follow_the_interface_scale) {
    const render::DrawList one = test::canvas_picture(test::sample_state());
    const render::DrawList two = test::canvas_picture(test::doubled(test::sample_state()));
    const auto small = all_of<Marker>(one);
    const auto large = all_of<Marker>(two);
    ASSERT_EQ(small.size(), large.size());
    for (std::size_t i = 0; i < small.size(); ++i) {
        EXPECT_LT(distance(large[i].center, 2.0 * glm::dvec2(small[i].center)), 2e-3) << i;
        EXPECT_FLOAT_EQ(large[i].radius_px, 2.0F * small[i].radius_px);
        EXPECT_FLOAT_EQ(large[i].outline_px, 2.0F * small[i].outline_px);
    }
    const auto small_labels = all_of<Label>(one);
    const auto large_labels = all_of<Label>(two);
    ASSERT_EQ(small_labels.size(), large_labels.size());
    for (std::size_t i = 0; i < small_labels.size(); ++i) {
        EXPECT_EQ(small_labels[i].text, large_labels[i].text);
        EXPECT_FLOAT_EQ(large_labels[i].size_px, 2.0F * small_labels[i].size_px);
        EXPECT_LT(distance(large_labels[i].position, 2.0 * glm::dvec2(small_labels[i].position)), 2e-3);
    }
    EXPECT_EQ(test::lines_of(two, dark().curve, 6.0F).size(), test::lines_of(one, dark().curve, 3.0F).size());
    EXPECT_EQ(all_of<Polyline>(two).size(), all_of<Polyline>(one).size());
}

TEST(CanvasScene, picture_is_steady_at_a_zoom_of_1e12) {
    EditorState state = test::sample_state();
    const core::Point knot = core::point_at(*state.active_curve(), 0.5);
    for (const core::Point center : {core::Point(-4.6, 2.6), knot, core::point_at(*state.active_curve(), 0.4)}) {
        state.view.camera.center = center;
        state.view.camera.scale = 1e12;
        EditorState panned = state;
        panned.view.camera = render::panned(state.view.camera, {1.0, 1.0});
        const auto before = all_of<Marker>(test::canvas_picture(state));
        const auto after = all_of<Marker>(test::canvas_picture(panned));
        ASSERT_EQ(before.size(), after.size());
        int moving = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const glm::vec2 shift = after[i].center - before[i].center;
            if (before[i].radius_px == 5.0F && shift == glm::vec2(0.0F)) continue;  // the legend stays
            ++moving;
            EXPECT_NEAR(shift.x, 1.0, 0.01) << i;
            EXPECT_NEAR(shift.y, 1.0, 0.01) << i;
        }
        EXPECT_GT(moving, 0);
    }
}

TEST(CanvasScene, curve_at_a_zoom_of_1e12_passes_through_its_point) {
    EditorState state = test::sample_state();
    state.view.camera.center = core::point_at(*state.active_curve(), 0.4);
    state.view.camera.scale = 1e12;
    const auto lines = test::lines_of(test::canvas_picture(state), dark().accent, 4.0F);
    ASSERT_FALSE(lines.empty());
    EXPECT_LT(test::distance_to(lines, 0.5 * state.view.camera.size_px), 0.5);
}

TEST(CanvasScene, multiple_knot_is_a_stack_across_the_curve) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = {0, 0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1, 1};
    EditorState state = test::scene_state(definition);
    state.view.parameter = 0.1;
    const render::DrawList list = test::canvas_picture(state);
    const auto diamonds = test::markers_of(list, MarkerShape::diamond, 5.0F);
    ASSERT_EQ(diamonds.size(), 3U) << "one at 1/4, two at 1/2";
    const glm::dvec2 a(diamonds[1].center);
    const glm::dvec2 b(diamonds[2].center);
    EXPECT_LT(glm::distance(0.5 * (a + b), screen(state, core::point_at(*state.active_curve(), 0.5))), 1e-3);
    EXPECT_NEAR(glm::distance(a, b), 8.5, 1e-3);
    const core::Vector along = core::derivatives_at(*state.active_curve(), 0.5, 1)[1];
    EXPECT_NEAR(glm::dot(glm::normalize(b - a), glm::normalize(glm::dvec2(along.x, -along.y))), 0.0, 1e-4);
    EXPECT_TRUE(test::has_text(list, "×2 C^{1}"));
    state.view.overlays.show(Overlay::labels, false);
    EXPECT_FALSE(test::has_text(test::canvas_picture(state), "×2 C^{1}"));
}

TEST(CanvasScene, knot_hovered_on_the_strip_is_lit_on_the_curve) {
    EditorState state = test::sample_state();
    state.hover = HoveredKnot{5};
    const auto chosen = test::markers_of(test::canvas_picture(state), MarkerShape::diamond, 6.5F);
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(chosen[0].outline, dark().accent);
    EXPECT_LT(distance(chosen[0].center, screen(state, core::point_at(*state.active_curve(), 0.5))), 1e-3);
    state.hover = HoveredNothing{};
    state.selection.knot = 4;
    const auto selected = test::markers_of(test::canvas_picture(state), MarkerShape::diamond, 6.5F);
    ASSERT_EQ(selected.size(), 1U);
    EXPECT_LT(distance(selected[0].center, screen(state, core::point_at(*state.active_curve(), 0.25))), 1e-3);
}

TEST(CanvasScene, hidden_overlays_add_nothing) {
    EditorState state = test::sample_state();
    show_only(state, {});
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(all_of<Label>(list).empty());
    EXPECT_TRUE(all_of<Fill>(list).empty());
    EXPECT_EQ(all_of<Marker>(list).size(), 1U) << "C(u)";
    EXPECT_EQ(all_of<Polyline>(list).size(), 3U) << "curve, its direction, active span";
}

TEST(CanvasScene, each_overlay_adds_something_of_its_own) {
    EditorState state = test::sample_state();
    show_only(state, {});
    const std::size_t bare = test::canvas_picture(state).commands.size();
    for (std::size_t i = 0; i < basic_overlay_count; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        // An open curve has no inside, and rulers stand beside the canvas.
        if (overlay == Overlay::fill || overlay == Overlay::even_odd_fill || overlay == Overlay::rulers) continue;
        show_only(state, {overlay});
        EXPECT_GT(test::canvas_picture(state).commands.size(), bare) << core::name_of(static_cast<Overlay>(i));
    }
}

TEST(CanvasScene, hull_is_that_of_the_active_points) {
    EditorState state = test::sample_state();
    show_only(state, {Overlay::hull});
    const auto fills = all_of<Fill>(test::canvas_picture(state));
    ASSERT_EQ(fills.size(), 1U);
    ASSERT_EQ(fills[0].points.size(), 4U);
    for (const core::Point point : {core::Point(-4.6, 2.6), {-1.6, 3.6}, {-0.4, -2.6}, {2.6, -3.2}}) {
        double least = 1e9;
        for (const render::Pixel corner : fills[0].points)
            least = std::min(least, distance(corner, screen(state, point)));
        EXPECT_LT(least, 1e-3);
    }
}

TEST(CanvasScene, polygon_is_dashed_and_closes_for_a_periodic_curve) {
    EditorState state = test::sample_state();
    show_only(state, {Overlay::polygon});
    auto legs = test::lines_of(test::canvas_picture(state), dark().polygon, 1.5F);
    ASSERT_EQ(legs.size(), 1U);
    EXPECT_EQ(legs[0].points.size(), 7U);
    EXPECT_FLOAT_EQ(legs[0].dash_px, 6.0F);
    EXPECT_FLOAT_EQ(legs[0].gap_px, 5.0F);

    state = test::scene_state(test::closed_cubic());
    show_only(state, {Overlay::polygon});
    legs = test::lines_of(test::canvas_picture(state), dark().polygon, 1.5F);
    ASSERT_EQ(legs.size(), 1U);
    EXPECT_EQ(legs[0].points.size(), 7U);
    EXPECT_EQ(legs[0].points.front(), legs[0].points.back());
}

TEST(CanvasScene, control_points_show_color_selection_weight_and_direction) {
    EditorState state = test::sample_state();
    show_only(state, {Overlay::polygon});
    state.selection.points = {2};
    state.hover = HoveredPoint{3};
    const render::DrawList list = test::canvas_picture(state);
    const auto plain = test::markers_of(list, MarkerShape::disc, 6.5F);
    ASSERT_EQ(plain.size(), 6U) << "all but the hovered one";
    EXPECT_EQ(plain[2].fill, dark().palette[2]);
    const auto hovered = discs_of_color(list, dark().palette[3], 8.0F);
    ASSERT_EQ(hovered.size(), 1U);
    const auto boxes = test::markers_of(list, MarkerShape::square, 10.0F);
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_LT(distance(boxes[0].center, screen(state, {-6, -2.2})), 1e-3);
    const auto rings = test::markers_of(list, MarkerShape::disc, 7.5F);
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_EQ(rings[0].outline, dark().accent);
    EXPECT_LT(distance(rings[0].center, screen(state, {-1.6, 3.6})), 1e-3);
    int dashed = 0;
    for (const Marker& marker : all_of<Marker>(list)) {
        if (marker.dash_px == 0.0F) continue;
        if (marker.outline != dark().palette[5]) continue;
        ++dashed;
        EXPECT_LT(distance(marker.center, screen(state, {3.4, 2.2})), 1e-3);
        EXPECT_GT(marker.radius_px, 9.0F);
        EXPECT_LT(marker.radius_px, 22.0F);
    }
    EXPECT_EQ(dashed, 1);
}

TEST(CanvasScene, ghost_is_opaque_and_where_the_old_curve_was) {
    EditorState state = test::sample_state();
    const auto old =
        std::make_shared<const core::Curve>(core::set_control_point(*state.active_curve(), 3, {1.0, 1.0}).value());
    state.ghost = Ghost{old, 0.5};
    const render::Color color = render::blended(dark().curve, 0.35, dark().canvas);
    EXPECT_EQ(color.alpha, 255);
    const auto lines = test::lines_of(test::canvas_picture(state), color, 2.0F);
    ASSERT_FALSE(lines.empty());
    for (const double u : {0.1, 0.45, 0.8})
        EXPECT_LT(test::distance_to(lines, screen(state, core::point_at(*old, u))), 0.251);
}

TEST(CanvasScene, other_curves_are_drawn_unless_hidden) {
    EditorState state = test::sample_state();
    core::Document document = state.shown();
    document.curves.push_back(document.curves[0]);
    document.curves[1].color = core::DocumentColor{200, 80, 120};
    document.curves.push_back(document.curves[1]);
    document.curves[2].visible = false;
    state.history = History(document);
    const render::Color dim = render::blended({200, 80, 120, 255}, 0.55, dark().canvas);
    EXPECT_EQ(test::lines_of(test::canvas_picture(state), dim, 2.0F).size(), 1U);
    state.hover = HoveredOtherCurve{1};
    EXPECT_EQ(test::lines_of(test::canvas_picture(state), {200, 80, 120, 255}, 3.0F).size(), 1U);
}

TEST(CanvasScene, hidden_active_curve_shows_nothing_of_itself) {
    EditorState state = test::sample_state();
    core::Document document = state.shown();
    document.curves[0].visible = false;
    state.history = History(document);
    EXPECT_TRUE(all_of<Marker>(test::canvas_picture(state)).empty());
    state.history = History(core::Document{});
    EXPECT_TRUE(all_of<Marker>(test::canvas_picture(state)).empty());
}

TEST(CanvasScene, hovered_point_lights_its_part_of_the_curve) {
    EditorState state = test::sample_state();
    state.hover = HoveredPoint{1};
    const auto glow =
        test::lines_of(test::canvas_picture(state), render::blended(dark().palette[1], 0.35, dark().canvas), 11.0F);
    ASSERT_EQ(glow.size(), 1U);
    EXPECT_LT(distance(glow[0].points.front(), screen(state, {-6, -2.2})), 0.01);
    EXPECT_LT(distance(glow[0].points.back(), screen(state, core::point_at(*state.active_curve(), 0.5))), 0.01);
}

TEST(CanvasScene, box_selection_is_drawn_as_dragged) {
    const EditorState state = test::sample_state();
    const render::DrawList list = test::canvas_picture(state, BoxSelecting{{300, 200}, {100, 50}, {}});
    const auto frames = test::lines_of(list, dark().accent, 1.0F);
    ASSERT_EQ(frames.size(), 1U);
    ASSERT_EQ(frames[0].points.size(), 5U);
    EXPECT_EQ(frames[0].points[0], render::Pixel(100, 50));
    EXPECT_EQ(frames[0].points[2], render::Pixel(300, 200));
}

TEST(CanvasScene, curve_being_drawn_begins_and_ends_in_its_points) {
    EditorState state = test::sample_state();
    show_only(state, {});
    DrawingCurve drawing;
    drawing.points = {{-3, 0}, {-2, 2}, {0, 3}};
    drawing.next = {3, 1};
    const auto lines = test::lines_of(test::canvas_picture(state, drawing), dark().accent, 3.0F);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LT(distance(lines[0].points.front(), screen(state, {-3, 0})), 1e-3);
    EXPECT_LT(distance(lines[0].points.back(), screen(state, {3, 1})), 1e-3);
    drawing.points.clear();
    EXPECT_TRUE(test::lines_of(test::canvas_picture(state, drawing), dark().accent, 3.0F).empty());
    drawing.points = {{1, 1}};
    EXPECT_EQ(test::lines_of(test::canvas_picture(state, drawing), dark().accent, 3.0F).size(), 1U)
        << "a straight line";
}

TEST(CanvasScene, comb_points_away_from_the_center_of_curvature) {
    core::CurveDefinition parabola;
    parabola.degree = 2;
    parabola.knots = {0, 0, 0, 1, 1, 1};
    parabola.points = {{-1, 1}, {0, -1}, {1, 1}};
    EditorState state = test::scene_state(parabola);
    show_only(state, {Overlay::curvature_comb});
    const auto tips = test::lines_of(test::canvas_picture(state), dark().comb, 1.5F);
    ASSERT_EQ(tips.size(), 1U) << "one span, no break";
    double lowest = 0.0;
    for (const render::Pixel tip : tips[0].points) lowest = std::max(lowest, static_cast<double>(tip.y));
    EXPECT_GT(lowest, screen(state, {0, 0}).y + 50.0) << "the vertex bends upwards, so its tooth points down";
}

TEST(CanvasScene, comb_breaks_at_knots_and_leaves_out_straight_lines) {
    core::CurveDefinition quadratic;
    quadratic.degree = 2;
    quadratic.knots = {0, 0, 0, 1, 2, 3, 3, 3};
    quadratic.points = {{-4, 0}, {-3, 3}, {0, 0}, {2, 3}, {4, 0}};
    EditorState state = test::scene_state(quadratic);
    show_only(state, {Overlay::curvature_comb});
    EXPECT_EQ(test::lines_of(test::canvas_picture(state), dark().comb, 1.5F).size(), 3U);
    quadratic.points = {{-4, 0}, {-3, 0}, {0, 0}, {2, 0}, {4, 0}};
    state = test::scene_state(quadratic);
    show_only(state, {});
    const std::size_t bare = test::canvas_picture(state).commands.size();
    show_only(state, {Overlay::curvature_comb});
    EXPECT_EQ(test::canvas_picture(state).commands.size(), bare);
}

TEST(CanvasScene, hodograph_of_a_parabola_is_a_straight_line) {
    core::CurveDefinition parabola;
    parabola.degree = 2;
    parabola.knots = {0, 0, 0, 1, 1, 1};
    parabola.points = {{-1, 1}, {0, -1}, {1, 1}};
    EditorState state = test::scene_state(parabola);
    state.view.parameter = 0.25;
    show_only(state, {Overlay::hodograph});
    const render::DrawList list = test::canvas_picture(state);
    const auto lines = test::lines_of(list, dark().curve, 1.75F);
    ASSERT_EQ(lines.size(), 1U);
    const render::Pixel from = lines[0].points.front();
    const render::Pixel to = lines[0].points.back();
    EXPECT_GT(from.y, to.y) << "C' runs from (2, -4) to (2, 4)";
    for (const render::Pixel place : lines[0].points) EXPECT_NEAR(place.x, from.x, 1e-3);
    const auto now = discs_of_color(list, dark().parameter, 4.5F);
    ASSERT_EQ(now.size(), 1U);
    EXPECT_NEAR(now[0].center.y, 0.75F * from.y + 0.25F * to.y, 1e-3) << "C'(1/4) = (2, -2)";
}

TEST(CanvasScene, far_points_leave_the_near_part_of_the_polygon_in_place) {
    core::CurveDefinition line;
    line.degree = 1;
    line.knots = {0, 0, 1, 2, 2};
    line.points = {{-1e15, 0}, {1e15, 0}, {1e15, 1e15}};
    EditorState state = test::scene_state(line);
    state.view.camera.center = {0.0, 1.0};
    state.view.camera.scale = 100.0;
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_EQ(test::faults_of(list, state.view.camera.size_px, 80.0), std::vector<std::string>{});
    const auto legs = test::lines_of(list, dark().polygon, 1.5F);
    ASSERT_EQ(legs.size(), 1U);
    for (const render::Pixel place : legs[0].points) EXPECT_NEAR(place.y, 383.0, 1e-3);
}

TEST(CanvasScene, curve_that_stands_in_one_point_is_cheap_beyond_the_resolution_of_doubles) {
    core::CurveDefinition standing;
    standing.degree = 5;
    standing.periodic = true;
    standing.knots = {0.0, 1.1e-4, 1.3e-3};
    standing.points = {{-532403098230.99365, -109505817774.32851}, {-532403098230.99365, -109505817774.32851}};
    standing.weights = {262.0, 2e-4};
    EditorState state = test::scene_state(standing);
    state.view.camera.center = standing.points[0];
    state.view.camera.scale = 1.6e13;
    EXPECT_LT(test::canvas_picture(state).commands.size(), 100U);
}

TEST(CanvasScene, names_stand_beside_the_cards_of_a_projector) {
    EditorState state = test::sample_state();
    state.view.is_presenting = true;
    state.view.overlays.show(Overlay::variation, true);
    state.view.overlays.show(Overlay::grid, false);
    const auto cards = floating_cards_box(state);
    ASSERT_TRUE(cards);
    for (const double shift : {0.0, 1.0, 2.0, 3.0}) {
        state.view.camera.center.x = -shift;
        for (const render::Label& label : test::all_of<render::Label>(test::canvas_picture(state)))
            EXPECT_FALSE(test::box_of(label).overlaps(*cards)) << label.text;
    }
}

}  // namespace
}  // namespace batten::editor
