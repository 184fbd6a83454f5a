#include "app/editor/pointer/fit_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <set>

#include "app/editor/cards/floating_cards.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/editor.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/views.h"
#include "core/document/native_file.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::PixelBox;

// The canvases of windows from 1024 x 700 to 1920 x 1080, with their scale; the last ones below a line with the title.
struct Canvas {
    glm::dvec2 size_px;
    double scale;
};
constexpr Canvas canvases[] = {{{632, 366}, 1.0},  {{1048, 566}, 1.0}, {{1528, 746}, 1.0}, {{632, 318}, 1.0},
                               {{436, 290}, 1.5},  {{780, 400}, 1.5},  {{436, 177}, 1.5},  {{414, 166}, 2.0},
                               {{414, 170}, 2.0},  {{414, 276}, 2.0},  {{656, 226}, 2.0},  {{1136, 472}, 2.0},
                               {{2096, 1132}, 2.0}};

core::Document example(const std::filesystem::path& path) {
    return core::load_document(path).value();
}

glm::dvec2 seen(const EditorState& state, core::Point world) {
    return render::screen_from_world(state.view.camera, world);
}

/// What is shown of the active curve: its control points and many points of the curve.
std::vector<core::Point> shown_points(const core::Curve& curve) {
    std::vector<core::Point> points(curve.control_points().begin(), curve.control_points().end());
    const core::Interval domain = curve.domain();
    for (int k = 0; k <= 500; ++k) points.push_back(core::point_at(curve, domain.lower + k / 500.0 * domain.length()));
    return points;
}

void expect_all_clear(const EditorState& state, const std::string& where) {
    const PixelBox picture{{}, state.view.camera.size_px};
    const PixelBox legend = has_legend(state) ? legend_box(state, state.view.legend_corner) : PixelBox{};
    const std::optional<PixelBox> inset = insets_box(state);
    EXPECT_TRUE(!has_legend(state) || (picture.contains(legend.lower_px) && picture.contains(legend.upper_px)))
        << where;
    EXPECT_FALSE(has_legend(state) && inset && legend.overlaps(*inset)) << where;
    for (const core::Point point : shown_points(*state.active_curve())) {
        EXPECT_TRUE(picture.contains(seen(state, point))) << where;
        EXPECT_FALSE(has_legend(state) && legend.contains(seen(state, point))) << where;
        EXPECT_FALSE(inset && inset->contains(seen(state, point))) << where;
    }
}

TEST(FitView, keeps_every_example_clear_of_legend_and_inset) {
    for (const auto& file : std::filesystem::directory_iterator(BATTEN_EXAMPLES)) {
        if (file.path().extension() != ".json") continue;
        for (const Canvas& canvas : canvases)
            for (const bool has_hodograph : {false, true}) {
                if (has_hodograph && canvas.size_px.y < 350.0 * canvas.scale) continue;
                Editor editor(example(file.path()));
                editor.change(SetInterfaceScale{canvas.scale});
                editor.change(ResizeCanvas{canvas.size_px});
                if (has_hodograph != editor.state().view.overlays.is_shown(Overlay::hodograph))
                    editor.run(ToggleOverlay<Overlay::hodograph>{});
                editor.run(FitView{});
                expect_all_clear(editor.state(), file.path().filename().string());
            }
    }
}

TEST(FitView, uses_the_whole_picture_where_nothing_is_in_the_way) {
    Editor editor = test::zigzag_editor();
    editor.change(ResizeCanvas{{1000.0, 700.0}});
    // A margin of 56 on both sides of the 8 units between the outer points.
    EXPECT_NEAR(editor.state().view.camera.scale, (1000.0 - 112.0) / 8.0, 1e-9);
    EXPECT_EQ(editor.state().view.camera.center, glm::dvec2(0.0, 0.0));
}

