#include "app/ui/command_entry.h"

#include <algorithm>

namespace batten::ui {

std::optional<std::string> refusal_of(const editor::CommandSpec& spec, const editor::EditorState& state) {
    return spec.refusal == nullptr ? std::nullopt : spec.refusal(state);
}

bool needs_typing(const editor::CommandSpec& spec, const editor::EditorState& state) {
    return std::any_of(spec.parameters.begin(), spec.parameters.end(),
                       [&state](const editor::ParameterSpec& parameter) {
                           return parameter.suggestion == nullptr || !parameter.suggestion(state);
                       });
}

void choose_command(const PanelContext& context, const editor::CommandSpec& spec) {
    if (!needs_typing(spec, context.state)) {
        context.queue.run(spec.name);
        return;
    }
    context.panels.palette = {};
    context.panels.palette.typed = std::string(spec.name) + " ";
    context.queue.run("command-palette");
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

const char* effect_text(editor::ShapeEffect effect) {
    switch (effect) {
        case editor::ShapeEffect::none:
            return "";
        case editor::ShapeEffect::keeps:
            return "keeps the shape";
        case editor::ShapeEffect::changes:
            return "changes the shape";
    }
    return "";
}

std::string command_tooltip(const editor::CommandSpec& spec, const editor::EditorState& state) {
    std::string text = spec.title;
    const std::string shortcut = editor::text_of(spec.shortcut);
    if (!shortcut.empty()) text += "  (" + shortcut + ")";
    text += "\n" + std::string(spec.explanation);
    if (spec.effect != editor::ShapeEffect::none) {
        text += "\n" + std::string(effect_sign(spec.effect)) + " " + effect_text(spec.effect);
    }
    if (const std::optional<std::string> refusal = refusal_of(spec, state)) text += "\nNot now: " + *refusal;
    return text;
}

}  // namespace batten::ui
