#include "app/ui/menu_entry.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/ui/command_entry.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

using editor::CommandSpec;

bool is_capital(char letter) {
    return 'A' <= letter && letter <= 'Z';
}

/// Without what the submenu says already: "JSON" in "Copy as".
std::string_view title_in_menu(const CommandSpec& spec) {
    const std::string_view title = spec.title;
    const std::string_view submenu = spec.submenu == nullptr ? "" : spec.submenu;
    const bool repeats = !submenu.empty() && title.size() > submenu.size() + 1 && title.starts_with(submenu) &&
                         title[submenu.size()] == ' ' && is_capital(title[submenu.size() + 1]);
    return repeats ? title.substr(submenu.size() + 1) : title;
}

/// With an ellipsis where a form asks for more.
std::string entry_title(const PanelContext& context, const editor::MenuEntry& entry) {
    const bool asks = !entry.command && has_form(*entry.spec);
    return context.notated(asks ? fmt::format("{}…", title_in_menu(*entry.spec))
                                : std::string(title_in_menu(*entry.spec)));
}

void draw_check(const PanelContext& context, ImVec2 corner) {
    const float line = font_height(context.fonts.text);
    const auto at = [&](float x, float y) { return ImVec2(corner.x + x * line, corner.y + y * line); };
    const std::array points{at(0.12F, 0.52F), at(0.36F, 0.76F), at(0.82F, 0.26F)};
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                            imgui_packed(context.theme.accent), 0, context.px(1.8));
}

void draw_entry_texts(const PanelContext& context, const editor::MenuEntry& entry, const Columns& columns,
                      ImVec2 corner, bool is_enabled) {
    const CommandSpec& spec = *entry.spec;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const render::Color text = is_enabled ? context.theme.text : render::faded(context.theme.text, 0.4);
    const render::Color dim = is_enabled ? context.theme.dim : render::faded(context.theme.dim, 0.55);
    if (spec.is_checked != nullptr && spec.is_checked(context.state)) draw_check(context, corner);
    float x = corner.x + columns.check;
    list->AddText({x, corner.y}, imgui_packed(text), entry_title(context, entry).c_str());
    x += columns.title + columns.sign;
    const char* sign = effect_sign(spec.effect);
    list->AddText({x - menu_text_width(sign), corner.y}, imgui_packed(dim), sign);
    x += columns.shortcut;
    const std::string shortcut = editor::text_of(spec.shortcut);
    list->AddText({x - menu_text_width(shortcut), corner.y}, imgui_packed(dim), shortcut.c_str());
}

}  // namespace

void draw_menu_entry(const PanelContext& context, const editor::MenuEntry& entry, const Columns& columns) {
    const CommandSpec& spec = *entry.spec;
    const bool is_enabled = !refusal_of(spec, context.state);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(spec.name);
    const int flags = (is_enabled ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled) |
                      (entry.stays_open ? row_leaves_menu_open : ImGuiSelectableFlags_None);
    const bool is_chosen = ImGui::Selectable("##entry", false, flags, ImVec2(columns.total(), 0.0F));
    ImGui::PopID();
    report_item(context, fmt::format("menu-item {}", spec.name), is_enabled ? "enabled" : "disabled");
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        draw_side_tooltip(context, command_tooltip(spec, context.state));
    }
    draw_entry_texts(context, entry, columns, corner, is_enabled);
    if (!is_chosen) return;
    if (entry.command)
        context.queue.run(*entry.command);
    else
        choose_command(context, spec);
}

void make_room(const PanelContext& context, Columns& columns, const editor::MenuEntry& entry) {
    const CommandSpec& spec = *entry.spec;
    const std::string shortcut = editor::text_of(spec.shortcut);
    columns.title = std::max(columns.title, menu_text_width(entry_title(context, entry)) + context.px(8));
    if (spec.is_checked != nullptr) columns.check = context.px(22);
    if (spec.effect != editor::ShapeEffect::none) columns.sign = context.px(32);
    if (!shortcut.empty()) columns.shortcut = std::max(columns.shortcut, menu_text_width(shortcut) + context.px(24));
}

void draw_menu_legend(const PanelContext& context) {
    ImGui::Separator();
    ImGui::PushFont(context.fonts.small);
    ImGui::TextDisabled("≅ keeps the shape   ≠ changes it");
    ImGui::PopFont();
}

float menu_text_width(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

}  // namespace batten::ui
