#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/formula.h"
#include "app/editor/session.h"
#include "app/ui/command_entry.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/fuzzy_match.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

using editor::CommandSpec;

constexpr double row_height = 28.0;

struct Match {
    const CommandSpec* spec;
    int score;
};

bool is_listed(const CommandSpec& spec) {
    return spec.group != editor::CommandGroup::gesture;
}

/// The command whose name is followed by a space: its arguments are being typed.
const CommandSpec* named_command(const std::string& typed) {
    const std::size_t space = typed.find(' ');
    if (space == std::string::npos) return nullptr;
    const CommandSpec* spec = editor::find_command(typed.substr(0, space));
    return spec != nullptr && is_listed(*spec) ? spec : nullptr;
}

std::vector<Match> matches_of(const std::string& typed) {
    if (const CommandSpec* spec = named_command(typed)) return {{spec, 0}};
    std::vector<Match> matches;
    for (const CommandSpec& spec : editor::command_table()) {
        if (!is_listed(spec)) continue;
        const std::optional<int> by_title = fuzzy_score(typed, spec.title);
        const std::optional<int> by_name = fuzzy_score(typed, spec.name);
        if (by_title || by_name) matches.push_back({&spec, std::max(by_title.value_or(-1), by_name.value_or(-1))});
    }
    std::stable_sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) { return a.score > b.score; });
    return matches;
}

/// Puts the text that the palette itself wrote into the active field, and the cursor behind it.
int follow_replacement(ImGuiInputTextCallbackData* data) {
    auto& palette = *static_cast<PaletteState*>(data->UserData);
    if (!palette.replacement) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, palette.replacement->c_str());
    data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    palette.replacement.reset();
    return 0;
}

void draw_input(const PanelContext& context) {
    PaletteState& palette = context.panels.palette;
    if (!palette.was_open || palette.takes_focus) {
        ImGui::SetKeyboardFocusHere();
        palette.replacement = palette.typed;
    }
    palette.was_open = true;
    palette.takes_focus = false;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(10), context.px(8)));
    ImGui::SetNextItemWidth(-1.0F);
    const std::string before = palette.typed;
    ImGui::InputTextWithHint("##input", "Type a command, with its arguments behind it", &palette.typed,
                             ImGuiInputTextFlags_CallbackAlways, follow_replacement, &palette);
    ImGui::PopStyleVar();
    report_item(context, "palette input", palette.typed);
    if (palette.typed == before) return;
    palette.chosen = 0;
    palette.problem.clear();
}

/// Closes the palette and runs the command; it is opened again if the command is refused.
void submit(const PanelContext& context, const editor::Command& command) {
    context.queue.run("close-dialog");
    context.queue.run(command.name, command.arguments);
    context.panels.palette.was_submitted = true;
}

void run_typed(const PanelContext& context) {
    PaletteState& palette = context.panels.palette;
    const editor::Outcome<editor::Command> command = editor::parse_typed_command(palette.typed);
    palette.takes_focus = true;
    if (command) {
        submit(context, *command);
    } else {
        palette.problem = command.error();
    }
}

void choose(const PanelContext& context, const CommandSpec& spec) {
    PaletteState& palette = context.panels.palette;
    if (named_command(palette.typed) != nullptr) return run_typed(context);
    palette.typed = spec.name;
    palette.takes_focus = true;
    if (!needs_typing(spec, context.state)) return submit(context, {spec.name, {}});
    palette.typed += " ";
}

std::string side_text(const CommandSpec& spec) {
    std::string text = effect_sign(spec.effect);
    if (!text.empty()) text += std::string(" ") + effect_text(spec.effect);
    return text;
}

void draw_row_texts(const PanelContext& context, const CommandSpec& spec, const Rectangle& place) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const bool is_enabled = !refusal_of(spec, context.state);
    const float line = font_height(context.fonts.text);
    const float y = std::floor(static_cast<float>(place.origin_px.y + 0.5 * place.size_px.y) - 0.5F * line);
    const float left = static_cast<float>(place.origin_px.x) + context.px(10);
    const float right = static_cast<float>(place.origin_px.x + place.size_px.x) - context.px(10);
    const render::Color text = is_enabled ? context.theme.text : context.theme.dim;
    list->AddText({left, y}, imgui_packed(text), spec.title);
    const std::string shortcut = editor::text_of(spec.shortcut);
    list->AddText({right - text_width(shortcut, context.fonts.text), y}, imgui_packed(context.theme.dim),
                  shortcut.c_str());
    const std::string side = side_text(spec);
    const float small = font_height(context.fonts.small);
    const float small_y = std::floor(y + 0.5F * (line - small) + context.px(0.5));
    list->AddText(context.fonts.small, small,
                  {right - context.px(104) - text_width(side, context.fonts.small), small_y},
                  imgui_packed(context.theme.dim), side.c_str());
    const float name_x = left + text_width(spec.title, context.fonts.text) + context.px(10);
    const float name_room = right - context.px(224) - name_x;
    const std::string name = elided(spec.name, context.fonts.small, name_room);
    if (name_room > context.px(30)) {
        list->AddText(context.fonts.small, small, {name_x, small_y},
                      imgui_packed(render::faded(context.theme.dim, 0.75)), name.c_str());
    }
}

