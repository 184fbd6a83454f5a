#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/fields/field.h"
#include "app/editor/typed_command.h"
#include "app/ui/command_entry.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/form_row.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/palette_entries.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

using editor::CommandSpec;

constexpr double palette_height = 480.0;
constexpr double entry_height = 28.0;
constexpr double meaning_indent = 110.0;  // of what a field means, behind its name

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

void draw_palette_input(const PanelContext& context) {
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
    ImGui::InputTextWithHint("##input", "Find a command or an example, or type it: insert-knot 0.3", &palette.typed,
                             ImGuiInputTextFlags_CallbackAlways, follow_replacement, &palette);
    ImGui::PopStyleVar();
    report_item(context, "palette input", palette.typed);
    if (palette.typed == before) return;
    palette.chosen = 0;
    palette.problem.clear();
}

/// Closes the palette and runs the command; it is opened again if the command is refused.
void submit(const PanelContext& context, editor::Command command) {
    context.queue.run(editor::CloseDialog{});
    context.queue.run(std::move(command));
    context.panels.palette.was_submitted = true;
}

void run_typed(const PanelContext& context) {
    PaletteState& palette = context.panels.palette;
    editor::Outcome<editor::Command> command = editor::parse_typed_command(palette.typed, context.state);
    palette.takes_focus = true;
    if (command)
        submit(context, *std::move(command));
    else
        palette.problem = command.error();
}

/// Runs a command without fields at once; others open their form.
void choose(const PanelContext& context, const PaletteEntry& entry) {
    PaletteState& palette = context.panels.palette;
    if (spec_being_typed(palette.typed) != nullptr) return run_typed(context);
    if (!entry.example.empty()) return submit(context, editor::OpenExample{.name = entry.example});
    palette.takes_focus = true;
    if (const auto refusal = refusal_of(*entry.spec, context.state)) {
        palette.problem = *refusal;
    } else if (has_form(*entry.spec)) {
        palette = {};
        context.queue.change(editor::ShowForm{entry.spec});
    } else {
        palette.typed = entry.spec->name;
        run_typed(context);
    }
}

void draw_row_texts(const PanelContext& context, const PaletteEntry& entry, const Rectangle& place) {
    const CommandSpec& spec = *entry.spec;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const bool is_enabled = !refusal_of(spec, context.state);
    const float line = font_height(context.fonts.text);
    const float y = std::floor(static_cast<float>(place.origin_px.y + 0.5 * place.size_px.y) - 0.5F * line);
    const float left = static_cast<float>(place.origin_px.x) + context.px(10);
    const float right = static_cast<float>(place.origin_px.x + place.size_px.x) - context.px(10);
    const render::Color text = is_enabled ? context.theme.text : context.theme.dim;
    const std::string title = context.notated(entry.title);
    list->AddText({left, y}, imgui_packed(text), title.c_str());
    const std::string shortcut = editor::text_of(spec.shortcut);
    list->AddText({right - text_width(shortcut, context.fonts.text), y}, imgui_packed(context.theme.dim),
                  shortcut.c_str());
    const std::string side = effect_text(spec.effect);
    const float small = font_height(context.fonts.small);
    const float small_y = std::floor(y + 0.5F * (line - small) + context.px(0.5));
    list->AddText(context.fonts.small, small,
                  {right - context.px(104) - text_width(side, context.fonts.small), small_y},
                  imgui_packed(context.theme.dim), side.c_str());
    const float name_x = left + text_width(title, context.fonts.text) + context.px(10);
    const float name_room = right - context.px(224) - name_x;
    const std::string name = elided(entry.name, context.fonts.small, name_room);
    if (name_room > context.px(30)) {
        list->AddText(context.fonts.small, small, {name_x, small_y}, imgui_packed(context.theme.dim), name.c_str());
        if (name != entry.name)
            show_cut_text(context, entry.name, {name_x, small_y}, {name_x + name_room, small_y + small});
    }
}

void draw_row(const PanelContext& context, const PaletteEntry& entry, bool is_chosen, bool follows_keys) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(entry.name.c_str());
    const bool is_clicked = ImGui::InvisibleButton("##row", ImVec2(width, context.px(entry_height)));
    ImGui::PopID();
    const Rectangle place = last_item_place();
    report_item(context, fmt::format("palette-item {}", entry.name), is_chosen ? "chosen" : "");
    if (is_chosen || ImGui::IsItemHovered()) {
        const glm::vec2 low(place.origin_px);
        const glm::vec2 high(place.origin_px + place.size_px);
        ImGui::GetWindowDrawList()->AddRectFilled(
            {low.x, low.y}, {high.x, high.y}, imgui_packed(render::faded(context.theme.accent, is_chosen ? 0.2 : 0.1)),
            context.px(5));
    }
    if (is_chosen && follows_keys) ImGui::SetScrollHereY();
    draw_row_texts(context, entry, place);
    if (is_clicked) choose(context, entry);
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

