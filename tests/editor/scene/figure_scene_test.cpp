#include "app/editor/scene/figure_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/make/conics.h"
#include "core/refine/knot_insertion.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

EditorState sample_state() {
    Editor editor;
    open_text(editor, sample_text);
    return editor.state();
}

std::size_t count_discs(const render::FigurePart& part, float radius) {
    std::size_t count = 0;
    for (const render::DrawCommand& command : part.list.commands)
        if (const auto* marker = std::get_if<render::Marker>(&command))
            if (marker->radius_px == radius && marker->shape == render::MarkerShape::disc) ++count;
    return count;
}

TEST(FigureScene, shares_a_page_between_title_curve_and_plot) {
    EditorState state = sample_state();
    const FigureForm form{.view = FigureView::both, .title = "A wave"};
    pose_for_figure(state, form, {800.0, 644.0});
    const render::Figure figure = figure_of(state, form, {800.0, 644.0});
    ASSERT_EQ(figure.parts.size(), 3U);
    EXPECT_EQ(figure.size_px, glm::dvec2(800.0, 644.0));
    EXPECT_EQ(figure.title, "A wave");
    EXPECT_EQ(figure.parts[0].box.upper_px.y, 44.0);
    EXPECT_EQ(figure.parts[1].box.upper_px.y, 44.0 + 360.0) << "three fifths of what is left";
    EXPECT_EQ(figure.parts[2].box.upper_px.y, 644.0);
    EXPECT_TRUE(figure.parts[1].ground);
}

TEST(FigureScene, is_larger_by_its_scale_in_all_its_parts) {
    EditorState state = sample_state();
    const FigureForm form{.view = FigureView::both, .scale = 2.0, .is_transparent = true};
    pose_for_figure(state, form, {400.0, 400.0});
    const render::Figure figure = figure_of(state, form, {400.0, 400.0});
    EXPECT_EQ(figure.size_px, glm::dvec2(800.0, 800.0));
    ASSERT_EQ(figure.parts.size(), 2U);
    EXPECT_EQ(figure.parts[1].box.lower_px.y, 480.0) << "the plot has at least 160 design pixels";
    EXPECT_EQ(count_discs(figure.parts[0], 13.0F), state.active_curve()->control_points().size());
    EXPECT_FALSE(figure.parts[0].ground);
}

/// The greatest distance, in pixels, of the middle of a chord from the circle that is the curve of `state`.
double largest_sagitta(const EditorState& state, const FigureForm& form, core::Point center, double radius) {
    const render::Figure figure = figure_of(state, form, {600.0, 400.0});
    const glm::dvec2 middle = render::screen_from_world(state.view.camera, center);
    double largest = 0.0;
    for (const render::DrawCommand& command : figure.parts.front().list.commands) {
        const auto* line = std::get_if<render::Polyline>(&command);
        if (line == nullptr || line->points.size() < 20) continue;
        for (std::size_t k = 0; k + 1 < line->points.size(); ++k) {
            const glm::dvec2 chord = 0.5 * (glm::dvec2(line->points[k]) + glm::dvec2(line->points[k + 1]));
            largest = std::max(largest, state.view.camera.scale * radius - glm::distance(chord, middle));
        }
    }
    return largest;
}

TEST(FigureScene, draws_finer_lines_where_it_will_be_enlarged) {
    EditorState state = sample_state();
    core::Document document = state.history.present();
    document.curves.front().curve = std::make_shared<const core::Curve>(core::circle({1.0, 2.0}, 3.0).value());
    document.curves.resize(1);
    state = Editor(std::move(document)).state();
    state.view.overlays.show(Overlay::polygon, false);
    FigureForm form;
    pose_for_figure(state, form, {600.0, 400.0});
    EXPECT_GT(largest_sagitta(state, form, {1.0, 2.0}, 3.0), 0.02) << "pixels need no more";
    form.fineness = fineness_to_enlarge;
    const double fine = largest_sagitta(state, form, {1.0, 2.0}, 3.0);
    EXPECT_GT(fine, 0.0);
    EXPECT_LT(fine, 0.25 / 16.0 + 1e-4) << "the last bits of floats";
}

