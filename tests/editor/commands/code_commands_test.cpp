#include "app/editor/commands/code_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_reader.h"
#include "app/editor/commands/edit_commands.h"
#include "core/document/native_file.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class CodeCommands : public testing::Test {
  protected:
    bool type(const std::string& text) { return run_typed(editor, text); }
    const std::string& said() const { return editor.state().message.text; }
    const std::string& copied() const { return editor.state().clipboard; }

    Editor editor = test::zigzag_editor();
};

TEST_F(CodeCommands, copy_what_the_library_writes) {
    const std::string step = editor.state().history.undo_label();
    for (const auto& language : core::Names<exchange::CodeLanguage>::table) {
        const core::DocumentCurve& entry = *editor.state().history.present().active_curve();
        const std::string text = exchange::code_of(entry, language.value)->text;
        EXPECT_TRUE(type(std::string("copy-as ") + std::string(language.name)));
        EXPECT_EQ(copied(), text);
        EXPECT_EQ(said(), "Copied curve 'curve' as " + std::string(language.title));
        editor.run(CopyText{});
        EXPECT_TRUE(type("copy-as-" + std::string(language.name)));
        EXPECT_EQ(copied(), text);
    }
    EXPECT_FALSE(type("copy-as fortran"));
    EXPECT_EQ(editor.state().history.undo_label(), step);
}

TEST_F(CodeCommands, copy_a_document_that_can_be_pasted) {
    ASSERT_TRUE(type("copy-as json"));
    ASSERT_TRUE(type("paste"));
    const core::Document& document = editor.state().history.present();
    ASSERT_EQ(document.curves.size(), 2u);
    EXPECT_EQ(*document.curves[0].curve, *document.curves[1].curve);
}

TEST_F(CodeCommands, tell_how_far_cubics_are_from_the_curve) {
    ASSERT_TRUE(type("set-units mm"));
    ASSERT_TRUE(type("circle 0 0 16"));
    ASSERT_TRUE(type("copy-as svg-path"));
    EXPECT_EQ(said(), "Copied curve 'circle' as SVG path");  // whose arcs are exact
    ASSERT_TRUE(type("copy-as tikz"));
    EXPECT_EQ(said().find("Copied curve 'circle' as TikZ; no point of it is farther than "), 0u) << said();
    EXPECT_NE(said().find(" mm from the curve"), std::string::npos) << said();
    ASSERT_TRUE(type("copy-as python"));
    EXPECT_EQ(said(), "Copied curve 'circle' as Python");
}

TEST(CodeCommandsWithoutCurves, are_refused) {
    Editor editor;
    EXPECT_FALSE(run_typed(editor, "copy-as python"));
    EXPECT_FALSE(run_typed(editor, "copy-as-tikz"));
}

}  // namespace
}  // namespace batten::editor
