#include <gtest/gtest.h>

#include "app/editor/key.h"
#include "core/measure/bounds.h"
#include "sample_editor.h"

namespace batten::editor {
namespace {

class ViewCommands : public ::testing::Test {
  protected:
    ViewCommands() { open_text(editor_, bezier_text); }

    const View& view() const { return editor_.state().view; }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }

    Editor editor_;
};

TEST_F(ViewCommands, clamp_the_parameter_to_the_domain) {
    EXPECT_EQ(editor_.state().parameter(), 0.5);
    EXPECT_TRUE(run("set-parameter", {0.25}));
    EXPECT_EQ(editor_.state().parameter(), 0.25);
    EXPECT_TRUE(run("set-parameter", {7.0}));
    EXPECT_EQ(editor_.state().parameter(), 1.0);
    run("step-parameter-back");
    EXPECT_NEAR(editor_.state().parameter(), 0.99, 1e-15);
    run("step-parameter-forward");
    run("step-parameter-forward");
    EXPECT_EQ(editor_.state().parameter(), 1.0);
}

TEST_F(ViewCommands, wrap_the_parameter_of_a_closed_curve) {
    open_text(editor_, sample_text);
    run("activate-curve", {1.0});
    run("set-parameter", {6.5});
    EXPECT_EQ(editor_.state().parameter(), 1.5);
}

TEST_F(ViewCommands, play_to_and_fro) {
    run("set-parameter", {0.4});
    EXPECT_TRUE(run("advance", {1.0}));
    EXPECT_EQ(view().parameter, 0.4);  // not playing
    run("toggle-play");
    run("advance", {1.0});  // speed 0.5: a tenth of the domain in a second
    EXPECT_NEAR(view().parameter, 0.5, 1e-15);
    run("advance", {7.0});
    EXPECT_NEAR(view().parameter, 0.8, 1e-15);
    EXPECT_EQ(view().playback.direction, -1);
    run("advance", {1.0});
    EXPECT_NEAR(view().parameter, 0.7, 1e-15);
    run("advance", {9.0});
    EXPECT_NEAR(view().parameter, 0.2, 1e-14);
    EXPECT_EQ(view().playback.direction, 1);
    run("advance", {20.0 * 1000});
    EXPECT_NEAR(view().parameter, 0.2, 1e-10);
    EXPECT_FALSE(run("advance", {-1.0}));
}

TEST_F(ViewCommands, play_round_and_round) {
    run("set-knots", {std::vector<double>{10, 10, 10, 10, 20, 20, 20, 20}});
    run("set-parameter", {14.0});
    run("toggle-ping-pong");
    run("set-speed", {1.0});
    run("toggle-play");
    run("advance", {1.0});
    EXPECT_NEAR(view().parameter, 16.0, 1e-14);
    run("advance", {3.0});
    EXPECT_NEAR(view().parameter, 12.0, 1e-14);
    EXPECT_FALSE(run("set-speed", {0.0}));
    EXPECT_EQ(view().playback.speed, 1.0);
}

TEST_F(ViewCommands, play_to_and_fro_on_a_closed_curve) {
    open_text(editor_, sample_text);
    run("activate-curve", {1.0});
    run("set-parameter", {4.0});
    run("set-speed", {1.0});
    run("toggle-play");
    run("advance", {1.0});  // to the end exactly
    run("advance", {1.0});
    EXPECT_NEAR(view().parameter, 4.0, 1e-14);
}

TEST_F(ViewCommands, step_through_the_levels) {
    run("next-level");
    EXPECT_EQ(view().level, std::nullopt);
    run("previous-level");
    EXPECT_EQ(view().level, 2);
    for (int i = 0; i < 5; ++i) run("previous-level");
    EXPECT_EQ(view().level, 0);
    run("next-level");
    EXPECT_EQ(view().level, 1);
    EXPECT_FALSE(run("set-level", {4.0}));
    EXPECT_EQ(editor_.state().message.text, "there is no level 4; the last one is 3");
    EXPECT_TRUE(run("set-level", {-1.0}));
    EXPECT_EQ(view().level, std::nullopt);
}

TEST_F(ViewCommands, fit_everything_that_is_visible) {
    run("resize-canvas", {1000.0, 600.0});
    EXPECT_FALSE(view().fits_on_open);
    const glm::dvec2 lower = render::screen_from_world(view().camera, {0, 0});
    const glm::dvec2 upper = render::screen_from_world(view().camera, {4, 2});
    EXPECT_NEAR(lower.x + upper.x, 1000.0, 1e-9);
    EXPECT_NEAR(lower.y + upper.y, 600.0, 1e-9);
    EXPECT_GE(lower.x, 0.0);
    EXPECT_GT(upper.x - lower.x, 800.0);
    run("new-curve", {std::vector<double>{100, 100, 200, 200}});
    run("set-curve-visible", {1.0, 0.0});
    const render::Camera before = view().camera;
    run("fit");
    EXPECT_EQ(view().camera, before);
    run("set-curve-visible", {1.0, 1.0});
    run("fit");
    EXPECT_NEAR(view().camera.center.x, 100.0, 1e-9);
}

TEST_F(ViewCommands, resizing_fits_only_the_first_time) {
    run("resize-canvas", {1000.0, 600.0});
    run("pan-camera", {100.0, 0.0});
    const render::Camera before = view().camera;
    run("resize-canvas", {800.0, 500.0});
    EXPECT_EQ(view().camera.center, before.center);
    EXPECT_EQ(view().camera.scale, before.scale);
    EXPECT_EQ(view().camera.size_px, (glm::dvec2{800, 500}));
    EXPECT_TRUE(run("resize-canvas", {0.0, -5.0}));
    EXPECT_GT(view().camera.size_px.y, 0.0);
}

TEST_F(ViewCommands, zoom_at_the_middle_or_at_a_pixel) {
    run("resize-canvas", {1000.0, 600.0});
    const glm::dvec2 under = render::world_from_screen(view().camera, {100, 100});
    const double scale = view().camera.scale;
    run("zoom-camera", {3.0, 100.0, 100.0});
    EXPECT_NEAR(view().camera.scale, 3.0 * scale, 1e-9);
    EXPECT_NEAR(render::screen_from_world(view().camera, under).x, 100.0, 1e-9);
    EXPECT_FALSE(run("zoom-camera", {0.0, 1.0, 1.0}));
    const glm::dvec2 center = view().camera.center;
    run("zoom-in");
    EXPECT_EQ(view().camera.center, center);
    EXPECT_GT(view().camera.scale, 3.0 * scale);
    run("zoom-out");
    EXPECT_NEAR(view().camera.scale, 3.0 * scale, 1e-9);
}

TEST_F(ViewCommands, toggle_overlays_one_by_one) {
    const std::vector<std::pair<std::string, Overlay>> toggles{{"toggle-polygon", Overlay::polygon},
                                                               {"toggle-hull", Overlay::hull},
                                                               {"toggle-pieces", Overlay::bezier_pieces},
                                                               {"toggle-comb", Overlay::curvature_comb},
                                                               {"toggle-knots", Overlay::knots},
                                                               {"toggle-hodograph", Overlay::hodograph},
                                                               {"toggle-labels", Overlay::labels},
                                                               {"toggle-grid", Overlay::grid},
                                                               {"toggle-construction", Overlay::construction}};
    for (const auto& [name, overlay] : toggles) {
        Overlays expected = view().overlays;
        expected.show(overlay, !expected.is_shown(overlay));
        EXPECT_TRUE(run(name));
        EXPECT_EQ(view().overlays, expected) << name;
    }
    for (std::size_t i = 0; i < overlay_count; ++i)
        EXPECT_EQ(core::value_named<Overlay>(core::name_of(static_cast<Overlay>(i))), static_cast<Overlay>(i));
    EXPECT_EQ(core::value_named<Overlay>("nothing"), std::nullopt);
}

TEST_F(ViewCommands, scale_the_interface_in_tenths) {
    run("set-interface-scale", {2.0});  // a display of two pixels to the point
    run("scale-up");
    EXPECT_NEAR(view().user_scale, 1.1, 1e-12);
    EXPECT_NEAR(view().interface_scale, 2.2, 1e-12);
    for (int i = 0; i < 30; ++i) run("scale-up");
    EXPECT_EQ(view().user_scale, 3.0);
    for (int i = 0; i < 60; ++i) run("scale-down");
    EXPECT_EQ(view().user_scale, 0.5);
    run("scale-reset");
    EXPECT_EQ(view().user_scale, 1.0);
    EXPECT_NEAR(view().interface_scale, 2.0, 1e-12);
    run("set-user-scale", {1.5});
    EXPECT_EQ(view().user_scale, 1.5);
}

TEST_F(ViewCommands, take_tools_themes_and_sizes) {
    for (const Tool tool : all_tools) {
        EXPECT_TRUE(run("set-tool", {core::name_of(tool)}));
        EXPECT_EQ(editor_.state().tool, tool);
    }
    EXPECT_TRUE(run("tool-weight"));
    EXPECT_EQ(editor_.state().tool, Tool::weight);
    EXPECT_FALSE(run("set-tool", {"hammer"}));
    run("toggle-theme");
    EXPECT_EQ(view().theme, ThemeName::light);
    run("set-theme", {"dark"});
    EXPECT_EQ(view().theme, ThemeName::dark);
    EXPECT_FALSE(run("set-theme", {"pink"}));
    run("set-inspector-width", {10.0});
    EXPECT_EQ(view().inspector_width, 240.0);
    run("set-dock-height", {300.0});
    EXPECT_EQ(view().dock_height, 300.0);
    run("set-knot-move", {"push"});
    EXPECT_EQ(view().knot_move, core::KnotMove::push);
    EXPECT_FALSE(run("set-knot-move", {"pull"}));
    run("toggle-inspector");
    run("toggle-dock");
    EXPECT_FALSE(view().inspector_is_open);
    EXPECT_FALSE(view().dock_is_open);
}

TEST_F(ViewCommands, zoom_the_plot) {
    EXPECT_TRUE(run("set-plot-range", {0.25, 0.5}));
    EXPECT_EQ(view().plot_range, (core::Interval{0.25, 0.5}));
    EXPECT_FALSE(run("set-plot-range", {0.5, 0.5}));
    EXPECT_EQ(editor_.state().message.text, "the plot cannot show 0.5 to 0.5; the first must be less than the second");
    EXPECT_TRUE(run("fit-plot"));
    EXPECT_EQ(view().plot_range, std::nullopt);
}

TEST_F(ViewCommands, hover_only_what_is_there) {
    open_text(editor_, sample_text);
    const auto hovered = [this](const char* kind, std::vector<double> values) {
        return run("hover", {kind, std::move(values)}) ? editor_.state().hover : Hover(HoveredNothing{});
    };
    EXPECT_EQ(hovered("point", {6}), Hover(HoveredPoint{6}));
    EXPECT_EQ(hovered("ring", {5}), Hover(HoveredWeightRing{5}));
    EXPECT_EQ(hovered("knot", {10}), Hover(HoveredKnot{10}));
    EXPECT_EQ(hovered("span", {4}), Hover(HoveredSpan{4}));
    EXPECT_EQ(hovered("cell", {1, 2}), Hover(HoveredCell{1, 2}));
    EXPECT_EQ(hovered("parameter", {}), Hover(HoveredParameter{}));
    EXPECT_EQ(hovered("curve", {0.3}), Hover(HoveredCurve{0.3}));
    EXPECT_EQ(hovered("leg", {5}), Hover(HoveredLeg{5}));
    EXPECT_EQ(hovered("other", {2}), Hover(HoveredOtherCurve{2}));
    EXPECT_EQ(hovered("basis", {0}), Hover(HoveredBasis{0}));
    EXPECT_TRUE(run("hover", {"none"}));
    EXPECT_EQ(editor_.state().hover, Hover(HoveredNothing{}));
    for (const auto& [kind, values] : std::vector<std::pair<const char*, std::vector<double>>>{{"point", {7}},
                                                                                               {"ring", {7}},
                                                                                               {"knot", {11}},
                                                                                               {"span", {2}},
                                                                                               {"span", {10}},
                                                                                               {"cell", {1, 3}},
                                                                                               {"cell", {4, 0}},
                                                                                               {"leg", {6}},
                                                                                               {"other", {0}},
                                                                                               {"other", {3}},
                                                                                               {"basis", {7}},
                                                                                               {"point", {}},
                                                                                               {"point", {0.5}},
                                                                                               {"wing", {1}}})
        EXPECT_FALSE(run("hover", {kind, values})) << kind;
    run("activate-curve", {1.0});
    EXPECT_EQ(hovered("leg", {4}), Hover(HoveredLeg{4}));  // closed: from the last point to the first
}

TEST_F(ViewCommands, open_and_close_dialogs) {
    for (const auto& [name, dialog] :
         std::vector<std::pair<const char*, Dialog>>{{"command-palette", Dialog::command_palette},
                                                     {"key-sheet", Dialog::key_sheet},
                                                     {"welcome", Dialog::welcome},
                                                     {"about", Dialog::about}}) {
        run(name);
        EXPECT_EQ(editor_.state().dialog, dialog);
        run(name);
        EXPECT_EQ(editor_.state().dialog, Dialog::none);
    }
    run("about");
    run("close-dialog");
    EXPECT_EQ(editor_.state().dialog, Dialog::none);
    run("set-level", {77.0});
    EXPECT_TRUE(editor_.state().message.is_error);
    run("hover", {"none"});
    EXPECT_TRUE(editor_.state().message.is_error);
    run("dismiss-message");
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
