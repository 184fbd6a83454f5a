#include "app/editor/commands/view_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_spec.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/state/key.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class ViewCommands : public ::testing::Test {
  protected:
    ViewCommands() { open_text(editor_, bezier_text); }

    const View& view() const { return editor_.state().view; }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }

    Editor editor_;
};

TEST_F(ViewCommands, clamp_the_parameter_to_the_domain) {
    EXPECT_EQ(editor_.state().parameter(), 0.5);
    EXPECT_TRUE(run(SetParameter{.u = 0.25}));
    EXPECT_EQ(editor_.state().parameter(), 0.25);
    EXPECT_TRUE(run(SetParameter{.u = 7.0}));
    EXPECT_EQ(editor_.state().parameter(), 1.0);
    run(StepParameterBack{});
    EXPECT_NEAR(editor_.state().parameter(), 0.99, 1e-15);
    run(StepParameterForward{});
    run(StepParameterForward{});
    EXPECT_EQ(editor_.state().parameter(), 1.0);
}

TEST_F(ViewCommands, wrap_the_parameter_of_a_closed_curve) {
    open_text(editor_, sample_text);
    run(ActivateCurve{.index = 1});
    run(SetParameter{.u = 6.5});
    EXPECT_EQ(editor_.state().parameter(), 1.5);
}

TEST_F(ViewCommands, play_to_and_fro) {
    run(SetParameter{.u = 0.4});
    editor_.change(Advance{1.0});
    EXPECT_EQ(view().parameter, 0.4);  // not playing
    run(TogglePlay{});
    editor_.change(Advance{1.0});  // speed 0.5: a tenth of the domain in a second
    EXPECT_NEAR(view().parameter, 0.5, 1e-15);
    editor_.change(Advance{7.0});
    EXPECT_NEAR(view().parameter, 0.8, 1e-15);
    EXPECT_EQ(view().playback.direction, -1);
    editor_.change(Advance{1.0});
    EXPECT_NEAR(view().parameter, 0.7, 1e-15);
    editor_.change(Advance{9.0});
    EXPECT_NEAR(view().parameter, 0.2, 1e-14);
    EXPECT_EQ(view().playback.direction, 1);
    editor_.change(Advance{20.0 * 1000});
    EXPECT_NEAR(view().parameter, 0.2, 1e-10);
}

TEST_F(ViewCommands, play_round_and_round) {
    run(SetKnots{.knots = {10, 10, 10, 10, 20, 20, 20, 20}});
    run(SetParameter{.u = 14.0});
    run(TogglePingPong{});
    run(SetSpeed{.speed = 1.0});
    run(TogglePlay{});
    editor_.change(Advance{1.0});
    EXPECT_NEAR(view().parameter, 16.0, 1e-14);
    editor_.change(Advance{3.0});
    EXPECT_NEAR(view().parameter, 12.0, 1e-14);
    EXPECT_FALSE(run(SetSpeed{.speed = 0.0}));
    EXPECT_EQ(view().playback.speed, 1.0);
}

TEST_F(ViewCommands, play_to_and_fro_on_a_closed_curve) {
    open_text(editor_, sample_text);
    run(ActivateCurve{.index = 1});
    run(SetParameter{.u = 4.0});
    run(SetSpeed{.speed = 1.0});
    run(TogglePlay{});
    editor_.change(Advance{1.0});  // to the end exactly
    editor_.change(Advance{1.0});
    EXPECT_NEAR(view().parameter, 4.0, 1e-14);
}

TEST_F(ViewCommands, step_through_the_levels) {
    run(NextLevel{});
    EXPECT_EQ(view().level, std::nullopt);
    run(PreviousLevel{});
    EXPECT_EQ(view().level, 2);
    for (int i = 0; i < 5; ++i) run(PreviousLevel{});
    EXPECT_EQ(view().level, 0);
    run(NextLevel{});
    EXPECT_EQ(view().level, 1);
    EXPECT_FALSE(run(SetLevel{.level = 4}));
    EXPECT_EQ(editor_.state().message.text, "there is no level 4; the last one is 3");
    EXPECT_TRUE(run(SetLevel{.level = std::nullopt}));
    EXPECT_EQ(view().level, std::nullopt);
}

