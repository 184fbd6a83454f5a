#include "app/editor/command_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

TEST(CommandTable, has_every_name_once) {
    std::set<std::string> names;
    for (const CommandSpec& spec : command_table()) {
        EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
        EXPECT_EQ(find_command(spec.name), &spec);
    }
    EXPECT_EQ(find_command("insert-a-knot"), nullptr);
    EXPECT_EQ(find_command(""), nullptr);
}

TEST(CommandTable, has_the_agreed_commands) {
    for (const char* name : {"insert-knot",
                             "insert-midpoints",
                             "raise-knot",
                             "refine-midpoints",
                             "insert-for-bezier",
                             "move-knot",
                             "set-knot",
                             "delete-knot",
                             "set-knots",
                             "set-kind",
                             "toggle-closed",
                             "close-or-open",
                             "set-degree",
                             "elevate",
                             "reduce",
                             "move-points",
                             "set-point",
                             "set-weight",
                             "move-farin-point",
                             "make-circular",
                             "add-point",
                             "delete-points",
                             "nudge",
                             "nudge-left",
                             "nudge-right",
                             "nudge-up",
                             "nudge-down",
                             "nudge-left-far",
                             "nudge-right-far",
                             "nudge-up-far",
                             "nudge-down-far",
                             "new-curve",
                             "delete-curve",
                             "duplicate-curve",
                             "rename-curve",
                             "set-curve-color",
                             "set-curve-visible",
                             "set-curve-locked",
                             "delete",
                             "cut",
                             "paste",
                             "paste-beside",
                             "duplicate",
                             "new",
                             "open",
                             "open-example",
                             "add-file",
                             "save",
                             "save-as",
                             "quit",
                             "answer-unsaved",
                             "undo",
                             "redo",
                             "copy",
                             "copy-text",
                             "clear-findings",
                             "toggle-title",
                             "select-all",
                             "select-none",
                             "select-points",
                             "select-knot",
                             "activate-curve",
                             "set-tool",
                             "tool-select",
                             "tool-add-point",
                             "tool-insert-knot",
                             "tool-weight",
                             "tool-draw-curve",
                             "tool-parameter",
                             "set-parameter",
                             "step-parameter-back",
                             "step-parameter-forward",
                             "toggle-play",
                             "set-speed",
                             "toggle-ping-pong",
                             "set-level",
                             "previous-level",
                             "next-level",
                             "fit",
                             "zoom-in",
                             "zoom-out",
                             "toggle-polygon",
                             "toggle-hull",
                             "toggle-pieces",
                             "toggle-comb",
                             "toggle-knots",
                             "toggle-hodograph",
                             "toggle-labels",
                             "toggle-grid",
                             "toggle-construction",
                             "toggle-theme",
                             "scale-up",
                             "scale-down",
                             "scale-reset",
                             "toggle-inspector",
                             "toggle-dock",
                             "present",
                             "fit-plot",
                             "set-knot-move",
                             "command-palette",
                             "key-sheet",
                             "welcome",
                             "about",
                             "close-dialog",
                             "dismiss-message",
                             "escape"})
        EXPECT_NE(find_command(name), nullptr) << name;
}

TEST(CommandTable, explains_every_command) {
    for (const CommandSpec& spec : command_table()) {
        EXPECT_NE(std::string(spec.title), "") << spec.name;
        const std::string explanation = spec.explanation;
        ASSERT_GT(explanation.size(), 10U) << spec.name;
        EXPECT_EQ(explanation.back(), '.') << spec.name;
        EXPECT_NE(spec.run.edit == nullptr, spec.run.act == nullptr) << spec.name;
        for (const Field& field : spec.fields)
            for (const FieldPart& part : field.parts) EXPECT_NE(std::string(part.meaning), "") << spec.name;
        EXPECT_TRUE(spec.run.edit != nullptr || spec.effect == ShapeEffect::none) << spec.name;
    }
}