TEST(FigureScene, keeps_the_camera_of_the_window) {
    EditorState state = sample_state();
    state.view.interface_scale = 2.0;
    state.view.camera = {.center = {1.0, 2.0}, .scale = 100.0, .size_px = {1200.0, 800.0}};
    const core::Point point = state.active_curve()->control_points()[1];
    const glm::dvec2 on_screen = render::screen_from_world(state.view.camera, point);
    const render::Figure figure = window_figure(state, {});
    EXPECT_EQ(figure.size_px, glm::dvec2(600.0, 400.0)) << "design pixels";
    bool is_found = false;
    for (const render::DrawCommand& command : figure.parts.front().list.commands)
        if (const auto* marker = std::get_if<render::Marker>(&command))
            is_found = is_found || (std::abs(marker->center.x - 0.5 * on_screen.x) < 1e-3 &&
                                    std::abs(marker->center.y - 0.5 * on_screen.y) < 1e-3);
    EXPECT_TRUE(is_found);
}

std::vector<std::string> labels_of(const render::FigurePart& part) {
    std::vector<std::string> labels;
    for (const render::DrawCommand& command : part.list.commands)
        if (const auto* label = std::get_if<render::Label>(&command)) labels.push_back(label->text);
    return labels;
}

std::size_t count_lines(const render::FigurePart& part) {
    return static_cast<std::size_t>(std::ranges::count_if(
        part.list.commands, [](const auto& command) { return std::holds_alternative<render::Polyline>(command); }));
}

TEST(FigureScene, shows_of_the_window_what_it_shows) {
    EditorState state = sample_state();
    state.view.camera = {.center = {1.0, 2.0}, .scale = 40.0, .size_px = {600.0, 400.0}};
    state.view.overlays.show(Overlay::grid, true);
    state.view.overlays.show(Overlay::rulers, true);
    const render::FigurePart with_rulers = window_figure(state, {}).parts.front();
    state.view.overlays.show(Overlay::rulers, false);
    const render::FigurePart without = window_figure(state, {}).parts.front();
    EXPECT_EQ(labels_of(with_rulers), labels_of(without)) << "the numbers of the axes stand beside its edge";
    state.view.parts.arrow = false;
    EXPECT_EQ(count_lines(window_figure(state, {}).parts.front()) + 1, count_lines(without)) << "the arrow";
}

TEST(FigureScene, shows_as_much_of_the_plane_on_another_page) {
    EditorState state = sample_state();
    state.view.camera = {.center = {1.0, 2.0}, .scale = 40.0, .size_px = {600.0, 400.0}};
    const render::Figure figure =
        window_figure(state, {.theme = FigureTheme::high_contrast, .size_px = glm::dvec2(300.0, 300.0)});
    EXPECT_EQ(figure.size_px, glm::dvec2(300.0, 300.0));
    const core::Point point = state.active_curve()->control_points()[1];
    // At half the scale, with the same middle.
    const glm::dvec2 place =
        glm::dvec2(150.0) + 20.0 * (glm::dvec2(point) - glm::dvec2(1.0, 2.0)) * glm::dvec2(1.0, -1.0);
    EXPECT_TRUE(std::ranges::any_of(figure.parts.front().list.commands, [&](const auto& command) {
        const auto* marker = std::get_if<render::Marker>(&command);
        return marker != nullptr && std::abs(marker->center.x - place.x) < 1e-3 &&
               std::abs(marker->center.y - place.y) < 1e-3;
    }));
    EXPECT_EQ(figure.parts.front().ground, high_contrast(ThemeName::light).canvas);
}

TEST(FigureScene, notes_labels_without_room) {
    EditorState state = sample_state();
    for (const double side : {600.0, 60.0}) {
        pose_for_figure(state, {}, {side, side});
        const render::Figure figure = figure_of(state, {}, {side, side});
        const std::vector<std::string> labels = labels_of(figure.parts.front());
        for (std::size_t i = 0; i < state.active_curve()->control_points().size(); ++i) {
            const std::string name = "P_{" + std::to_string(i) + "}";
            EXPECT_NE(std::ranges::count(labels, name), std::ranges::count(figure.unplaced, name)) << name << side;
        }
        EXPECT_EQ(figure.unplaced.empty(), side > 100.0);
    }
}

TEST(FigureScene, leaves_out_parts_that_were_not_asked_for) {
    EditorState state = sample_state();
    state.view.parts = {.points = false, .parameter = false, .legend = false, .arrow = false, .window = false};
    for (const auto& entry : core::Names<Overlay>::table) state.view.overlays.show(entry.value, false);
    pose_for_figure(state, {}, {800.0, 600.0});
    const render::Figure figure = figure_of(state, {}, {800.0, 600.0});
    for (const render::DrawCommand& command : figure.parts.front().list.commands) {
        EXPECT_FALSE(std::holds_alternative<render::Marker>(command));
        EXPECT_FALSE(std::holds_alternative<render::Label>(command));
    }
}