TEST(FitView, shows_the_whole_of_what_views_draw) {
    Editor editor(example(std::filesystem::path(BATTEN_EXAMPLES) / "coons-open.json"));
    for (const glm::dvec2 size : {glm::dvec2(868, 386), glm::dvec2(1528, 746)}) {
        editor.change(ResizeCanvas{size});
        editor.run(FitView{});
        const double scale = editor.state().view.camera.scale;
        editor.run(ToggleOverlay<Overlay::end_vertices>{});
        editor.run(FitView{});
        // The phantoms 2 P0 - P1 and 2 P3 - P2.
        for (const core::Point phantom : {core::Point(-1, -3), core::Point(6, -5)})
            EXPECT_TRUE((PixelBox{{}, size}.contains(seen(editor.state(), phantom))))
                << size.x << " " << seen(editor.state(), phantom).x << " " << seen(editor.state(), phantom).y;
        EXPECT_GE(editor.state().view.camera.scale, 0.33 * scale);
        editor.run(ToggleOverlay<Overlay::end_vertices>{});
        editor.run(FitView{});
        EXPECT_DOUBLE_EQ(editor.state().view.camera.scale, scale);
    }
}

TEST(FitView, makes_room_for_the_comb) {
    Editor editor(example(std::filesystem::path(BATTEN_EXAMPLES) / "wave.json"));
    editor.run(ToggleOverlay<Overlay::curvature_comb>{});
    editor.change(ResizeCanvas{{868, 322}});
    editor.run(FitView{});
    SceneCache cache;
    const auto reach = reach_of_views(editor.state(), cache);
    ASSERT_TRUE(reach);
    EXPECT_TRUE((PixelBox{{}, {868, 322}}.contains(reach->lower_px)));
    EXPECT_TRUE((PixelBox{{}, {868, 322}}.contains(reach->upper_px)));
}

TEST(FitView, all_insets_have_room_in_a_small_canvas) {
    Editor editor(example(std::filesystem::path(BATTEN_EXAMPLES) / "wave.json"));
    editor.run(ToggleOverlay<Overlay::hodograph>{});
    editor.run(ToggleOverlay<Overlay::second_hodograph>{});
    for (const glm::dvec2 size : {glm::dvec2(528, 338), glm::dvec2(528, 290), glm::dvec2(1048, 566)}) {
        editor.change(ResizeCanvas{size});
        const std::vector<InsetPlace> places = inset_places(editor.state());
        ASSERT_EQ(places.size(), 2U) << size.x;
        EXPECT_FALSE(places[0].box.overlaps(places[1].box));
        for (const InsetPlace& place : places)
            EXPECT_TRUE(
                (PixelBox{{}, size}.contains(place.box.lower_px) && PixelBox{{}, size}.contains(place.box.upper_px)));
        EXPECT_EQ(places[0].box.upper_px.x - places[0].box.lower_px.x > 199.0, size.x > 600.0);
    }
}

TEST(FitView, insets_stand_beside_the_cards_of_a_projector) {
    Editor editor(example(std::filesystem::path(BATTEN_EXAMPLES) / "circle-nurbs.json"));
    editor.change(ResizeCanvas{{1920, 690}});
    editor.change(SetInterfaceScale{1.5});
    editor.run(ToggleOverlay<Overlay::homogeneous>{});
    EXPECT_FALSE(floating_cards_box(editor.state()));
    EXPECT_GT(insets_box(editor.state())->upper_px.x, 1890.0);
    editor.run(TogglePresenting{});
    editor.change(SetInterfaceScale{1.5});
    const auto cards = floating_cards_box(editor.state());
    ASSERT_TRUE(cards);
    EXPECT_DOUBLE_EQ(cards->lower_px.x, 1920.0 - 1.5 * (360.0 + 14.0));
    EXPECT_LE(insets_box(editor.state())->upper_px.x, cards->lower_px.x);
}

TEST(FitView, arrows_do_not_lie_under_insets) {
    Editor editor(example(std::filesystem::path(BATTEN_EXAMPLES) / "cubic-de-boor.json"));
    editor.run(ToggleOverlay<Overlay::hodograph>{});
    editor.run(ToggleOverlay<Overlay::end_derivatives>{});
    editor.change(ResizeCanvas{{868, 386}});
    editor.run(FitView{});
    SceneCache cache;
    const auto reach = reach_of_views(editor.state(), cache);
    ASSERT_TRUE(reach);
    EXPECT_FALSE(reach->overlaps(*insets_box(editor.state())));
    EXPECT_TRUE((PixelBox{{}, {868, 386}}.contains(reach->lower_px)));
    EXPECT_TRUE((PixelBox{{}, {868, 386}}.contains(reach->upper_px)));
}