void draw_row(const PanelContext& context, const CommandSpec& spec, bool is_chosen, bool follows_keys) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(spec.name);
    const bool is_clicked = ImGui::InvisibleButton("##row", ImVec2(width, context.px(row_height)));
    ImGui::PopID();
    const Rectangle place = last_item_place();
    report_item(context, std::string("palette-item ") + spec.name, is_chosen ? "chosen" : "");
    if (is_chosen || ImGui::IsItemHovered()) {
        const glm::vec2 low(place.origin_px);
        const glm::vec2 high(place.origin_px + place.size_px);
        ImGui::GetWindowDrawList()->AddRectFilled(
            {low.x, low.y}, {high.x, high.y}, imgui_packed(render::faded(context.theme.accent, is_chosen ? 0.2 : 0.1)),
            context.px(5));
    }
    if (is_chosen && follows_keys) ImGui::SetScrollHereY();
    draw_row_texts(context, spec, place);
    if (is_clicked) choose(context, spec);
}

/// Moves the choice by the arrow keys; returns whether it moved.
bool move_choice(const PanelContext& context, std::size_t count) {
    PaletteState& palette = context.panels.palette;
    if (count == 0) return false;
    const std::size_t before = std::min(palette.chosen, count - 1);
    palette.chosen = before;
    if (was_pressed(context, editor::Key::down)) palette.chosen = (before + 1) % count;
    if (was_pressed(context, editor::Key::up)) palette.chosen = (before + count - 1) % count;
    return palette.chosen != before;
}

std::string text_of(const editor::Argument& argument) {
    if (const auto* number = std::get_if<double>(&argument)) return editor::number_text(*number, 6);
    if (const auto* text = std::get_if<std::string>(&argument)) return text->empty() ? "nothing" : *text;
    std::string list;
    for (const double value : std::get<std::vector<double>>(argument)) {
        list += (list.empty() ? "" : ",") + editor::number_text(value, 6);
    }
    return list.empty() ? "nothing" : list;
}

const char* kind_text(editor::ParameterKind kind) {
    switch (kind) {
        case editor::ParameterKind::number:
            return "number";
        case editor::ParameterKind::text:
            return "text";
        case editor::ParameterKind::numbers:
            return "list, as 1,2,3";
    }
    return "";
}

void draw_parameter(const PanelContext& context, const editor::ParameterSpec& parameter) {
    ImGui::PushFont(context.fonts.number);
    ImGui::TextUnformatted(parameter.name);
    ImGui::PopFont();
    ImGui::SameLine(context.px(110));
    std::string text = std::string(parameter.meaning) + " (" + kind_text(parameter.kind);
    if (parameter.suggestion != nullptr) {
        const std::optional<editor::Argument> suggestion = parameter.suggestion(context.state);
        if (suggestion) text += "; left out: " + text_of(*suggestion);
    }
    ImGui::TextWrapped("%s)", text.c_str());
}

/// What the chosen command does and takes, and why it was or would be refused.
void draw_explanation(const PanelContext& context, const CommandSpec* spec) {
    ImGui::Separator();
    ImGui::Dummy(ImVec2(1.0F, context.px(2)));
    if (spec != nullptr) {
        ImGui::TextWrapped("%s", spec->explanation);
        ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
        for (const editor::ParameterSpec& parameter : spec->parameters) draw_parameter(context, parameter);
        ImGui::PopStyleColor();
    } else {
        ImGui::TextDisabled("No command is called like that.");
    }
    std::string problem = context.panels.palette.problem;
    if (problem.empty() && spec != nullptr) problem = refusal_of(*spec, context.state).value_or("");
    draw_dialog_error(context, problem);
}

float explanation_height(const PanelContext& context, const CommandSpec* spec) {
    const std::size_t lines = 4 + (spec == nullptr ? 0 : spec->parameters.size());
    return static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() + context.px(8);
}

void draw_list(const PanelContext& context, const std::vector<Match>& matches) {
    const bool follows_keys = move_choice(context, matches.size());
    const std::size_t chosen = context.panels.palette.chosen;
    const CommandSpec* spec = matches.empty() ? nullptr : matches[chosen].spec;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    // While arguments are typed what they mean stands right below.
    const bool has_arguments = named_command(context.panels.palette.typed) != nullptr;
    const float height = has_arguments ? context.px(row_height + 6.0) : -explanation_height(context, spec);
    ImGui::BeginChild("list", ImVec2(0.0F, height), false, ImGuiWindowFlags_NoNav);
    for (std::size_t i = 0; i < matches.size(); ++i) draw_row(context, *matches[i].spec, i == chosen, follows_keys);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    draw_explanation(context, spec);
    if (was_pressed(context, editor::Key::enter) && spec != nullptr) choose(context, *spec);
}

/// A command that was refused brings the palette back with what was typed and the reason.
void reopen_after_refusal(const PanelContext& context) {
    PaletteState& palette = context.panels.palette;
    palette.was_submitted = false;
    if (!context.state.message.is_error) {
        palette = {};
        return;
    }
    palette.problem = context.state.message.text;
    context.queue.run("command-palette");
}

}  // namespace

void draw_command_palette(const PanelContext& context, const Rectangle& window) {
    PaletteState& palette = context.panels.palette;
    if (context.state.dialog != editor::Dialog::command_palette) {
        if (palette.was_submitted) return reopen_after_refusal(context);
        if (palette.was_open && palette.problem.empty()) palette = {};
        return;
    }
    DialogFrame frame;
    frame.title = "Commands";
    frame.size = {640.0, 480.0};
    frame.is_at_top = true;
    const bool is_left =
        begin_dialog(context, window, frame) || was_pressed(context, editor::Key::p, {true, false, false});
    draw_input(context);
    draw_list(context, matches_of(palette.typed));
    end_dialog();
    if (!is_left) return;
    palette = {};
    context.queue.run("close-dialog");
}

}  // namespace batten::ui
