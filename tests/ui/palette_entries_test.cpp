#include "app/ui/palette_entries.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/ui/fuzzy_match.h"

namespace batten::ui {
namespace {

/// A palette without examples.
class PaletteEntries : public testing::Test {
  protected:
    std::vector<std::string> titles(const std::string& typed) {
        const PanelContext context{state_,  fonts_, editor::theme_of(editor::ThemeName::dark), 1.0, queue_, panels_,
                                   places_, input_};
        std::vector<std::string> found;
        for (const PaletteEntry& entry : find_entries(context, typed)) found.push_back(entry.title);
        return found;
    }

  private:
    editor::EditorState state_;
    Fonts fonts_;
    editor::CommandQueue queue_;
    PanelState panels_;
    std::vector<WidgetPlace> places_;
    FrameInput input_;
};

TEST_F(PaletteEntries, begin_with_the_title_that_was_typed_then_with_titles_that_go_on) {
    const auto found = titles("hodograph");
    ASSERT_GE(found.size(), 3U);
    EXPECT_EQ(found[0], "Hodograph");
    EXPECT_EQ(found[1], "Hodograph as a curve");
    EXPECT_NE(std::ranges::find(found, "Second hodograph"), found.end());
    EXPECT_EQ(titles("HODOGRAPH").front(), "Hodograph");
    EXPECT_EQ(titles("derivative").front(), "Hodograph as a curve") << "the name of the command";
}

TEST_F(PaletteEntries, find_every_view_first_by_its_title) {
    for (std::size_t i = 0; i < editor::overlay_count; ++i) {
        const std::string title = editor::toggle_overlay_spec(static_cast<editor::Overlay>(i)).title;
        const auto found = titles(title);
        ASSERT_FALSE(found.empty()) << title;
        EXPECT_EQ(found.front(), title);
    }
}

// "copy" takes no arguments, so that it does not keep those from sight whose titles go on.
TEST_F(PaletteEntries, go_on_behind_the_name_of_a_command_without_fields) {
    const auto found = titles("copy as");
    ASSERT_GE(found.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_TRUE(found[i].starts_with("Copy as")) << found[i];
    EXPECT_EQ(spec_being_typed("copy as"), nullptr);
    EXPECT_EQ(spec_being_typed("insert-knot 0.5"), &editor::InsertKnot::spec());
}

TEST(BeginningOf, is_whole_a_prefix_or_none_whatever_the_case_and_accents) {
    EXPECT_EQ(beginning_of("bezier PIECES", "Bézier pieces"), Beginning::whole);
    EXPECT_EQ(beginning_of("bézier", "Bezier pieces"), Beginning::prefix);
    EXPECT_EQ(beginning_of("pieces", "Bézier pieces"), Beginning::none);
    EXPECT_EQ(beginning_of("Bézier pieces of it", "Bézier pieces"), Beginning::none);
    EXPECT_EQ(beginning_of("", "Bézier pieces"), Beginning::none);
}

}  // namespace
}  // namespace batten::ui
