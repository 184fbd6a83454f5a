/// A command as something to be offered: what to show about it and what choosing it does.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command_table.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// Why the command cannot be chosen now; none where it can.
std::optional<std::string> refusal_of(const editor::CommandSpec& spec, const editor::EditorState& state);

/// Whether an argument must be typed because nothing suggests itself.
bool needs_typing(const editor::CommandSpec& spec, const editor::EditorState& state);

/// Runs the command, or opens the palette with its name typed where arguments are needed.
void choose_command(const PanelContext& context, const editor::CommandSpec& spec);

/// "≅" where the shape is kept, "≠" where it changes, else empty.
const char* effect_sign(editor::ShapeEffect effect);

/// "keeps the shape", "changes the shape", or empty.
const char* effect_text(editor::ShapeEffect effect);

/// "Insert knot (K)", the explanation, the effect on the shape and the refusal, for a tool tip.
std::string command_tooltip(const editor::CommandSpec& spec, const editor::EditorState& state);

}  // namespace batten::ui
