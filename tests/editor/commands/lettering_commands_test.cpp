#include "app/editor/commands/lettering_commands.h"

#include <gtest/gtest.h>

#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

const std::filesystem::path fonts = std::filesystem::path(BATTEN_TEST_DATA) / "exchange";

TEST(LetteringCommands, add_the_outlines_of_letters) {
    Editor editor;
    ASSERT_TRUE(
        editor.run(TextOutlines{.path = fonts / "quadratic.ttf", .text = "Lo", .position = {3, 4}, .size = 2000.0}))
        << editor.state().message.text;
    ASSERT_EQ(document(editor).curves.size(), 3U);
    EXPECT_EQ(document(editor).active_curve()->name, "L");
    EXPECT_EQ(curve(editor).degree(), 1);
    core::Box box;
    for (const core::Point& point : points(editor)) box.include(point);
    EXPECT_EQ(box.lower, core::Point(3 + 2 * 50, 4)) << "an em is 1000 units";
    EXPECT_EQ(box.upper, core::Point(3 + 2 * 450, 4 + 2 * 700));
    EXPECT_EQ(document(editor).curves[1].curve->degree(), 2);
    EXPECT_EQ(document(editor).curves[2].group, "o");
    EXPECT_EQ(editor.state().message.text, "Made outlines of 'Lo'");
    EXPECT_EQ(editor.state().history.undo_label(), "Make outlines of a text");
}

TEST(LetteringCommands, tell_what_a_font_does_not_have) {
    Editor editor;
    EXPECT_TRUE(editor.run(TextOutlines{.path = fonts / "cubic.otf", .text = "LЖ", .position = {0, 0}, .size = 1.0}));
    EXPECT_EQ(editor.state().message.text, "Made outlines of 'LЖ'; the font has no 'Ж', which is left out");
}

TEST(LetteringCommands, refuse_what_is_no_font) {
    Editor editor;
    const std::size_t before = document(editor).curves.size();
    const auto refusal_of = [&](const std::string& name, const std::string& text, double size) {
        EXPECT_FALSE(editor.run(TextOutlines{.path = fonts / name, .text = text, .position = {0, 0}, .size = size}));
        EXPECT_EQ(document(editor).curves.size(), before);
        return editor.state().message.text;
    };
    EXPECT_EQ(refusal_of("shapes.svg", "L", 1),
              "shapes.svg: this is no font, or a damaged one; TrueType, OpenType and Type 1 are read");
    EXPECT_EQ(refusal_of("none.ttf", "L", 1), "none.ttf: the file cannot be opened: No such file or directory");
    EXPECT_EQ(refusal_of(".", "L", 1), ".: this is not an ordinary file; a font is needed");
    EXPECT_EQ(refusal_of("cubic.otf", " ", 1), "cubic.otf: the text has no letter that is drawn");
    EXPECT_NE(refusal_of("cubic.otf", "L", 0), "");
}

TEST(LetteringCommands, are_typed) {
    Editor editor;
    EXPECT_TRUE(run_typed(editor, "text-outlines \"" + (fonts / "cubic.otf").string() + "\" L"))
        << editor.state().message.text;
    EXPECT_EQ(document(editor).active_curve()->name, "L");
}

}  // namespace
}  // namespace batten::editor
