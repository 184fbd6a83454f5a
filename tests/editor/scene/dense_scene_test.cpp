/// Pictures of curves with more points than a screen has room for.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "app/editor/commands/point_commands.h"
#include "app/editor/editor.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/plot_scene.h"
#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::Label;
using render::Marker;
using render::Polyline;
using test::all_of;

constexpr glm::dvec2 dock{1048.0, 260.0};
constexpr double least_wide = 1048.0;

std::vector<core::Point> spiral(std::size_t count) {
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = std::sqrt(static_cast<double>(i) / static_cast<double>(count - 1));
        const double angle = 40.0 * std::numbers::pi * share;
        points.emplace_back(6.0 * share * std::cos(angle), 4.0 * share * std::sin(angle));
    }
    return points;
}

std::vector<core::Point> scattered(std::size_t count) {
    return test::scattered_points(count, {12.0, 7.0});
}

core::CurveDefinition definition_through(std::vector<core::Point> points) {
    const int degree = std::min(3, static_cast<int>(points.size()) - 1);
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, degree, points.size()).value();
    return core::Curve::make(knots, std::move(points), {}).value().definition();
}

EditorState state_of(std::vector<core::Point> points) {
    return test::scene_state(definition_through(std::move(points)));
}

std::size_t places_of(const std::vector<Polyline>& lines) {
    std::size_t count = 0;
    for (const Polyline& line : lines) count += line.points.size();
    return count;
}

TEST(DenseScene, takes_no_more_than_eight_vertices_for_each_pixel_of_width) {
    for (const auto& points : {spiral(3), spiral(3000), spiral(100000), scattered(3000), scattered(100000)}) {
        const EditorState state = state_of(points);
        const render::DrawList canvas = test::canvas_picture(state);
        const Theme theme = theme_of(state.view.theme);
        // A place of a stroke takes up to four vertices, a marker four.
        const std::size_t most = static_cast<std::size_t>(8.0 * least_wide / 4.0);
        EXPECT_LE(places_of(test::lines_of(canvas, theme.curve, 3.0F)), most) << points.size();
        EXPECT_LE(places_of(test::lines_of(canvas, theme.polygon, 1.5F)), most) << points.size();
        EXPECT_LE(all_of<Marker>(canvas).size(), most) << points.size();
        EXPECT_LE(all_of<Label>(canvas).size(), 400U) << points.size();
        const render::DrawList plot = test::plot_picture(state, PlotIdle{}, dock);
        EXPECT_LE(places_of(all_of<Polyline>(plot)), 2 * most) << points.size();
        EXPECT_LE(all_of<Marker>(plot).size(), most) << points.size();
        EXPECT_LE(all_of<Label>(plot).size(), 400U) << points.size();
    }
}

TEST(DenseScene, inks_what_would_take_too_many_places) {
    for (const auto& points : {scattered(3000), spiral(100000)}) {
        const EditorState state = state_of(points);
        const core::Curve& curve = *state.shown().active_curve()->curve;
        SceneCache cache;
        const render::DrawList list = canvas_scene(state, CanvasIdle{}, cache);
        const Theme theme = theme_of(state.view.theme);
        std::shared_ptr<const render::CoverageMap> map;
        for (const render::Ink& ink : all_of<render::Ink>(list))
            if (ink.color == theme.curve) map = ink.map;
        if (points.size() == 3000) {
            ASSERT_NE(map, nullptr);
        }
        if (map == nullptr) continue;
        // No place of the curve is without ink, wherever it goes.
        const core::Interval domain = curve.domain();
        for (int k = 0; k <= 20000; ++k) {
            const core::Point point = core::point_at(curve, domain.lower + domain.length() * k / 20000.0);
            const glm::dvec2 place = render::screen_from_world(state.view.camera, point);
            const glm::ivec2 pixel(glm::floor(place));
            if (pixel.x < 0 || pixel.y < 0 || pixel.x >= map->size_px().x || pixel.y >= map->size_px().y) continue;
            ASSERT_GE(map->coverage(pixel), 200) << k;
        }
    }
}

