#include <gtest/gtest.h>

#include "sample_editor.h"

namespace batten::editor {
namespace {

class DocumentCommands : public ::testing::Test {
  protected:
    DocumentCommands() { open_text(editor_, sample_text); }

    const EditorState& state() const { return editor_.state(); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const core::DocumentCurve& curve : document(editor_).curves) all.push_back(curve.name);
        return all;
    }

    Editor editor_;
};

using Names = std::vector<std::string>;

TEST_F(DocumentCommands, draw_a_clamped_uniform_curve) {
    EXPECT_TRUE(run("new-curve", {std::vector<double>{0, 0, 1, 1, 2, 0, 3, 1, 4, 0}}));
    EXPECT_EQ(document(editor_).active, 3U);
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_)[3], (core::Point{3, 1}));
    EXPECT_EQ(names().back(), "curve");
    EXPECT_EQ(state().history.undo_label(), "Draw curve");
    EXPECT_TRUE(run("new-curve", {std::vector<double>{0, 0, 1, 1}}));
    EXPECT_EQ(curve(editor_).degree(), 1);
    EXPECT_EQ(names().back(), "curve 2");
    EXPECT_TRUE(run("new-curve", {std::vector<double>{0, 0, 1, 1, 2, 2}, 2.0}));
    EXPECT_EQ(curve(editor_).degree(), 2);
}

TEST_F(DocumentCommands, refuse_half_a_point_and_a_single_one) {
    EXPECT_FALSE(run("new-curve", {std::vector<double>{0, 0, 1}}));
    EXPECT_EQ(state().message.text, "a new curve needs x and y of 2 points or more; 3 coordinates were given");
    EXPECT_FALSE(run("new-curve", {std::vector<double>{0, 0}}));
    EXPECT_FALSE(run("new-curve", {std::vector<double>{0, 0, 1, 1}, 0.0}));
    EXPECT_EQ(document(editor_).curves.size(), 3U);
}

TEST_F(DocumentCommands, delete_a_curve_and_keep_the_active_one) {
    run("activate-curve", {1.0});
    EXPECT_TRUE(run("delete-curve", {0.0}));
    EXPECT_EQ(names(), (Names{"ring", "line"}));
    EXPECT_EQ(document(editor_).active, 0U);
    run("undo");
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_TRUE(run("delete-curve"));
    EXPECT_EQ(names(), (Names{"wave", "line"}));
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_FALSE(run("delete-curve"));  // the line is locked
    run("set-curve-locked", {1.0, 0.0});
    EXPECT_TRUE(run("delete-curve"));
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_TRUE(run("delete-curve"));
    EXPECT_EQ(state().active_curve(), nullptr);
    EXPECT_FALSE(run("delete-curve"));
    EXPECT_FALSE(run("delete-curve", {5.0}));
}

TEST_F(DocumentCommands, duplicate_to_the_right_and_down) {
    run("activate-curve", {2.0});
    EXPECT_TRUE(run("duplicate", {0.5}));
    EXPECT_EQ(names(), (Names{"wave", "ring", "line", "line 2"}));
    EXPECT_EQ(document(editor_).active, 3U);
    EXPECT_FALSE(document(editor_).curves[3].locked);
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0.5, -0.5}, {5.5, 4.5}}));
    EXPECT_TRUE(run("duplicate-curve", {1.0}));
    EXPECT_EQ(names().back(), "ring 2");
    EXPECT_EQ(state().history.undo_label(), "Duplicate curve 'ring'");
    EXPECT_GT(points(editor_)[0].x, 0.0);
}

