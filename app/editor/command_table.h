/// The one table of commands that menu, tool bar, shortcuts, palette, key sheet and the command line iterate.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/key.h"
#include "app/editor/state.h"

namespace batten::editor {

/// What a command does to the shape of a curve.
enum class ShapeEffect { none, keeps, changes };

/// Where a command is listed. The groups up to `help` are the menus, in order.
enum class CommandGroup { file, edit, make, curve, construct, analyze, view, help, gesture };

enum class ParameterKind { number, text, numbers };

/// One argument of a command.
struct ParameterSpec {
    const char* name;  ///< "u"
    ParameterKind kind;
    const char* meaning;  ///< "where in the domain"
    /// What stands for the argument when it is left out, taken from the state; null where it must be given.
    std::optional<Argument> (*suggestion)(const EditorState&) = nullptr;
};

/// Arguments that fit the parameters of a command: all there and of the right kind.
class Arguments {
  public:
    explicit Arguments(std::vector<Argument> values) : values_(std::move(values)) {}
    double number(std::size_t i) const { return std::get<double>(values_[i]); }
    const std::string& text(std::size_t i) const { return std::get<std::string>(values_[i]); }
    const std::vector<double>& numbers(std::size_t i) const { return std::get<std::vector<double>>(values_[i]); }
    const std::vector<Argument>& values() const { return values_; }

  private:
    std::vector<Argument> values_;
};

/// The document after an edit, and the selection where the edit changes it.
struct Edit {
    core::Document document;
    std::optional<Selection> selection{};
    std::optional<std::string> clipboard{};  ///< text for the clipboard once the edit is committed
    std::optional<double> error{};           ///< how far off the result really is, where the edit knows it
};

/// One refusal as a sentence for the user.
using Refusal = std::string;
template <class T>
using Outcome = tl::expected<T, Refusal>;

struct CommandSpec {
    const char* name;         ///< "insert-knot", as in logs and on the command line
    const char* title;        ///< "Insert knot", as in menus
    const char* explanation;  ///< one sentence
    CommandGroup group;
    /// The submenu of the group's menu, "Knots"; null: the menu itself. It stands where its first command does.
    const char* submenu = nullptr;
    ShapeEffect effect = ShapeEffect::none;
    Shortcut shortcut{};
    Shortcut second_shortcut{};
    std::vector<ParameterSpec> parameters{};

    /// Why the command cannot be run now, as a sentence; null where it always can.
    std::optional<Refusal> (*refusal)(const EditorState&) = nullptr;
    /// Whether the command shows a check mark now; null where it is not a switch.
    bool (*is_checked)(const EditorState&) = nullptr;

    /// Exactly one of the two. An edit makes a new document from the committed one and becomes a step of the history;
    /// an act changes what is not undone (view, selection, dialogs, files).
    Outcome<Edit> (*edit)(const EditorState&, const Arguments&) = nullptr;
    Outcome<void> (*act)(EditorState&, const Arguments&) = nullptr;

    /// The step's name in the history, "Move P₅"; null: the title.
    std::string (*label)(const EditorState&, const Arguments&) = nullptr;

    bool is_logged = true;  ///< false for what happens every frame (hover, camera) and for resizing
};

/// All commands, in the order of menus.
std::span<const CommandSpec> command_table();

/// The command called `name`, or null.
const CommandSpec* find_command(const std::string& name);

/// The command with this shortcut, or null.
const CommandSpec* find_command(const Shortcut& shortcut);

/// The arguments `given` to a command with suggestions filled in, checked against the table: the count, the kinds, and
/// that numbers are finite. Where fewer are given than there are parameters, the last ones that have a suggestion are
/// taken as left out. A number stands for a list of one, and for the text that it reads as. The sentence names the
/// parameter, what was found and what is needed.
Outcome<Arguments> complete_arguments(const CommandSpec& spec, const EditorState& state,
                                      const std::vector<Argument>& given);

}  // namespace batten::editor