TEST(DenseScene, inks_many_other_curves_and_keeps_the_ink) {
    core::Document document;
    for (int k = 0; k < 1500; ++k) {
        std::vector<core::Point> points;
        for (const core::Point& point : spiral(10))
            points.push_back(point + core::Vector(14.0 * (k % 40), 10.0 * (k / 40)));
        core::DocumentCurve curve;
        curve.curve = std::make_shared<const core::Curve>(core::Curve::make(definition_through(points)).value());
        if (k % 2 == 1) curve.color = core::DocumentColor{200, 40, 40};
        document.curves.push_back(curve);
    }
    EditorState state = test::scene_state(document.curves.front().curve->definition());
    state.preview = document;
    state.view.camera.scale = 1.8;
    state.view.camera.center = {280.0, 190.0};
    SceneCache cache;
    const auto inks = [&] { return all_of<render::Ink>(canvas_scene(state, CanvasIdle{}, cache)); };
    const auto first = inks();
    ASSERT_EQ(first.size(), 2U) << "one for each color";
    EXPECT_NE(first[0].color, first[1].color);
    // Every curve begins with ink of its color.
    for (std::size_t i = 1; i < document.curves.size(); ++i) {
        const core::Point start = document.curves[i].curve->control_points().front();
        const glm::ivec2 pixel(glm::floor(render::screen_from_world(state.view.camera, start)));
        if (pixel.x < 0 || pixel.y < 0 || pixel.x >= 1048 || pixel.y >= 566) continue;
        EXPECT_GE(first[i % 2 == 1 ? 0 : 1].map->coverage(pixel), 100) << i;
    }
    const auto again = inks();
    EXPECT_EQ(again[0].map, first[0].map) << "not painted again";
    state.hover = HoveredOtherCurve{607};
    const auto hovered = inks();
    EXPECT_EQ(hovered[0].map, first[0].map) << "it lies over its dimmer line";
    const render::DrawList list = canvas_scene(state, CanvasIdle{}, cache);
    EXPECT_FALSE(test::lines_of(list, render::rgb(0xC82828), 3.0F).empty());
    state.preview->curves[607].visible = false;
    EXPECT_NE(inks()[0].map, first[0].map);
    state.preview->curves.resize(20);
    state.hover = {};
    EXPECT_TRUE(inks().empty());
}

TEST(DenseScene, tells_how_many_of_how_many_it_shows) {
    const EditorState few = state_of(spiral(20));
    for (const std::string& text : test::texts_of(test::canvas_picture(few)))
        EXPECT_FALSE(text.starts_with("Showing")) << text;
    const EditorState many = state_of(spiral(100000));
    const auto has_note = [](const render::DrawList& list, const std::string& end) {
        const auto texts = test::texts_of(list);
        return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
            return text.starts_with("Showing ") && text.find(end) != std::string::npos;
        });
    };
    EXPECT_TRUE(has_note(test::canvas_picture(many), " of 100000 points and "));
    EXPECT_TRUE(has_note(test::plot_picture(many, PlotIdle{}, dock), " of 100000 functions and "));
    EXPECT_TRUE(has_note(test::plot_picture(many, PlotIdle{}, dock), " of 100004 knots"));
}

TEST(DenseScene, tells_why_lines_far_from_the_origin_are_coarse) {
    const auto notes = [](double distance) {
        std::vector<core::Point> points = spiral(20);
        for (core::Point& point : points) point.x += distance;
        EditorState state = state_of(std::move(points));
        fit_view(state);
        std::vector<std::string> texts = test::texts_of(test::canvas_picture(state));
        std::erase_if(texts, [](const std::string& text) { return !text.starts_with("Coordinates "); });
        return texts;
    };
    EXPECT_TRUE(notes(0.0).empty());
    EXPECT_TRUE(notes(0x1p30).empty());
    // From 2^50 on doubles are multiples of 2^-2.
    EXPECT_EQ(notes(0x1p50), std::vector<std::string>{"Coordinates have steps of 0.25 here, so that lines are coarse"});
}