TEST_F(DocumentCommands, rename_colour_hide_and_lock) {
    EXPECT_TRUE(run("rename-curve", {1.0, "hoop"}));
    EXPECT_EQ(names()[1], "hoop");
    EXPECT_EQ(state().history.undo_label(), "Rename curve 'ring'");
    EXPECT_FALSE(run("rename-curve", {1.0, "wave"}));
    EXPECT_FALSE(run("rename-curve", {1.0, ""}));
    EXPECT_TRUE(run("rename-curve", {1.0, "hoop"}));
    EXPECT_EQ(state().history.undo_count(), 1U);
    EXPECT_TRUE(run("set-curve-color", {0.0, "#4c7Fe0"}));
    EXPECT_EQ(document(editor_).curves[0].color, (core::DocumentColor{0x4c, 0x7f, 0xe0}));
    for (const char* wrong : {"", "4c7fe0", "#4c7fe", "#4c7fe0a", "#4c7fg0", "#-17fe0", "red"})
        EXPECT_FALSE(run("set-curve-color", {0.0, wrong})) << wrong;
    EXPECT_TRUE(run("set-curve-color", {0.0, "none"}));
    EXPECT_EQ(document(editor_).curves[0].color, std::nullopt);
    EXPECT_TRUE(run("set-curve-visible", {1.0, 0.0}));
    EXPECT_FALSE(document(editor_).curves[1].visible);
    EXPECT_EQ(state().history.undo_label(), "Hide curve 'hoop'");
    EXPECT_TRUE(run("set-curve-locked", {2.0, 0.0}));
    EXPECT_FALSE(document(editor_).curves[2].locked);
    EXPECT_FALSE(run("set-curve-visible", {3.0, 0.0}));
    EXPECT_EQ(state().message.text, "there is no curve 3; the document has 3");
}

TEST_F(DocumentCommands, activate_without_a_step) {
    run("select-points", {3.0});
    EXPECT_TRUE(run("activate-curve", {1.0}));
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(run("activate-curve", {3.0}));
    EXPECT_EQ(document(editor_).active, 1U);
}

TEST_F(DocumentCommands, copy_and_paste_between_editors) {
    std::string clipboard;
    Desktop desktop;
    desktop.read_clipboard = [&clipboard] { return clipboard; };
    desktop.write_clipboard = [&clipboard](const std::string& text) { clipboard = text; };
    Editor source(desktop);
    open_text(source, sample_text);
    EXPECT_TRUE(source.run({"copy", {}}));
    EXPECT_FALSE(source.state().is_modified());
    const auto parsed = core::parse_document(clipboard);
    ASSERT_TRUE(parsed) << parsed.error().sentence();
    ASSERT_EQ(parsed->curves.size(), 1U);
    EXPECT_EQ(*parsed->curves[0].curve, curve(source));

    Editor target(desktop);
    EXPECT_TRUE(target.run({"paste", {}}));
    EXPECT_TRUE(target.run({"paste", {}}));
    ASSERT_EQ(document(target).curves.size(), 2U);
    EXPECT_EQ(document(target).curves[1].name, "wave 2");
    EXPECT_EQ(document(target).active, 1U);
    EXPECT_EQ(curve(target), curve(source));
    EXPECT_EQ(target.state().message, (Message{"Pasted", false}));
}

TEST_F(DocumentCommands, cut_keeps_the_text_without_a_desktop_clipboard) {
    EXPECT_TRUE(run("cut"));
    EXPECT_EQ(names(), (Names{"ring", "line"}));
    EXPECT_EQ(state().history.undo_label(), "Cut curve 'wave'");
    EXPECT_TRUE(run("paste"));
    EXPECT_EQ(names(), (Names{"ring", "line", "wave"}));
    EXPECT_TRUE(run("undo"));
    EXPECT_TRUE(run("undo"));
    EXPECT_EQ(names(), (Names{"wave", "ring", "line"}));
}

TEST_F(DocumentCommands, paste_says_what_is_wrong_with_the_clipboard) {
    EXPECT_FALSE(run("paste"));
    EXPECT_EQ(state().message.text.rfind("the clipboard does not hold curves of Batten: ", 0), 0U)
        << state().message.text;
    EXPECT_FALSE(run("paste", {"shopping list"}));
    EXPECT_FALSE(run("paste", {R"({"format":"batten","version":1,"curves":[]})"}));
    EXPECT_EQ(state().message.text, "the clipboard holds a document without curves");
    EXPECT_EQ(document(editor_).curves.size(), 3U);
}

}  // namespace
}  // namespace batten::editor
