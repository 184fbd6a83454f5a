#include "app/ui/shell_widgets.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <glm/common.hpp>
#include <sstream>
#include <utility>

#include "app/editor/words/reading_text.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"
#include "core/base/utf8.h"

namespace batten::ui {

namespace {

/// The label's color and those of the button at rest, hovered and pressed.
struct ButtonColors {
    render::Color label;
    render::Color rest;
    render::Color hovered;
    render::Color pressed;
};

ButtonColors colors_of(const editor::Theme& theme, ButtonLook look) {
    switch (look) {
        case ButtonLook::plain:
            return {theme.text, theme.field, render::blended(theme.accent, 0.18, theme.field),
                    render::blended(theme.accent, 0.32, theme.field)};
        case ButtonLook::primary:
            return {theme.canvas, theme.accent, render::blended(theme.text, 0.15, theme.accent),
                    render::blended(theme.text, 0.3, theme.accent)};
        case ButtonLook::quiet:
            break;
    }
    return {theme.dim, render::faded(theme.field, 0.0), render::faded(theme.accent, 0.16),
            render::faded(theme.accent, 0.28)};
}

void push_colors(const ButtonColors& colors) {
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colors.label));
    ImGui::PushStyleColor(ImGuiCol_Button, imgui_color(colors.rest));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, imgui_color(colors.hovered));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, imgui_color(colors.pressed));
}

constexpr int pushed_colors = 4;
constexpr double button_padding_x = 14.0;
constexpr double button_padding_y = 6.0;
constexpr double least_tooltip_width = 160.0;  // of its lines
constexpr double most_tooltip_width = 310.0;

}  // namespace

void begin_panel(const char* name, const Rectangle& place, int window_flags) {
    ImGui::SetNextWindowPos(imgui_pair(place.origin_px));
    ImGui::SetNextWindowSize(imgui_pair(place.size_px));
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav | window_flags);
}

void end_panel() {
    ImGui::End();
}

Rectangle last_item_place() {
    const ImVec2 corner = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    return {{corner.x, corner.y}, {size.x, size.y}};
}

void draw_edge(const PanelContext& context, glm::dvec2 from, glm::dvec2 to) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    // Dear ImGui clips half of a window's padding, where edges are.
    list->PushClipRect(imgui_pair(from - 1.0), imgui_pair(to + 1.0));
    list->AddLine(imgui_pair(from), imgui_pair(to), imgui_packed(context.theme.line));
    list->PopClipRect();
}

bool draw_label_button(const PanelContext& context, const std::string& name, const char* label, ButtonLook look) {
    push_colors(colors_of(context.theme, look));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(button_padding_x), context.px(button_padding_y)));
    ImGui::PushID(name.c_str());
    const bool is_clicked = ImGui::Button(label);
    ImGui::PopID();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(pushed_colors);
    report_item(context, name, label);
    return is_clicked;
}

float label_button_width(const PanelContext& context, const char* label) {
    return text_width(label, context.fonts.text) + 2.0F * context.px(button_padding_x);
}

bool draw_cross_button(const PanelContext& context, const std::string& name, float size_px) {
    push_colors(colors_of(context.theme, ButtonLook::quiet));
    ImGui::PushID(name.c_str());
    const bool is_clicked = ImGui::Button("##cross", ImVec2(size_px, size_px));
    ImGui::PopID();
    ImGui::PopStyleColor(pushed_colors);
    report_item(context, name);
    const Rectangle place = last_item_place();
    const glm::vec2 center(place.origin_px + 0.5 * place.size_px);
    const float reach = 0.18F * size_px;
    const std::uint32_t color = imgui_packed(ImGui::IsItemHovered() ? context.theme.text : context.theme.dim);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddLine({center.x - reach, center.y - reach}, {center.x + reach, center.y + reach}, color, context.px(1.5));
    list->AddLine({center.x - reach, center.y + reach}, {center.x + reach, center.y - reach}, color, context.px(1.5));
    return is_clicked;
}

void draw_tooltip_at(const PanelContext& context, const std::string& text, glm::dvec2 position, glm::dvec2 pivot) {
    const glm::dvec2 padding(context.px(10), context.px(7));
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const glm::dvec2 window(display.x, display.y);
    const double room = (pivot.x > 0.5 ? position.x : window.x - position.x) - 2.0 * padding.x;
    const float wrap =
        std::clamp(static_cast<float>(room), context.px(least_tooltip_width), context.px(most_tooltip_width));
    const ImVec2 text_size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const glm::dvec2 size = glm::dvec2(text_size.x, text_size.y) + 2.0 * padding;
    const glm::dvec2 corner = glm::clamp(position - pivot * size, glm::dvec2(0.0), glm::max(window - size, 0.0));
    ImGui::SetNextWindowPos(imgui_pair(corner));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, imgui_pair(padding));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(static_cast<float>(padding.x) + wrap);
    ImGui::TextUnformatted(text.c_str());
    context.widgets.push_back({"tool tip", last_item_place(), text});
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void draw_side_tooltip(const PanelContext& context, const std::string& text) {
    const bool is_low = ImGui::GetItemRectMin().y > 0.6F * ImGui::GetIO().DisplaySize.y;
    const float x = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() + context.px(6);
    const float y = is_low ? ImGui::GetItemRectMax().y : ImGui::GetItemRectMin().y;
    draw_tooltip_at(context, text, {x, y}, {0.0F, is_low ? 1.0F : 0.0F});
}

void offer_copy(const PanelContext& context, const std::string& text) {
    if (ImGui::IsItemHovered()) context.panels.text_at_pointer = text;
}

void offer_full_message(const PanelContext& context, const std::string& message, glm::dvec2 position,
                        glm::dvec2 pivot) {
    offer_copy(context, context.notated(message));
    if (!ImGui::IsItemHovered()) return;
    const std::string text = core::sentence("{message}\nCtrl+C copies this",
                                            {{"message", context.notated(editor::full_reading_text(message))}});
    draw_tooltip_at(context, text, position, pivot);
}

float text_width(const std::string& text, ImFont* font) {
    return lines_size(text, font).x;
}

glm::vec2 lines_size(const std::string& text, ImFont* font) {
    const ImVec2 size = font->CalcTextSizeA(font_height(font), FLT_MAX, 0.0F, text.data(), text.data() + text.size());
    return {size.x, size.y};
}

std::string wrapped(const std::string& text, ImFont* font, float width_px) {
    std::istringstream words(text);
    std::string lines;
    std::string line;
    for (std::string word; words >> word;) {
        const std::string longer = line.empty() ? word : fmt::format("{} {}", line, word);
        if (!line.empty() && text_width(longer, font) > width_px) {
            lines.append(line).push_back('\n');
            line = word;
        } else {
            line = longer;
        }
    }
    return lines.append(line);
}

std::string elided(const std::string& text, ImFont* font, float width_px) {
    if (text_width(text, font) <= width_px) return text;
    std::string kept = text;
    while (!kept.empty()) {
        while (kept.size() > 1 && core::continues_utf8(kept.back())) kept.pop_back();
        kept.pop_back();
        std::string shown = fmt::format("{}…", kept);
        if (text_width(shown, font) <= width_px) return shown;
    }
    return kept;
}

bool was_pressed(const PanelContext& context, editor::Key key, editor::Modifiers modifiers) {
    const std::vector<KeyPress>& keys = context.input.key_presses;
    return std::any_of(keys.begin(), keys.end(), [&](const KeyPress& press) {
        return press.shortcut == editor::Shortcut{key, modifiers};
    });
}

}  // namespace batten::ui