TEST(DenseScene, tells_how_many_polygons_of_pieces_and_teeth_it_shows) {
    for (const std::size_t count : {20U, 3000U, 100000U}) {
        EditorState state = state_of(spiral(count));
        for (const Overlay overlay : {Overlay::polygon, Overlay::knots, Overlay::labels})
            state.view.overlays.show(overlay, false);
        state.view.overlays.show(Overlay::bezier_pieces, true);
        state.view.overlays.show(Overlay::curvature_comb, true);
        const render::DrawList list = test::canvas_picture(state);
        std::vector<Label> notes;
        for (const Label& label : all_of<Label>(list))
            if (label.text.find(" of ") != std::string::npos) notes.push_back(label);
        if (count == 20U) {
            EXPECT_TRUE(notes.empty());
            continue;
        }
        ASSERT_EQ(notes.size(), 2U) << count;
        const std::string end = " of " + std::to_string(count - 3);
        EXPECT_TRUE(notes[0].text.starts_with("Showing ")) << notes[0].text;
        EXPECT_TRUE(notes[0].text.ends_with(end + " Bézier polygons")) << notes[0].text;
        EXPECT_TRUE(notes[1].text.starts_with("The comb has teeth at ")) << notes[1].text;
        EXPECT_TRUE(notes[1].text.ends_with(end + " spans")) << notes[1].text;
        EXPECT_TRUE(test::overlapping_labels(list).empty());
    }
}

TEST(DenseScene, tells_how_many_hulls_it_shows) {
    for (const std::size_t count : {20U, 3000U}) {
        EditorState state = state_of(spiral(count));
        for (const Overlay overlay : {Overlay::polygon, Overlay::knots, Overlay::labels})
            state.view.overlays.show(overlay, false);
        state.view.overlays.show(Overlay::span_hulls, true);
        std::vector<std::string> notes = test::texts_of(test::canvas_picture(state));
        std::erase_if(notes, [](const std::string& text) { return !text.starts_with("Showing "); });
        ASSERT_EQ(notes.size(), count == 20U ? 0U : 1U);
        for (const std::string& note : notes) EXPECT_TRUE(note.ends_with(" of 2997 hulls")) << note;
    }
}

TEST(DenseScene, notes_stand_beside_the_legend_or_above_it) {
    EditorState state = state_of(spiral(10000));
    for (const double width : {300.0, 430.0, 528.0, 1048.0})
        for (const Corner corner : all_corners) {
            state.view.camera.size_px = {width, 338.0};
            state.view.legend_corner = corner;
            const render::PixelBox legend = legend_box(state, corner);
            for (const Label& label : all_of<Label>(test::canvas_picture(state)))
                EXPECT_FALSE(label.text.starts_with("Showing ") && test::box_of(label).overlaps(legend))
                    << label.text << " " << width;
        }
}

TEST(DenseScene, labels_have_a_ground_where_points_are_dense) {
    const auto grounds_behind_names = [](std::size_t count) {
        EditorState state = state_of(spiral(count));
        state.hover = HoveredPoint{count / 2};
        const render::DrawList list = test::canvas_picture(state);
        const auto labels = all_of<Label>(list);
        const auto name = std::find_if(labels.begin(), labels.end(), [&](const Label& label) {
            return label.text == "P_{" + std::to_string(count / 2) + "}";
        });
        EXPECT_NE(name, labels.end()) << count;
        std::size_t grounds = 0;
        for (const render::Fill& fill : all_of<render::Fill>(list)) {
            render::PixelBox box = render::PixelBox::between(fill.points.front(), fill.points.front());
            for (const render::Pixel corner : fill.points)
                box = {glm::min(box.lower_px, glm::dvec2(corner)), glm::max(box.upper_px, glm::dvec2(corner))};
            if (name != labels.end() && fill.points.size() == 4 && box.contains(test::box_of(*name).lower_px) &&
                box.contains(test::box_of(*name).upper_px))
                ++grounds;
        }
        return grounds;
    };
    EXPECT_EQ(grounds_behind_names(20), 0U);
    EXPECT_EQ(grounds_behind_names(3000), 1U);
}

