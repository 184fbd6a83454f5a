#include "app/editor/command_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "sample_editor.h"

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
                             "move-knot",
                             "set-knot",
                             "delete-knot",
                             "set-knots",
                             "set-kind",
                             "toggle-closed",
                             "set-degree",
                             "elevate",
                             "reduce",
                             "move-points",
                             "set-point",
                             "set-weight",
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
                             "advance",
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
                             "set-plot-range",
                             "fit-plot",
                             "set-knot-move",
                             "set-inspector-width",
                             "set-dock-height",
                             "command-palette",
                             "key-sheet",
                             "welcome",
                             "about",
                             "close-dialog",
                             "dismiss-message",
                             "escape",
                             "hover",
                             "pan-camera",
                             "zoom-camera",
                             "resize-canvas",
                             "set-interface-scale",
                             "set-user-scale",
                             "set-theme"})
        EXPECT_NE(find_command(name), nullptr) << name;
}

TEST(CommandTable, explains_every_command) {
    for (const CommandSpec& spec : command_table()) {
        EXPECT_NE(std::string(spec.title), "") << spec.name;
        const std::string explanation = spec.explanation;
        ASSERT_GT(explanation.size(), 10U) << spec.name;
        EXPECT_EQ(explanation.back(), '.') << spec.name;
        EXPECT_NE(spec.edit == nullptr, spec.act == nullptr) << spec.name;
        for (const ParameterSpec& parameter : spec.parameters)
            EXPECT_NE(std::string(parameter.meaning), "") << spec.name;
        EXPECT_TRUE(spec.edit != nullptr || spec.effect == ShapeEffect::none) << spec.name;
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
    EXPECT_EQ(owners["Tab"], "toggle-polygon");
    EXPECT_EQ(owners["Ctrl++"], "scale-up");
    EXPECT_EQ(owners["Shift+Left"], "nudge-left-far");
}

TEST(CommandTable, is_in_the_order_of_menus) {
    const auto table = command_table();
    for (std::size_t i = 1; i < table.size(); ++i) EXPECT_LE(table[i - 1].group, table[i].group);
}

TEST(CommandTable, marks_what_commands_do_to_the_shape) {
    for (const char* name : {"insert-knot", "insert-midpoints", "raise-knot", "elevate"})
        EXPECT_EQ(find_command(name)->effect, ShapeEffect::keeps) << name;
    for (const char* name :
         {"move-knot", "set-knot", "delete-knot", "set-knots", "set-kind", "toggle-closed", "set-degree", "reduce",
          "move-points", "set-weight", "add-point", "delete-points", "delete"})
        EXPECT_EQ(find_command(name)->effect, ShapeEffect::changes) << name;
    for (const char* name : {"new-curve", "rename-curve", "paste", "undo", "fit"})
        EXPECT_EQ(find_command(name)->effect, ShapeEffect::none) << name;
}

class CompleteArguments : public ::testing::Test {
  protected:
    CompleteArguments() { open_text(editor_, sample_text); }

    Outcome<Arguments> complete(const char* name, const std::vector<Argument>& given) const {
        return complete_arguments(*find_command(name), editor_.state(), given);
    }
    Refusal refusal(const char* name, const std::vector<Argument>& given) const {
        const Outcome<Arguments> arguments = complete(name, given);
        return arguments ? "accepted" : arguments.error();
    }

    Editor editor_;
};

TEST_F(CompleteArguments, takes_suggestions_for_what_is_left_out) {
    editor_.run({"set-parameter", {0.3}});
    EXPECT_EQ(complete("insert-knot", {})->number(0), 0.3);
    editor_.run({"select-points", {std::vector<double>{4, 2}}});
    EXPECT_EQ(complete("delete-points", {})->numbers(0), (std::vector<double>{2, 4}));
    EXPECT_EQ(complete("delete-curve", {})->number(0), 0.0);
    const Outcome<Arguments> move = complete("move-knot", {4.0, 0.3});
    EXPECT_EQ(move->text(2), "snap");
    EXPECT_EQ(move->number(3), 0.0);
}

TEST_F(CompleteArguments, can_leave_out_one_in_front) {
    editor_.run({"select-knot", {5.0}});
    const Outcome<Arguments> set = complete("set-knot", {0.6});
    EXPECT_EQ(set->number(0), 5.0);
    EXPECT_EQ(set->number(1), 0.6);
    EXPECT_EQ(complete("set-knot", {4.0, 0.3})->number(0), 4.0);
}

TEST_F(CompleteArguments, takes_a_number_for_a_list_or_a_text) {
    EXPECT_EQ(complete("select-points", {2.0})->numbers(0), std::vector<double>{2.0});
    EXPECT_EQ(complete("rename-curve", {0.0, 2024.0})->text(1), "2024");
}

TEST_F(CompleteArguments, says_what_is_missing_or_wrong) {
    EXPECT_EQ(refusal("set-degree", {}), "set-degree needs p, the new degree, 1 to 25");
    EXPECT_EQ(refusal("delete-knot", {}),
              "delete-knot needs index, the number of a knot, counted from 0; nothing of that kind is selected");
    EXPECT_EQ(refusal("set-degree", {"four"}), "p is the text 'four'; a number is needed, the new degree, 1 to 25");
    EXPECT_EQ(refusal("set-parameter", {std::vector<double>{1, 2}}),
              "u is a list of 2 numbers; a number is needed, where in the domain");
    EXPECT_EQ(refusal("insert-knot", {0.1, 0.2}), "insert-knot takes 1 argument; 2 were given");
    EXPECT_EQ(refusal("undo", {0.1}), "undo takes 0 arguments; 1 was given");
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal("insert-knot", {infinity}), "u is not finite; a number is needed, where in the domain");
    EXPECT_EQ(refusal("set-knots", {std::vector<double>{0, std::nan("")}}),
              "knots is not finite; a list of numbers is needed, all knots in order, or one period of a closed curve");
}

}  // namespace
}  // namespace batten::editor
