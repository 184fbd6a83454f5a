#include "app/editor/pointer/context_menu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class ContextMenu : public ::testing::Test {
  protected:
    ContextMenu() { open_text(editor_, sample_text); }

    const EditorState& state() const { return editor_.state(); }

    /// Opens the menu as a right click does.
    std::vector<MenuEntry> open(const MenuTarget& target) {
        CommandQueue queue;
        select_for_menu(state(), target, queue);
        editor_.perform(queue);
        return context_menu(state(), target);
    }

    static bool offers(const std::vector<MenuEntry>& menu, const CommandSpec& spec) {
        return std::any_of(menu.begin(), menu.end(), [&spec](const MenuEntry& entry) { return entry.spec == &spec; });
    }

    /// Chooses the entry of `spec`, whose fields the menu has filled in.
    void choose(const std::vector<MenuEntry>& menu, const CommandSpec& spec) {
        const auto entry = std::find_if(menu.begin(), menu.end(), [&spec](const auto& e) { return e.spec == &spec; });
        ASSERT_NE(entry, menu.end()) << spec.name;
        ASSERT_TRUE(entry->command) << spec.name;
        EXPECT_TRUE(editor_.run(*entry->command)) << state().message.text;
    }

    Editor editor_;
};

const std::vector<MenuTarget> every_target{
    OnPanel{},
    OnCanvas{},
    OnCanvas{HoveredPoint{2}, {}},
    OnCanvas{HoveredWeightRing{5}, {}},
    OnCanvas{HoveredKnot{4}, {}},
    OnCanvas{HoveredCurve{0.3}, {}},
    OnCanvas{HoveredParameter{}, {}},
    OnCanvas{HoveredLeg{1}, {1.0, 2.0}},
    OnCanvas{HoveredOtherCurve{1}, {}},
    OnPlot{HoveredBasis{3}, 0.4},
    OnPlot{HoveredKnot{4}, 0.2},
    OnPlot{HoveredSpan{4}, 0.3},
    OnPlot{HoveredNothing{}, 7.0},
    OnPart{HoveredPoint{0}},
    OnPart{HoveredCell{1, 0}},
    OnCurve{2},
    OnFinding{0, "inflection"},
    OnText{"Moved P₃"},
    OnTitleLine{},
    OnToolBar{},
};

TEST_F(ContextMenu, is_there_for_every_target_with_and_without_curves) {
    for (const MenuTarget& target : every_target) EXPECT_FALSE(open(target).empty()) << target.index();
    editor_.run(NewDocument{});
    for (const MenuTarget& target : every_target) EXPECT_FALSE(context_menu(state(), target).empty()) << target.index();
}

TEST_F(ContextMenu, offers_nothing_twice_and_groups_what_belongs_together) {
    for (const MenuTarget& target : every_target) {
        const std::vector<MenuEntry> menu = open(target);
        std::set<const CommandSpec*> seen;
        for (const MenuEntry& entry : menu) EXPECT_TRUE(seen.insert(entry.spec).second) << entry.spec->name;
        EXPECT_FALSE(menu.front().begins_group);
    }
}

TEST_F(ContextMenu, of_a_point_selects_it_unless_it_is_among_the_selected) {
    open(OnCanvas{HoveredPoint{2}, {}});
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{2}));
    editor_.run(SelectPoints{.points = {1, 2, 3}});
    const std::vector<MenuEntry> menu = open(OnCanvas{HoveredPoint{2}, {}});
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_TRUE(offers(menu, Delete::spec()));
    EXPECT_TRUE(offers(menu, SetWeight::spec()));
    open(OnPlot{HoveredBasis{5}, 0.4});
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{5}));
    open(OnPart{HoveredPoint{6}});
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{6}));
}

TEST_F(ContextMenu, of_a_knot_acts_on_that_knot) {
    const std::vector<MenuEntry> menu = open(OnPlot{HoveredKnot{5}, 0.5});
    EXPECT_EQ(state().selection.knot, 5U);
    choose(menu, RaiseKnot::spec());
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.5, 0.5, 0.75, 1, 1, 1, 1}));
    choose(open(OnCanvas{HoveredKnot{4}, {}}), DeleteKnot::spec());
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 0.75, 1, 1, 1, 1}));
}

TEST_F(ContextMenu, of_the_curve_and_of_a_span_insert_a_knot_at_the_pointer) {
    choose(open(OnCanvas{HoveredCurve{0.3}, {}}), InsertKnot::spec());
    choose(open(OnPlot{HoveredSpan{5}, 0.4}), InsertKnot::spec());
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.3, 0.4, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_FALSE(offers(open(OnPlot{HoveredNothing{}, 1.5}), InsertKnot::spec())) << "outside the domain";
}

TEST_F(ContextMenu, of_a_leg_adds_a_point_at_the_pointer) {
    choose(open(OnCanvas{HoveredLeg{1}, {-3.0, 3.0}}), AddPoint::spec());
    EXPECT_EQ(points(editor_)[2], core::Point(-3, 3));
    EXPECT_EQ(points(editor_)[1], core::Point(-4.6, 2.6));
}

TEST_F(ContextMenu, of_another_curve_makes_it_active_first) {
    choose(open(OnCanvas{HoveredOtherCurve{1}, {}}), SetCurveVisible::spec());
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_FALSE(document(editor_).curves[1].visible);
    EXPECT_TRUE(document(editor_).curves[0].visible);
    choose(open(OnCurve{2}), SetCurveLocked::spec());
    EXPECT_EQ(document(editor_).active, 2U);
    EXPECT_FALSE(document(editor_).curves[2].locked);
}

TEST_F(ContextMenu, of_a_text_copies_it) {
    choose(open(OnText{"κ 0.25"}), CopyText::spec());
    EXPECT_EQ(state().clipboard, "κ 0.25");
    EXPECT_EQ(state().message, (Message{"Copied the text", false}));
}

TEST_F(ContextMenu, of_the_tool_bar_has_every_tool) {
    const std::vector<MenuEntry> menu = open(OnToolBar{});
    for (const Tool tool : all_tools) EXPECT_TRUE(offers(menu, take_tool_spec(tool))) << core::name_of(tool);
}

}  // namespace
}  // namespace batten::editor