/// "which knot (whole number; left out: 3)"
std::string part_meaning(const PanelContext& context, const editor::Field& field, const editor::FieldPart& part) {
    const core::Place meaning("meaning", part.meaning);
    const core::Place kind("kind", editor::kind_text(field));
    const editor::FieldValue suggestion = field.suggestion(context.state);
    if (editor::is_absent(suggestion) || field.parts.size() > 1)
        return core::sentence("{meaning} ({kind})", {meaning, kind});
    return core::sentence("{meaning} ({kind}; left out: {suggestion})",
                          {meaning, kind, {"suggestion", editor::shown_text(field, suggestion, context.state)}});
}

void draw_field(const PanelContext& context, const editor::Field& field) {
    for (const editor::FieldPart& part : field.parts) {
        ImGui::PushFont(context.fonts.number);
        ImGui::TextUnformatted(part.name);
        ImGui::PopFont();
        ImGui::SameLine(context.px(meaning_indent));
        ImGui::TextWrapped("%s", context.notated(part_meaning(context, field, part)).c_str());
    }
}

/// Why the chosen command was or would be refused; empty where it was not.
std::string problem_of_chosen(const PanelContext& context, const CommandSpec* spec) {
    const std::string& problem = context.panels.palette.problem;
    if (!problem.empty() || spec == nullptr) return problem;
    return refusal_of(*spec, context.state).value_or("");
}

/// What the chosen command does and takes, and why it was or would be refused.
void draw_explanation(const PanelContext& context, const CommandSpec* spec) {
    ImGui::Separator();
    ImGui::Dummy(ImVec2(1.0F, context.px(2)));
    if (spec != nullptr) {
        ImGui::TextWrapped("%s", context.notated(spec->explanation).c_str());
        ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
        for (const editor::Field& field : spec->fields) draw_field(context, field);
        ImGui::PopStyleColor();
    } else {
        ImGui::TextDisabled("No command or example matches.");
    }
    draw_dialog_error(context, problem_of_chosen(context, spec));
}

/// What its texts take when they are broken into lines.
float needed_height(const PanelContext& context, const CommandSpec& spec) {
    const float width = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const auto height_of = [&](const std::string& text, float width_px) {
        return wrapped_height_px(context.notated(text), context.fonts.text, width_px) + gap;
    };
    float height = height_of(spec.explanation, width);
    for (const editor::Field& field : spec.fields)
        for (const editor::FieldPart& part : field.parts)
            height += height_of(part_meaning(context, field, part), width - context.px(meaning_indent));
    // As wide as with the sign of an error.
    const std::string problem = problem_of_chosen(context, &spec);
    return problem.empty() ? height : height + height_of(core::sentence("⚠ {problem}", {{"problem", problem}}), width);
}

/// Below the list: room for a long explanation and a refusal, so that the list stays where it is, but no more than is
/// needed where the window is so low that the list needs the rest.
float explanation_height(const PanelContext& context, const CommandSpec* spec) {
    std::size_t lines = 4;
    if (spec != nullptr)
        for (const editor::Field& field : spec->fields) lines += field.parts.size();
    const float usual = static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing() + context.px(8);
    const bool is_low = ImGui::GetWindowHeight() < context.px(palette_height);
    return is_low && spec != nullptr ? std::min(usual, needed_height(context, *spec) + context.px(16)) : usual;
}

void draw_list(const PanelContext& context, const std::vector<PaletteEntry>& entries) {
    const bool follows_keys = move_choice(context, entries.size());
    const std::size_t chosen = context.panels.palette.chosen;
    const CommandSpec* spec = entries.empty() ? nullptr : entries[chosen].spec;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    // While arguments are typed what they mean stands right below.
    const bool has_arguments = spec_being_typed(context.panels.palette.typed) != nullptr;
    const float height = has_arguments ? context.px(entry_height + 6.0) : -explanation_height(context, spec);
    ImGui::BeginChild("list", ImVec2(0.0F, height), false, ImGuiWindowFlags_NoNav);
    for (std::size_t i = 0; i < entries.size(); ++i) draw_row(context, entries[i], i == chosen, follows_keys);
    ImGui::EndChild();
    ImGui::PopStyleVar();
    draw_explanation(context, spec);
    if (was_pressed(context, editor::Key::enter) && spec != nullptr) choose(context, entries[chosen]);
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
    context.queue.run(editor::TogglePalette{});
}

}  // namespace

void draw_command_palette(const PanelContext& context, const Rectangle& window) {
    PaletteState& palette = context.panels.palette;
    if (context.state.dialog != editor::Dialog::command_palette) {
        if (palette.was_submitted) return reopen_after_refusal(context);
        if (palette.was_open && palette.problem.empty()) palette = {};
        return;
    }
    // The command that has run is the one that shows the palette.
    if (palette.was_submitted) palette = {};
    DialogFrame frame;
    frame.title = "Commands";
    frame.size = {640.0, palette_height};
    frame.is_at_top = true;
    const bool is_left =
        begin_dialog(context, window, frame) || was_pressed(context, editor::Key::p, {true, false, false});
    draw_palette_input(context);
    draw_list(context, find_entries(context, palette.typed));
    end_dialog();
    if (!is_left) return;
    palette = {};
    context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