class Resizing : public testing::Test {
  protected:
    const render::Camera& camera() const { return editor_.state().view.camera; }
    void resize(double width, double height) { editor_.change(ResizeCanvas{{width, height}}); }

    Editor editor_ = test::zigzag_editor();
};

TEST_F(Resizing, fits_anew_what_was_fitted) {
    resize(1048, 566);
    const render::Camera before = camera();
    resize(632, 366);
    expect_all_clear(editor_.state(), "small");
    EXPECT_LT(camera().scale, before.scale);
    resize(1048, 566);
    EXPECT_EQ(camera(), before);
}

TEST_F(Resizing, keeps_in_view_what_the_user_chose_and_comes_back) {
    resize(1048, 566);
    editor_.change(ZoomCamera{3.0, {400.0, 200.0}});
    const render::Camera before = camera();
    const glm::dvec2 lower = render::world_from_screen(before, {0, 566});
    const glm::dvec2 upper = render::world_from_screen(before, {1048, 0});
    for (const glm::dvec2 size : {glm::dvec2(632, 566), glm::dvec2(632, 200), glm::dvec2(1048, 200)}) {
        resize(size.x, size.y);
        const PixelBox picture{glm::dvec2(-1e-6), size + 1e-6};
        EXPECT_TRUE(picture.contains(render::screen_from_world(camera(), lower))) << size.x << " x " << size.y;
        EXPECT_TRUE(picture.contains(render::screen_from_world(camera(), upper))) << size.x << " x " << size.y;
    }
    EXPECT_DOUBLE_EQ(camera().scale, before.scale * 200.0 / 566.0);
    resize(1048, 566);
    EXPECT_EQ(camera(), before);
    resize(1500, 900);
    EXPECT_EQ(camera().scale, before.scale) << "a larger canvas shows more, not larger";
    EXPECT_EQ(camera().center, before.center);
}

TEST_F(Resizing, begins_at_what_the_user_chose_last) {
    resize(1048, 566);
    editor_.change(PanCamera{{10.0, 0.0}});
    resize(524, 283);
    editor_.change(ZoomCamera{1.5, {100.0, 100.0}});
    const render::Camera chosen = camera();
    resize(1048, 566);
    EXPECT_EQ(camera().scale, chosen.scale);
    resize(524, 283);
    EXPECT_EQ(camera(), chosen);
    resize(0, -1);
    resize(524, 283);
    EXPECT_EQ(camera(), chosen);
}

/// Point 0 is dragged; the canvas is 632 x 366 pixels.
class Legend : public testing::Test {
  protected:
    Legend() {
        editor_.change(ResizeCanvas{{632, 366}});
        editor_.change(PlaceLegend{free_corner(editor_.state(), cache_)});
    }
    Corner corner() const { return editor_.state().view.legend_corner; }
    void drag_to(glm::dvec2 place_px) {
        const core::Point world(render::world_from_screen(editor_.state().view.camera, place_px));
        editor_.run(SetPoint{.index = 0, .position = world}, Phase::preview);
        editor_.change(PlaceLegend{free_corner(editor_.state(), cache_)});
    }

    Editor editor_ = test::zigzag_editor();
    SceneCache cache_;
};

TEST_F(Legend, gives_way_to_a_point_that_is_dragged_under_it) {
    const PixelBox before = legend_box(editor_.state(), corner());
    const glm::dvec2 middle = 0.5 * (before.lower_px + before.upper_px);
    drag_to(middle);
    EXPECT_FALSE(legend_box(editor_.state(), corner()).contains(middle));
}

TEST_F(Legend, gives_way_to_the_grips_of_the_transform_box) {
    editor_.run(TakeTool<Tool::transform>{});
    const auto grips_under = [&](Corner corner) {
        const PixelBox legend = legend_box(editor_.state(), corner);
        const TransformBox box = transform_box(editor_.state()).value();
        int count = 0;
        for (const TransformGrip grip : visible_grips(box))
            if (legend.contains(grip_place(editor_.state(), box, grip))) ++count;
        return count;
    };
    for (const int x : {-1, 1})
        for (const int y : {-1, 1}) {
            const PixelBox before = legend_box(editor_.state(), corner());
            const glm::dvec2 middle = 0.5 * (before.lower_px + before.upper_px);
            const TransformGrip grip{GripKind::scale, x, y};
            const auto place = [&] {
                return grip_place(editor_.state(), transform_box(editor_.state()).value(), grip);
            };
            editor_.change(PanCamera{middle - place()});
            ASSERT_NEAR(glm::distance(place(), middle), 0.0, 1e-6);
            ASSERT_GT(grips_under(corner()), 0);
            editor_.change(PlaceLegend{free_corner(editor_.state(), cache_)});
            EXPECT_EQ(grips_under(corner()), 0) << x << y;
        }
}

