/// What the command palette offers, and what of it somebody means who types a few words.
#pragma once

#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// A command, or one of the examples.
struct PaletteEntry {
    const editor::CommandSpec* spec = nullptr;  ///< of an example the command that opens it
    std::string example;                        ///< its name; empty for a command
    std::string title;
    std::string name;  ///< as it can be typed
};

/// The entries that `typed` fits, best first: those whose title or name it is, whose title or name begins with it, then
/// by title and name, by synonyms and by the words of explanations. All of them, in the order of menus, where nothing
/// is typed.
std::vector<PaletteEntry> find_entries(const PanelContext& context, const std::string& typed);

/// The command with fields whose name is followed by a space in `typed`: they are being typed; of a knot vector alone
/// that which makes a curve over it. Null where there is none.
const editor::CommandSpec* spec_being_typed(const std::string& typed);

}  // namespace batten::ui
