#include "app/editor/commands/document_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class DocumentCommands : public ::testing::Test {
  protected:
    DocumentCommands() { open_text(editor_, sample_text); }

    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const core::DocumentCurve& curve : document(editor_).curves) all.push_back(curve.name);
        return all;
    }

    Editor editor_;
};

using Names = std::vector<std::string>;

TEST_F(DocumentCommands, draw_a_clamped_uniform_curve) {
    EXPECT_TRUE(run(NewCurve{.points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}}}));
    EXPECT_EQ(document(editor_).active, 3U);
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_)[3], (core::Point{3, 1}));
    EXPECT_EQ(names().back(), "curve");
    EXPECT_EQ(state().history.undo_label(), "Draw curve");
    EXPECT_TRUE(run(NewCurve{.points = {{0, 0}, {1, 1}}}));
    EXPECT_EQ(curve(editor_).degree(), 1);
    EXPECT_EQ(names().back(), "curve 2");
    EXPECT_TRUE(run(NewCurve{.points = {{0, 0}, {1, 1}, {2, 2}}, .degree = 2}));
    EXPECT_EQ(curve(editor_).degree(), 2);
}

TEST_F(DocumentCommands, refuse_half_a_point_and_a_single_one) {
    EXPECT_FALSE(type("new-curve 0,0,1"));
    EXPECT_EQ(state().message.text, "coordinates has 3 numbers; x and y of each point are needed");
    EXPECT_FALSE(run(NewCurve{.points = {{0, 0}}}));
    EXPECT_FALSE(run(NewCurve{.points = {{0, 0}, {1, 1}}, .degree = 0}));
    EXPECT_EQ(document(editor_).curves.size(), 3U);
}

TEST_F(DocumentCommands, delete_a_curve_and_keep_the_active_one) {
    run(ActivateCurve{.index = 1});
    EXPECT_TRUE(run(DeleteCurve{.index = 0}));
    EXPECT_EQ(names(), (Names{"ring", "line"}));
    EXPECT_EQ(document(editor_).active, 0U);
    run(Undo{});
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_TRUE(type("delete-curve"));
    EXPECT_EQ(names(), (Names{"wave", "line"}));
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_FALSE(type("delete-curve"));  // the line is locked
    run(SetCurveLocked{.index = 1, .locked = false});
    EXPECT_TRUE(type("delete-curve"));
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_TRUE(type("delete-curve"));
    EXPECT_EQ(state().active_curve(), nullptr);
    EXPECT_FALSE(type("delete-curve"));
    EXPECT_FALSE(run(DeleteCurve{.index = 5}));
}

TEST_F(DocumentCommands, duplicate_to_the_right_and_down) {
    run(ActivateCurve{.index = 2});
    EXPECT_TRUE(run(Duplicate{.shift = 0.5}));
    EXPECT_EQ(names(), (Names{"wave", "ring", "line", "line 2"}));
    EXPECT_EQ(document(editor_).active, 3U);
    EXPECT_FALSE(document(editor_).curves[3].locked);
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0.5, -0.5}, {5.5, 4.5}}));
    EXPECT_TRUE(type("duplicate-curve 1"));
    EXPECT_EQ(names().back(), "ring 2");
    EXPECT_EQ(state().history.undo_label(), "Duplicate curve 'ring'");
    EXPECT_GT(points(editor_)[0].x, 0.0);
}

TEST_F(DocumentCommands, rename_color_hide_and_lock) {
    EXPECT_TRUE(run(RenameCurve{.index = 1, .name = "hoop"}));
    EXPECT_EQ(names()[1], "hoop");
    EXPECT_EQ(state().history.undo_label(), "Rename curve 'ring'");
    EXPECT_FALSE(run(RenameCurve{.index = 1, .name = "wave"}));
    EXPECT_FALSE(run(RenameCurve{.index = 1, .name = ""}));
    EXPECT_TRUE(run(RenameCurve{.index = 1, .name = "hoop"}));
    EXPECT_EQ(state().history.undo_count(), 1U);
    EXPECT_TRUE(run(SetCurveColor{.index = 0, .color = core::DocumentColor{76, 127, 224}}));
    EXPECT_EQ(document(editor_).curves[0].color, (core::DocumentColor{0x4c, 0x7f, 0xe0}));
    for (const char* wrong : {"", "4c7fe0", "#4c7fe", "#4c7fe0a", "#4c7fg0", "#-17fe0", "red"})
        EXPECT_FALSE(type("set-curve-color 0 \"" + std::string(wrong) + "\"")) << wrong;
    EXPECT_TRUE(run(SetCurveColor{.index = 0, .color = std::nullopt}));
    EXPECT_EQ(document(editor_).curves[0].color, std::nullopt);
    EXPECT_TRUE(run(SetCurveVisible{.index = 1, .visible = false}));
    EXPECT_FALSE(document(editor_).curves[1].visible);
    EXPECT_EQ(state().history.undo_label(), "Hide curve 'hoop'");
    EXPECT_TRUE(run(SetCurveLocked{.index = 2, .locked = false}));
    EXPECT_FALSE(document(editor_).curves[2].locked);
    EXPECT_FALSE(run(SetCurveVisible{.index = 3, .visible = false}));
    EXPECT_EQ(state().message.text, "there is no curve 3; the last one is 2");
}