TEST(DenseScene, misses_no_loop_of_the_hodograph) {
    // Evenly along a line, but for one point: C' leaves (1, 0) once, for (1, 1) and (1, -1).
    std::vector<core::Point> points;
    for (int i = 0; i < 100000; ++i) points.emplace_back(i, i == 54321 ? 1.0 : 0.0);
    core::CurveDefinition definition{.degree = 3, .knots = {}, .points = points, .kind = core::KnotKind::uniform};
    for (std::size_t i = 0; i < points.size() + 4; ++i) definition.knots.push_back(static_cast<double>(i));
    EditorState state = test::scene_state(definition);
    state.view.overlays = {};
    state.view.overlays.show(Overlay::hodograph, true);
    const auto lines = test::lines_of(test::canvas_picture(state), theme_of(state.view.theme).curve, 1.75F);
    double lowest = -1e9;
    double highest = 1e9;
    for (const Polyline& line : lines)
        for (const render::Pixel place : line.points) {
            lowest = std::max(lowest, static_cast<double>(place.y));
            highest = std::min(highest, static_cast<double>(place.y));
        }
    // The cubic takes 5/9 of what its control points differ by, and the inset has 120 pixels for twice that.
    EXPECT_GT(lowest - highest, 100.0);
}

TEST(DenseScene, traces_functions_and_hodographs_once) {
    EditorState state = state_of(spiral(100000));
    state.view.overlays.show(Overlay::hodograph, true);
    SceneCache cache;
    const auto draw = [&] {
        canvas_scene(state, CanvasIdle{}, cache);
        plot_scene(state, PlotIdle{}, dock, cache);
    };
    draw();
    const std::size_t traced = cache.basis().traced_count();
    EXPECT_GT(traced, 50U);
    state.hover = HoveredCurve{0.5};
    for (int k = 0; k < 5; ++k) {
        state.view.camera.center.x += 0.1;
        draw();
    }
    EXPECT_EQ(cache.basis().traced_count(), traced);
    state.view.parameter += 0.3;
    draw();
    EXPECT_LE(cache.basis().traced_count(), traced + 4) << "the four that act there";
    EXPECT_EQ(cache.curve(0, state.shown().active_curve()->curve).hodograph_count(), 1U);
    const EditorState few = state_of(spiral(20));
    for (int k = 0; k < 5; ++k) plot_scene(few, PlotIdle{}, dock, cache);
    EXPECT_LE(cache.basis().traced_count(), traced + 4 + 20);
}

TEST(DenseScene, leaves_the_curve_uncovered) {
    const EditorState state = state_of(spiral(3000));
    const render::DrawList list = test::canvas_picture(state);
    const Theme theme = theme_of(state.view.theme);
    bool is_above_curve = false;
    std::size_t above = 0;
    for (const render::DrawCommand& command : list.commands) {
        if (const auto* line = std::get_if<Polyline>(&command); line != nullptr && line->color == theme.curve)
            is_above_curve = true;
        const auto* marker = std::get_if<Marker>(&command);
        if (marker == nullptr || marker->shape != render::MarkerShape::disc) continue;
        if (is_above_curve)
            ++above;
        else
            EXPECT_EQ(marker->outline.alpha, 0);
    }
    // The first and the last point, C(u), of which the construction makes nothing else there, and three of the legend.
    EXPECT_EQ(above, 6U);
}