// The palette tells what would be taken for a field also where a command is refused.
TEST(CommandTable, suggests_what_fits_or_nothing_without_a_curve) {
    const Editor editor{core::Document{}};
    ASSERT_EQ(editor.state().history.present().active_curve(), nullptr);
    for (const CommandSpec& spec : command_table())
        for (const Field& field : spec.fields)
            for (const FieldValue& value : {field.suggestion(editor.state()), field.initial(editor.state())})
                if (!is_absent(value) && field.kind != FieldKind::text) {
                    EXPECT_FALSE(shown_text(field, value, editor.state()).empty())
                        << spec.name << " " << field.parts.front().name;
                }
}

// A step says what it did; what is not undone says nothing.
TEST(CommandTable, says_what_every_edit_did) {
    for (const CommandSpec& spec : command_table()) {
        const bool has_texts = spec.texts != nullptr || spec.done != nullptr;
        EXPECT_EQ(has_texts, spec.run.edit != nullptr) << spec.name;
        EXPECT_TRUE(spec.step == nullptr || spec.done != nullptr) << spec.name;
    }
}

TEST(CommandTable, gives_no_shortcut_twice) {
    std::map<std::string, std::string> owners;
    for (const CommandSpec& spec : command_table())
        for (const Shortcut& shortcut : {spec.shortcut, spec.second_shortcut}) {
            if (shortcut.key == Key::none) continue;
            const auto [owner, is_new] = owners.emplace(text_of(shortcut), spec.name);
            EXPECT_TRUE(is_new) << text_of(shortcut) << ": " << owner->second << " and " << spec.name;
            EXPECT_EQ(find_command(shortcut), &spec);
        }
    EXPECT_EQ(find_command(Shortcut{}), nullptr);
    EXPECT_EQ(owners["Ctrl+Shift+Z"], "redo");
    EXPECT_EQ(owners["Ctrl+Y"], "redo");
    EXPECT_EQ(owners["Delete"], "delete");
    EXPECT_EQ(owners["Backspace"], "delete");
    EXPECT_EQ(owners["Ctrl+V"], "paste-beside");
    EXPECT_EQ(owners["Tab"], "toggle-polygon");
    EXPECT_EQ(owners["Ctrl++"], "scale-up");
    EXPECT_EQ(owners["Shift+Left"], "nudge-left-far");
}

TEST(CommandTable, is_in_the_order_of_menus) {
    const auto table = command_table();
    for (std::size_t i = 1; i < table.size(); ++i) EXPECT_LE(table[i - 1].get().group, table[i].get().group);
}

// What a menu lists itself, beside its submenus.
std::set<std::string> entries_of(CommandGroup group) {
    std::set<std::string> names;
    for (const CommandSpec& spec : command_table())
        if (spec.group == group && spec.offered.menu && spec.submenu == nullptr) names.insert(spec.name);
    return names;
}

TEST(CommandTable, keeps_the_edit_menu_short) {
    EXPECT_EQ(entries_of(CommandGroup::edit),
              (std::set<std::string>{"undo", "redo", "cut", "copy", "paste-beside", "paste", "paste-points",
                                     "duplicate", "delete", "select-all", "select-none"}));
    for (const char* name : {"nudge", "nudge-left", "nudge-down-far", "set-tool", "escape"}) {
        EXPECT_FALSE(find_command(name)->offered.menu) << name;
        EXPECT_TRUE(find_command(name)->offered.palette) << name;
    }
    for (const char* name : {"tool-weight", "set-point", "select-knot"})
        EXPECT_TRUE(find_command(name)->offered.menu && find_command(name)->submenu != nullptr) << name;
}

TEST(CommandTable, marks_what_commands_do_to_the_shape) {
    for (const char* name : {"insert-knot", "insert-midpoints", "raise-knot", "elevate"})
        EXPECT_EQ(find_command(name)->effect, ShapeEffect::keeps) << name;
    for (const char* name : {"move-knot", "set-knot", "delete-knot", "set-knots", "set-kind", "toggle-closed",
                             "close-or-open", "set-degree", "reduce", "move-points", "set-weight", "move-farin-point",
                             "make-circular", "add-point", "delete-points", "delete"})
        EXPECT_EQ(find_command(name)->effect, ShapeEffect::changes) << name;
    for (const char* name : {"new-curve", "rename-curve", "paste", "undo", "fit"})
        EXPECT_EQ(find_command(name)->effect, ShapeEffect::none) << name;
}

}  // namespace
}  // namespace batten::editor