TEST(FigureScene, is_of_any_size_without_trouble) {
    for (const FigureView view : {FigureView::curve, FigureView::basis, FigureView::both, FigureView::homogeneous})
        for (const glm::dvec2 size : {glm::dvec2(1.0, 1.0), {1.0, 500.0}, {500.0, 1.0}}) {
            EditorState state = sample_state();
            const FigureForm form{.view = view, .title = "A wave"};
            pose_for_figure(state, form, size);
            EXPECT_NEAR(figure_of(state, form, size).size_px.y, size.y, 1e-9);
        }
}

core::Curve clamped_cubic() {
    return *core::Curve::make(
        {.degree = 3, .knots = {0, 0, 0, 0, 1, 2, 2, 2, 2}, .points = {{0, 0}, {0, 4}, {4, 4}, {8, 4}, {8, 0}}});
}

TEST(CutPolygon, goes_from_the_polygon_before_to_the_one_after) {
    const core::Curve curve = clamped_cubic();
    // u = 0.5 cuts P0P1, P1P2 and P2P3 at alpha = 0.5 / 1, 0.5 / 2 and 0.5 / 2.
    const core::CornerCutting cutting = *core::corner_cutting(curve, 0.5);
    const auto place = [&](double share, std::size_t i) { return cut_polygon(curve, cutting, share).at(i).place; };
    ASSERT_EQ(cut_polygon(curve, cutting, 0.5).size(), 7U);
    EXPECT_EQ(place(0.0, 1), core::Point(0, 4));
    EXPECT_EQ(place(0.0, 2), core::Point(0, 4));
    EXPECT_EQ(place(0.5, 1), core::Point(0, 3)) << "half way from P1 to (0, 2)";
    EXPECT_EQ(place(0.5, 2), core::Point(0.5, 4)) << "half way from P1 to (1, 4)";
    EXPECT_EQ(place(1.0, 1), core::Point(0, 2));
    EXPECT_EQ(place(1.0, 2), core::Point(1, 4));
    EXPECT_EQ(place(1.0, 3), core::Point(1, 4));
    EXPECT_EQ(place(1.0, 4), core::Point(5, 4));
    EXPECT_EQ(cut_polygon(curve, cutting, 0.5).at(2).index, 1U);
    std::vector<std::size_t> next;
    for (const CutCorner& corner : cut_polygon(curve, cutting, 0.5)) next.push_back(corner.next);
    EXPECT_EQ(next, (std::vector<std::size_t>{0, 1, 2, 2, 3, 4, 5}));
    // The corners at the end are the points of the refined curve.
    const core::Curve after = *core::insert_knot(curve, 0.5);
    for (const core::Point point : after.control_points()) {
        bool is_there = false;
        for (const CutCorner& corner : cut_polygon(curve, cutting, 1.0)) is_there = is_there || corner.place == point;
        EXPECT_TRUE(is_there) << point.x << ' ' << point.y;
    }
}

TEST(CutPolygon, knows_the_points_after_the_insertion_also_of_closed_curves) {
    const core::Curve closed = *core::Curve::make({.degree = 3,
                                                   .knots = {0, 1, 2, 3, 4, 5, 6, 7},
                                                   .points = {{0, 0}, {4, 0}, {8, 0}, {8, 8}, {4, 8}, {0, 8}, {-4, 4}},
                                                   .weights = {1, 2, 1, 3, 1, 1, 4},
                                                   .periodic = true});
    for (const core::Curve& curve : {closed, clamped_cubic()})
        for (double u = 0.25; u < curve.domain().upper; u += 0.5) {
            const core::Curve after = *core::insert_knot(curve, u);
            for (const CutCorner& corner : cut_polygon(curve, *core::corner_cutting(curve, u), 1.0)) {
                const core::Point point = after.control_points()[corner.next];
                EXPECT_NEAR(corner.place.x, point.x, 1e-12) << u;
                EXPECT_NEAR(corner.place.y, point.y, 1e-12) << u;
                EXPECT_NEAR(corner.weight, after.weights()[corner.next], 1e-12) << u;
            }
        }
}

TEST(CutPolygon, lets_a_single_new_point_out_of_the_one_before) {
    const core::Curve curve = *core::Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {4, 0}}});
    const auto polygon = cut_polygon(curve, *core::corner_cutting(curve, 0.75), 0.5);
    ASSERT_EQ(polygon.size(), 3U);
    EXPECT_EQ(polygon[1].place, core::Point(1.5, 0));
}

}  // namespace
}  // namespace batten::editor