TEST_F(Legend, is_left_out_where_every_corner_is_taken_by_a_grip) {
    const auto tells_levels = [&] { return test::has_text(test::canvas_picture(editor_.state()), "level 1"); };
    // The corners of the box, which is 12 pixels around 8 x 4 units, are in the middle of the legend in each corner.
    const PixelBox first = legend_box(editor_.state(), Corner::lower_left);
    const glm::dvec2 size{8.0 * 64.0 + 24.0 + 28.0 + (first.upper_px.x - first.lower_px.x), 4.0 * 64.0 + 24.0 + 72.0};
    editor_.change(ResizeCanvas{size});
    editor_.change(ZoomCamera{64.0 / editor_.state().view.camera.scale, {}});
    editor_.change(PanCamera{glm::dvec2(0.5 * size.x, 0.5 * size.y - 7.0) - seen(editor_.state(), {0, 0})});
    editor_.change(PlaceLegend{free_corner(editor_.state(), cache_)});
    EXPECT_TRUE(shows_legend(editor_.state()));
    editor_.run(TakeTool<Tool::transform>{});
    const TransformBox box = transform_box(editor_.state()).value();
    for (const Corner corner : all_corners) {
        const PixelBox legend = legend_box(editor_.state(), corner);
        const auto grips = visible_grips(box);
        ASSERT_TRUE(std::ranges::any_of(
            grips, [&](TransformGrip grip) { return legend.contains(grip_place(editor_.state(), box, grip)); }));
    }
    editor_.change(PlaceLegend{free_corner(editor_.state(), cache_)});
    EXPECT_FALSE(shows_legend(editor_.state()));
    EXPECT_FALSE(tells_levels());
    editor_.run(TakeTool<Tool::select>{});
    EXPECT_TRUE(tells_levels());
}

TEST_F(Legend, does_not_flicker_at_an_edge) {
    const PixelBox before = legend_box(editor_.state(), corner());
    int changes = 0;
    Corner last = corner();
    for (int k = 0; k < 100; ++k) {
        drag_to({before.upper_px.x + 16.0 + (k % 2 == 0 ? 2.0 : -2.0), before.lower_px.y});
        if (corner() != last) ++changes;
        last = corner();
    }
    EXPECT_LE(changes, 1);
}

TEST_F(Legend, is_left_out_of_a_canvas_that_is_too_low_for_both) {
    editor_.change(ResizeCanvas{{414, 170}});
    editor_.change(SetInterfaceScale{1.0});
    EXPECT_TRUE(has_legend(editor_.state()));
    editor_.change(SetInterfaceScale{2.0});
    EXPECT_FALSE(has_legend(editor_.state()));
}

TEST_F(Legend, does_not_lie_over_the_inset_in_a_narrow_canvas) {
    editor_.run(ToggleOverlay<Overlay::hodograph>{});
    editor_.change(ResizeCanvas{{440, 366}});
    for (int k = 0; k < 20; ++k) {
        editor_.change(PanCamera{{0.0, 10.0}});
        editor_.change(PlaceLegend{free_corner(editor_.state(), cache_)});
        EXPECT_FALSE(legend_box(editor_.state(), corner()).overlaps(insets_box(editor_.state()).value())) << k;
    }
}

TEST_F(Legend, is_brief_where_the_canvas_is_narrow) {
    for (const double width : {632.0, 300.0, 210.0}) {
        editor_.change(ResizeCanvas{{width, 300.0}});
        for (const Corner corner : all_corners) {
            const PixelBox box = legend_box(editor_.state(), corner);
            EXPECT_GE(box.lower_px.x, 0.0) << width;
            EXPECT_LE(box.upper_px.x, width) << width;
        }
    }
}

}  // namespace
}  // namespace batten::editor