TEST_F(DocumentCommands, activate_without_a_step) {
    run(SelectPoints{.points = {3}});
    EXPECT_TRUE(run(ActivateCurve{.index = 1}));
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(run(ActivateCurve{.index = 3}));
    EXPECT_EQ(document(editor_).active, 1U);
}

TEST_F(DocumentCommands, copy_and_paste_between_editors) {
    std::string clipboard;
    Desktop desktop;
    desktop.read_clipboard = [&clipboard] { return clipboard; };
    desktop.write_clipboard = [&clipboard](const std::string& text) { clipboard = text; };
    Editor source(desktop);
    open_text(source, sample_text);
    EXPECT_TRUE(source.run(Copy{}));
    EXPECT_FALSE(source.state().is_modified());
    const auto parsed = core::parse_document(clipboard);
    ASSERT_TRUE(parsed) << parsed.error().sentence();
    ASSERT_EQ(parsed->curves.size(), 1U);
    EXPECT_EQ(*parsed->curves[0].curve, curve(source));

    Editor target(desktop);
    EXPECT_TRUE(run_typed(target, "paste"));
    EXPECT_TRUE(run_typed(target, "paste"));
    ASSERT_EQ(document(target).curves.size(), 2U);
    EXPECT_EQ(document(target).curves[1].name, "wave 2");
    EXPECT_EQ(document(target).active, 1U);
    EXPECT_EQ(curve(target), curve(source));
    EXPECT_EQ(target.state().message, (Message{"Pasted", false}));
}

TEST_F(DocumentCommands, paste_beside_what_is_there_and_in_place_elsewhere) {
    const std::vector<core::Point> original = points(editor_);
    const auto offset = [&] { return points(editor_)[3] - original[3]; };
    EXPECT_TRUE(run(Copy{}));
    // The camera shows 64 px for a unit: the minor lines of its grid are 0.5 apart.
    for (const double expected : {0.5, 1.0, 1.5}) {
        EXPECT_TRUE(type("paste-beside"));
        EXPECT_NEAR(offset().x, expected, 1e-15);
        EXPECT_NEAR(offset().y, -expected, 1e-15);
    }
    EXPECT_EQ(names(), (Names{"wave", "ring", "line", "wave 2", "wave 3", "wave 4"}));
    EXPECT_EQ(state().message, (Message{"Pasted", false}));
    EXPECT_TRUE(type("paste"));
    EXPECT_EQ(points(editor_), original);
    run(DeleteCurve{.index = 3});
    EXPECT_TRUE(type("paste-beside")) << "the place of the deleted one is free";
    EXPECT_NEAR(offset().x, 0.5, 1e-15);
    run(DeleteCurve{.index = 0});
    run(Cut{});
    EXPECT_TRUE(type("paste-beside"));
    EXPECT_NEAR(offset().x, 0.5, 1e-15) << "what was cut comes back to its place";
}

TEST_F(DocumentCommands, paste_beside_steps_in_pixels_of_the_view) {
    const core::Point original = points(editor_)[0];
    run(Copy{});
    editor_.change(ZoomCamera{0.01, {640.0, 360.0}});
    EXPECT_TRUE(type("paste-beside"));
    const double px = (points(editor_)[0].x - original.x) * state().view.camera.scale;
    EXPECT_GE(px, 16.0);
    EXPECT_LE(px, 40.0);
}

TEST_F(DocumentCommands, cut_keeps_the_text_without_a_desktop_clipboard) {
    EXPECT_TRUE(run(Cut{}));
    EXPECT_EQ(names(), (Names{"ring", "line"}));
    EXPECT_EQ(state().history.undo_label(), "Cut curve 'wave'");
    EXPECT_TRUE(type("paste"));
    EXPECT_EQ(names(), (Names{"ring", "line", "wave"}));
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(Undo{}));
    EXPECT_EQ(names(), (Names{"wave", "ring", "line"}));
}

TEST_F(DocumentCommands, paste_says_what_is_wrong_with_the_clipboard) {
    EXPECT_FALSE(type("paste"));
    EXPECT_EQ(state().message.text.rfind("the clipboard holds no Batten curves: ", 0), 0U) << state().message.text;
    EXPECT_FALSE(run(Paste{.text = "shopping list"}));
    EXPECT_FALSE(run(Paste{.text = R"({"format":"batten","version":1,"curves":[]})"}));
    EXPECT_EQ(state().message.text, "the clipboard holds a document without curves");
    EXPECT_EQ(document(editor_).curves.size(), 3U);
}

}  // namespace
}  // namespace batten::editor
