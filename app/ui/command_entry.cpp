#include "app/ui/command_entry.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/editor/command_reader.h"
#include "app/editor/command_table.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/lesson_commands.h"
#include "app/editor/pointer/hint_text.h"
#include "app/editor/words/reading_text.h"
#include "core/base/sentence.h"

namespace batten::ui {

using core::sentence;
using editor::Field;

namespace {

bool lacks_a_field(const editor::CommandSpec& spec, const editor::EditorState& state) {
    return std::any_of(spec.fields.begin(), spec.fields.end(), [&state](const Field& field) {
        return !field.can_be_left_out() || (!field.is_optional && editor::is_absent(field.suggestion(state)));
    });
}

}  // namespace

std::optional<std::string> refusal_of(const editor::CommandSpec& spec, const editor::EditorState& state) {
    return spec.refusal == nullptr ? std::nullopt : spec.refusal(state);
}

bool has_form(const editor::CommandSpec& spec) {
    return std::any_of(spec.fields.begin(), spec.fields.end(), [](const Field& field) { return field.is_asked; });
}

void choose_command(const PanelContext& context, const editor::CommandSpec& spec) {
    if (has_form(spec) && !refusal_of(spec, context.state))
        context.queue.change(editor::ShowForm{&spec});
    else
        run_command(context, spec);
}

void run_command(const PanelContext& context, const editor::CommandSpec& spec) {
    if (editor::Outcome<editor::Command> command = editor::read_command(spec, context.state)) {
        context.queue.run(*std::move(command));
    } else if (has_form(spec) && lacks_a_field(spec, context.state) && !refusal_of(spec, context.state)) {
        context.queue.change(editor::ShowForm{&spec});
    } else {
        context.queue.change(editor::ShowRefusal{command.error(), !editor::is_idle(spec, context.state)});
    }
}

const editor::CommandSpec* command_of(const editor::EditorState& state, const KeyPress& press) {
    if (state.lesson && press.shortcut == editor::Shortcut{editor::Key::page_down, {}})
        return &editor::NextStep::spec();
    if (state.lesson && press.shortcut == editor::Shortcut{editor::Key::page_up, {}})
        return &editor::PreviousStep::spec();
    const editor::CommandSpec* by_key = editor::find_command(press.shortcut);
    return by_key != nullptr ? by_key : editor::find_command(press.printed);
}

void run_by_key(const PanelContext& context, const editor::CommandSpec& spec) {
    const core::DocumentCurve* active = context.state.history.present().active_curve();
    const bool is_edit = spec.effect != editor::ShapeEffect::none || &spec == &editor::Cut::spec();
    const bool is_about_active = is_edit && !context.state.selection.is_over_curves();
    if (is_about_active && active != nullptr && !active->visible)
        context.queue.change(editor::ShowRefusal{editor::hidden_sentence(*active)});
    else
        run_command(context, spec);
}

const char* effect_sign(editor::ShapeEffect effect) {
    switch (effect) {
        case editor::ShapeEffect::none:
            return "";
        case editor::ShapeEffect::keeps:
            return "≅";
        case editor::ShapeEffect::changes:
            return "≠";
    }
    return "";
}

std::string effect_text(editor::ShapeEffect effect) {
    if (effect == editor::ShapeEffect::none) return {};
    return sentence("{sign} {effect}", {{"sign", effect_sign(effect)}, {"effect", core::title_of(effect)}});
}

std::string command_tooltip(const editor::CommandSpec& spec, const editor::EditorState& state) {
    const std::string shortcut = editor::text_of(spec.shortcut);
    std::vector<std::string> lines{
        shortcut.empty() ? spec.title : sentence("{title}  ({keys})", {{"title", spec.title}, {"keys", shortcut}}),
        spec.explanation};
    if (spec.effect != editor::ShapeEffect::none) lines.push_back(effect_text(spec.effect));
    const std::optional<std::string> refusal = refusal_of(spec, state);
    if (refusal) lines.push_back(sentence("Not now: {reason}", {{"reason", editor::reading_text(*refusal)}}));
    if (!refusal && spec.aim != nullptr) lines.push_back(editor::reading_text(spec.aim(state)));
    return editor::notated(fmt::format("{}", fmt::join(lines, "\n")), state.view.notation);
}

}  // namespace batten::ui