TEST_F(ViewCommands, fit_everything_that_is_visible) {
    editor_.change(ResizeCanvas{{1000.0, 600.0}});
    EXPECT_FALSE(view().fits_on_open);
    const glm::dvec2 lower = render::screen_from_world(view().camera, {0, 0});
    const glm::dvec2 upper = render::screen_from_world(view().camera, {4, 2});
    EXPECT_NEAR(lower.x + upper.x, 1000.0, 1e-9);
    EXPECT_NEAR(lower.y + upper.y, 600.0, 1e-9);
    EXPECT_GE(lower.x, 0.0);
    EXPECT_GT(upper.x - lower.x, 800.0);
    run(NewCurve{.points = {{100, 100}, {200, 200}}});
    run(SetCurveVisible{.index = 1, .visible = false});
    const render::Camera before = view().camera;
    run(FitView{});
    EXPECT_EQ(view().camera, before);
    run(SetCurveVisible{.index = 1, .visible = true});
    run(FitView{});
    EXPECT_NEAR(view().camera.center.x, 100.0, 1e-9);
}

TEST_F(ViewCommands, resizing_fits_only_the_first_time) {
    editor_.change(ResizeCanvas{{1000.0, 600.0}});
    editor_.change(PanCamera{{100.0, 0.0}});
    const render::Camera before = view().camera;
    editor_.change(ResizeCanvas{{800.0, 500.0}});
    EXPECT_EQ(view().camera.center, before.center);
    EXPECT_DOUBLE_EQ(view().camera.scale, 0.8 * before.scale) << "800 of 1000 pixels show the same";
    EXPECT_EQ(view().camera.size_px, (glm::dvec2{800, 500}));
    editor_.change(ResizeCanvas{{0.0, -5.0}});
    EXPECT_GT(view().camera.size_px.y, 0.0);
}

TEST_F(ViewCommands, zoom_at_the_middle_or_at_a_pixel) {
    editor_.change(ResizeCanvas{{1000.0, 600.0}});
    const glm::dvec2 under = render::world_from_screen(view().camera, {100, 100});
    const double scale = view().camera.scale;
    editor_.change(ZoomCamera{3.0, {100.0, 100.0}});
    EXPECT_NEAR(view().camera.scale, 3.0 * scale, 1e-9);
    EXPECT_NEAR(render::screen_from_world(view().camera, under).x, 100.0, 1e-9);
    const glm::dvec2 center = view().camera.center;
    run(ZoomIn{});
    EXPECT_EQ(view().camera.center, center);
    EXPECT_GT(view().camera.scale, 3.0 * scale);
    run(ZoomOut{});
    EXPECT_NEAR(view().camera.scale, 3.0 * scale, 1e-9);
}

TEST_F(ViewCommands, toggle_overlays_one_by_one) {
    for (std::size_t i = 0; i < overlay_count; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        Overlays expected = view().overlays;
        expected.show(overlay, !expected.is_shown(overlay));
        EXPECT_TRUE(type(toggle_overlay_spec(overlay).name));
        EXPECT_EQ(view().overlays, expected) << core::name_of(overlay);
    }
    const bool has_grid = view().overlays.is_shown(Overlay::grid);
    run(ToggleOverlay<Overlay::grid>{});
    EXPECT_NE(view().overlays.is_shown(Overlay::grid), has_grid);
    for (std::size_t i = 0; i < overlay_count; ++i)
        EXPECT_EQ(core::value_named<Overlay>(core::name_of(static_cast<Overlay>(i))), static_cast<Overlay>(i));
    EXPECT_EQ(core::value_named<Overlay>("nothing"), std::nullopt);
}