TEST(DenseScene, shows_what_is_selected_in_full_size) {
    EditorState state = state_of(spiral(3000));
    state.selection.points = {700, 1500};
    const auto rings = test::markers_of(test::canvas_picture(state), render::MarkerShape::disc, 7.5F);
    EXPECT_EQ(rings.size(), 2U);
    EXPECT_TRUE(test::has_text(test::canvas_picture(state), "P_{1500}"));
}

TEST(DenseScene, is_the_same_from_a_cache_that_has_seen_other_curves) {
    SceneCache cache;
    std::vector<core::Point> points = spiral(2000);
    for (int k = 0; k < 12; ++k) {
        if (k == 4) points.resize(1500);
        if (k == 8) points = scattered(700);
        points[static_cast<std::size_t>(50 * k)] += core::Vector(0.1 * k, 0.2);
        EditorState state = state_of(points);
        state.view.camera.scale *= 1.0 + 0.3 * (k % 3);
        const auto kept = canvas_scene(state, CanvasIdle{}, cache);
        const auto anew = test::canvas_picture(state);
        ASSERT_EQ(all_of<Polyline>(kept).size(), all_of<Polyline>(anew).size()) << k;
        EXPECT_EQ(places_of(all_of<Polyline>(kept)), places_of(all_of<Polyline>(anew))) << k;
        EXPECT_EQ(all_of<Marker>(kept).size(), all_of<Marker>(anew).size()) << k;
        EXPECT_EQ(test::texts_of(kept), test::texts_of(anew)) << k;
    }
}

TEST(DenseScene, takes_apart_only_the_spans_of_the_point_that_is_dragged) {
    core::DocumentCurve spiral_curve;
    spiral_curve.name = "spiral";
    spiral_curve.curve =
        std::make_shared<const core::Curve>(core::Curve::make(definition_through(spiral(1000))).value());
    core::Document document;
    document.curves.push_back(spiral_curve);
    SceneCache cache;
    Editor shown(document);
    shown.change(ResizeCanvas{{least_wide, 566.0}});
    canvas_scene(shown.state(), CanvasIdle{}, cache);
    const auto spans = [&] {
        const core::DocumentCurve& item = *shown.state().shown().active_curve();
        return cache.curve(0, item.curve).strips().span_count();
    };
    std::size_t before = spans();
    EXPECT_GT(before, 500U);
    for (int k = 1; k <= 5; ++k) {
        shown.run(MovePoints{.points = {500}, .offset = {0.1 * k, 0.05}}, Phase::preview);
        canvas_scene(shown.state(), CanvasIdle{}, cache);
        EXPECT_EQ(spans(), before + 4) << k;
        before = spans();
    }
    for (int k = 0; k < 20; ++k) {
        shown.change(PanCamera{{5.0, -3.0}});
        canvas_scene(shown.state(), CanvasIdle{}, cache);
    }
    EXPECT_EQ(spans(), before) << "all was in view";
}

TEST(DenseScene, keeps_functions_that_are_wide_among_narrow_ones) {
    // A thousand knots in a hundredth of the axis, and a few over the rest.
    std::vector<double> knots(4, 0.0);
    for (int k = 1; k <= 1000; ++k) knots.push_back(1e-5 * k);
    for (const double u : {0.2, 0.4, 0.6, 0.8, 1.0, 1.0, 1.0, 1.0}) knots.push_back(u);
    const std::size_t count = knots.size() - 4;
    const EditorState state = test::scene_state({.degree = 3, .knots = knots, .points = spiral(count)});
    const render::DrawList plot = test::plot_picture(state, PlotIdle{}, dock);
    const auto texts = test::texts_of(plot);
    // The last eight functions reach over the wide spans.
    for (std::size_t i = count - 5; i < count; ++i)
        EXPECT_TRUE(std::count(texts.begin(), texts.end(), std::to_string(i))) << i;
}

}  // namespace
}  // namespace batten::editor
