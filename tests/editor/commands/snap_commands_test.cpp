#include "app/editor/commands/snap_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_table.h"
#include "app/editor/state/settings.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class SnapCommands : public testing::Test {
  protected:
    void SetUp() override { open_text(editor, bezier_text); }
    const std::vector<core::Guide>& guides() const { return document(editor).guides; }
    const std::string& said() const { return editor.state().message.text; }

    Editor editor;
};

TEST_F(SnapCommands, guides_are_added_moved_removed_and_undone) {
    EXPECT_TRUE(run_typed(editor, "add-guide 1 2 90"));
    EXPECT_EQ(said(), "Added a guide");
    EXPECT_TRUE(run_typed(editor, "add-guide 0 0 -30"));
    EXPECT_EQ(guides(), (std::vector<core::Guide>{{{1, 2}, 90.0}, {{0, 0}, 150.0}}));
    EXPECT_TRUE(run_typed(editor, "add-guide 3 4 180"));
    EXPECT_EQ(guides()[2].angle, 0.0);
    EXPECT_TRUE(run_typed(editor, "move-guide 0 5 6"));
    EXPECT_EQ(guides()[0], (core::Guide{{5, 6}, 90.0}));
    EXPECT_TRUE(run_typed(editor, "remove-guide 1"));
    EXPECT_EQ(guides().size(), 2U);
    EXPECT_FALSE(run_typed(editor, "remove-guide 2"));
    EXPECT_EQ(said(), "there is no such guide; the document has 2");
    EXPECT_TRUE(run_typed(editor, "remove-guides"));
    EXPECT_FALSE(run_typed(editor, "remove-guides"));
    EXPECT_EQ(said(), "the document has no guides");
    for (int i = 0; i < 6; ++i) EXPECT_TRUE(run_typed(editor, "undo"));
    EXPECT_TRUE(guides().empty());
    EXPECT_FALSE(editor.state().is_modified());
}

TEST_F(SnapCommands, kinds_are_switched_and_kept) {
    const SnapKinds& kinds = editor.state().view.snap.kinds;
    for (const auto& kind : core::Names<SnapKind>::table) {
        const bool was_on = kinds.has(kind.value);
        EXPECT_EQ(was_on, kind.value == SnapKind::guides || kind.value == SnapKind::points ||
                              kind.value == SnapKind::ends || kind.value == SnapKind::intersections);
        EXPECT_TRUE(editor.run(Command(toggle_snap_spec(kind.value), toggle_snap_spec(kind.value).run.make())));
        EXPECT_EQ(kinds.has(kind.value), !was_on);
        EXPECT_EQ(toggle_snap_spec(kind.value).is_checked(editor.state()), !was_on);
    }
    EXPECT_TRUE(run_typed(editor, "set-snap grid no"));
    EXPECT_TRUE(run_typed(editor, "set-snap tangent yes"));
    EXPECT_TRUE(run_typed(editor, "set-angle-step 22.5"));
    EXPECT_FALSE(run_typed(editor, "set-angle-step 0"));
    const Settings settings = parse_settings(format_settings(settings_of(editor.state())));
    EXPECT_EQ(settings.snap, editor.state().view.snap);
    EXPECT_FALSE(settings.snap.kinds.has(SnapKind::grid));
    EXPECT_EQ(settings.snap.angle_step, 22.5);
    EXPECT_EQ(parse_settings("{\"snap\": {\"grid\": 3, \"knots\": true, \"angle_step\": 500}}").snap.angle_step, 90.0);
}

}  // namespace
}  // namespace batten::editor