TEST_F(ViewCommands, hide_all_views_but_not_the_polygon) {
    EXPECT_FALSE(run(HideViews{}));
    EXPECT_EQ(editor_.state().message.text, "no view of the menu Watch is shown");
    const Overlays before = view().overlays;
    for (const char* name : {"toggle-triangle", "toggle-homogeneous", "toggle-quiz"}) ASSERT_TRUE(type(name));
    EXPECT_TRUE(run(HideViews{}));
    for (std::size_t i = 0; i < overlay_count; ++i) {
        const auto overlay = static_cast<Overlay>(i);
        EXPECT_EQ(view().overlays.is_shown(overlay), i < basic_overlay_count && before.is_shown(overlay)) << i;
    }
    EXPECT_TRUE(view().overlays.is_shown(Overlay::polygon));
}

TEST_F(ViewCommands, an_inset_moves_a_fitted_picture_aside_but_no_chosen_one) {
    Editor& editor = editor_;
    editor.change(ResizeCanvas{{700.0, 500.0}});
    run(FitView{});
    const render::Camera before = view().camera;
    ASSERT_TRUE(type("toggle-homogeneous"));
    EXPECT_NE(view().camera, before);
    ASSERT_TRUE(type("toggle-homogeneous"));
    EXPECT_EQ(view().camera, before);
    editor.change(PanCamera{{10.0, 5.0}});
    const render::Camera chosen = view().camera;
    ASSERT_TRUE(type("toggle-homogeneous"));
    EXPECT_EQ(view().camera, chosen);
}

TEST_F(ViewCommands, scale_the_interface_in_tenths) {
    editor_.change(SetInterfaceScale{2.0});  // a display of two pixels to the point
    run(ScaleUp{});
    EXPECT_NEAR(view().user_scale, 1.1, 1e-12);
    EXPECT_NEAR(view().interface_scale, 2.2, 1e-12);
    for (int i = 0; i < 30; ++i) run(ScaleUp{});
    EXPECT_EQ(view().user_scale, 3.0);
    for (int i = 0; i < 60; ++i) run(ScaleDown{});
    EXPECT_EQ(view().user_scale, 0.5);
    run(ResetScale{});
    EXPECT_EQ(view().user_scale, 1.0);
    EXPECT_NEAR(view().interface_scale, 2.0, 1e-12);
}

TEST_F(ViewCommands, take_tools_themes_and_sizes) {
    for (const Tool tool : all_tools) {
        EXPECT_TRUE(run(SetTool{.tool = tool}));
        EXPECT_EQ(editor_.state().tool, tool);
    }
    EXPECT_TRUE(run(TakeTool<Tool::weight>{}));
    EXPECT_EQ(editor_.state().tool, Tool::weight);
    EXPECT_FALSE(type("set-tool hammer"));
    run(ToggleTheme{});
    EXPECT_EQ(view().theme, ThemeName::light);
    run(ToggleTheme{});
    EXPECT_EQ(view().theme, ThemeName::dark);
    editor_.change(SetInspectorWidth{10.0});
    EXPECT_EQ(view().inspector_width, 240.0);
    editor_.change(SetDockHeight{300.0});
    EXPECT_EQ(view().dock_height, 300.0);
    run(SetKnotMove{.mode = core::KnotMove::push});
    EXPECT_EQ(view().knot_move, core::KnotMove::push);
    EXPECT_FALSE(type("set-knot-move pull"));
    run(ToggleInspector{});
    run(ToggleDock{});
    EXPECT_FALSE(view().inspector_is_open);
    EXPECT_FALSE(view().dock_is_open);
}

TEST_F(ViewCommands, escape_leaves_every_tool_whatever_else_there_is) {
    for (const Tool tool : all_tools) {
        run(SelectPoints{.points = {1}});
        run(SetPoint{.index = 1, .position = {0.0, 0.5 * static_cast<double>(tool)}});
        run(SetTool{.tool = tool});
        editor_.change(ShowRefusal{"no"});
        EXPECT_TRUE(type("escape"));
        EXPECT_EQ(editor_.state().tool, Tool::select);
        EXPECT_EQ(editor_.state().selection.points, (std::vector<std::size_t>{1}));
        EXPECT_EQ(editor_.state().ghost.has_value(), tool != Tool::select) << "one thing at a time";
    }
    run(SetTool{.tool = Tool::weight});
    run(ToggleAbout{});
    EXPECT_TRUE(type("escape"));
    EXPECT_EQ(editor_.state().tool, Tool::weight) << "the dialog first";
}

