/// A command as something to be offered: what to show about it and what choosing it does.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command_spec.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// Why the command cannot be chosen now; none where it can.
std::optional<std::string> refusal_of(const editor::CommandSpec& spec, const editor::EditorState& state);

/// Whether a form asks for fields before the command runs.
bool has_form(const editor::CommandSpec& spec);

/// What an entry of a menu or of the palette does: runs the command, or opens its form.
void choose_command(const PanelContext& context, const editor::CommandSpec& spec);

/// What a shortcut or a button does: runs the command with what suggests itself; opens the form where something must be
/// given.
void run_command(const PanelContext& context, const editor::CommandSpec& spec);

/// What a key does: the command with that shortcut, or with the sign that it prints; while a lesson is taken, the keys
/// that presenter remotes send go through its steps. Null where it does nothing.
const editor::CommandSpec* command_of(const editor::EditorState& state, const KeyPress& press);

/// Runs the command of a key. An edit of a curve that is hidden is refused: what is not seen is not changed by keys.
void run_by_key(const PanelContext& context, const editor::CommandSpec& spec);

/// "≅" where the shape is kept, "≠" where it changes, else empty.
const char* effect_sign(editor::ShapeEffect effect);

/// "≅ keeps the shape", "≠ changes the shape", or empty.
std::string effect_text(editor::ShapeEffect effect);

/// "Insert knot (K)", the explanation, the effect on the shape and the refusal, for a tool tip.
std::string command_tooltip(const editor::CommandSpec& spec, const editor::EditorState& state);

}  // namespace batten::ui