TEST_F(ViewCommands, zoom_the_plot) {
    editor_.change(SetPlotRange{{0.25, 0.5}});
    EXPECT_EQ(view().plot_range, (core::Interval{0.25, 0.5}));
    EXPECT_TRUE(run(FitPlot{}));
    EXPECT_EQ(view().plot_range, std::nullopt);
}

TEST_F(ViewCommands, write_blossoms_by_value_or_by_index) {
    EXPECT_FALSE(view().blossom_values);
    EXPECT_TRUE(run(SetBlossomValues{.by_value = true}));
    EXPECT_TRUE(view().blossom_values);
    EXPECT_TRUE(run_typed(editor_, "set-blossom-values no"));
    EXPECT_FALSE(view().blossom_values);
}

TEST_F(ViewCommands, hover_only_what_is_there) {
    open_text(editor_, sample_text);
    const auto hovered = [this](const Hover& hover) {
        editor_.change(SetHover{hover});
        return editor_.state().hover;
    };
    for (const Hover& there : std::vector<Hover>{HoveredPoint{6}, HoveredWeightRing{5}, HoveredKnot{10}, HoveredSpan{4},
                                                 HoveredCell{1, 2}, HoveredParameter{}, HoveredCurve{0.3},
                                                 HoveredLeg{5}, HoveredOtherCurve{2}, HoveredBasis{0}})
        EXPECT_EQ(hovered(there), there) << there.index();
    for (const Hover& missing :
         std::vector<Hover>{HoveredNothing{}, HoveredPoint{7}, HoveredWeightRing{7}, HoveredKnot{11}, HoveredSpan{2},
                            HoveredSpan{10}, HoveredCell{1, 3}, HoveredCell{4, 0}, HoveredLeg{6}, HoveredOtherCurve{0},
                            HoveredOtherCurve{3}, HoveredBasis{7}})
        EXPECT_EQ(hovered(missing), Hover(HoveredNothing{})) << missing.index();
    run(ActivateCurve{.index = 1});
    EXPECT_EQ(hovered(HoveredLeg{4}), Hover(HoveredLeg{4}));  // closed: from the last point to the first
}

TEST_F(ViewCommands, open_and_close_dialogs) {
    for (const auto& [command, dialog] :
         std::vector<std::pair<Command, Dialog>>{{TogglePalette{}, Dialog::command_palette},
                                                 {ToggleKeySheet{}, Dialog::key_sheet},
                                                 {ToggleWelcome{}, Dialog::welcome},
                                                 {ToggleAbout{}, Dialog::about}}) {
        run(command);
        EXPECT_EQ(editor_.state().dialog, dialog);
        run(command);
        EXPECT_EQ(editor_.state().dialog, Dialog::none);
    }
    run(ToggleAbout{});
    run(CloseDialog{});
    EXPECT_EQ(editor_.state().dialog, Dialog::none);
    run(SetLevel{.level = 77});
    EXPECT_TRUE(editor_.state().message.is_error);
    editor_.change(SetHover{HoveredNothing{}});
    EXPECT_TRUE(editor_.state().message.is_error);
    run(DismissMessage{});
    EXPECT_EQ(editor_.state().message, Message{});
}

TEST(Key, is_named_as_on_the_keyboard) {
    EXPECT_EQ(text_of({Key::z, {true, true, false}}), "Ctrl+Shift+Z");
    EXPECT_EQ(text_of({Key::digit_0, {true, false, false}}), "Ctrl+0");
    EXPECT_EQ(text_of({Key::f11, {}}), "F11");
    EXPECT_EQ(text_of({Key::page_up, {}}), "Page Up");
    EXPECT_EQ(text_of({Key::delete_key, {false, false, true}}), "Alt+Delete");
    EXPECT_EQ(text_of({Key::period, {}}), ".");
    EXPECT_EQ(text_of({}), "");
}

}  // namespace
}  // namespace batten::editor
