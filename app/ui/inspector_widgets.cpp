#include "app/ui/inspector_widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/editor/words/formula.h"
#include "app/ui/command_entry.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/rich_text.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "app/ui/typing.h"

namespace batten::ui {
namespace {

constexpr double least_tooltip_room = 180.0;  // for a tool tip to the left
constexpr float least_shrink = 0.75F;         // smaller text is cut instead

ImVec2 minus(ImVec2 a, ImVec2 b) {
    return {a.x - b.x, a.y - b.y};
}

render::Color text_color(const PanelContext& context, const Button& button) {
    if (button.is_active) return context.theme.canvas;
    return button.is_enabled ? context.theme.text : render::faded(context.theme.dim, 0.55);
}

void draw_button_frame(const PanelContext& context, const Button& button, ImVec2 lower, ImVec2 upper) {
    const bool is_lit = button.is_enabled && ImGui::IsItemHovered();
    if (!button.has_frame && !button.is_active && !is_lit) return;
    if (!button.is_active) return draw_field_frame(context, lower, minus(upper, lower), is_lit);
    ImGui::GetWindowDrawList()->AddRectFilled(lower, upper, imgui_packed(context.theme.accent), context.px(5));
}

void draw_button_text(const PanelContext& context, const Button& button, ImVec2 lower, ImVec2 upper,
                      render::Color color) {
    if (button.text.empty()) return;
    const bool is_centered = button.anchor == render::Anchor::center;
    const float x = is_centered ? 0.5F * (lower.x + upper.x) : lower.x + context.px(8);
    ImFont* font = button.is_small ? context.fonts.small : context.fonts.text;
    draw_text(context, ImVec2(x, 0.5F * (lower.y + upper.y)),
              {button.text, font, 0.0, color, button.anchor, upper.x - lower.x - context.px(is_centered ? 4 : 12)});
}

void draw_tick(const PanelContext& context, ImVec2 center) {
    const auto at = [&](double x, double y) { return ImVec2(center.x + context.px(x), center.y + context.px(y)); };
    const std::array points{at(-3.2, 0.2), at(-0.9, 2.6), at(3.4, -2.6)};
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), 3, imgui_packed(context.theme.canvas), 0, context.px(1.8));
}

void draw_box(const PanelContext& context, ImVec2 center, const Button& button) {
    const float half = context.px(7);
    const ImVec2 lower(center.x - half, center.y - half);
    const ImVec2 upper(center.x + half, center.y + half);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const render::Color fill = button.is_active ? context.theme.accent : context.theme.field;
    list->AddRectFilled(lower, upper, imgui_packed(fill), context.px(3));
    if (button.is_active) return draw_tick(context, center);
    list->AddRect(lower, upper, imgui_packed(context.theme.dim), context.px(3), 0, context.px(1));
}

}  // namespace

void show_cut_text(const PanelContext& context, const std::string& text, ImVec2 lower, ImVec2 upper) {
    if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(lower, upper)) return;
    draw_tooltip_at(context, editor::plain_text(text), {lower.x, upper.y + context.px(6)}, {0.0, 0.0});
}

float draw_text(const PanelContext& context, ImVec2 position, const TextLine& line) {
    const std::string text = line.is_typed ? line.text : context.notated(line.text);
    float size_px = line.size > 0.0 ? context.px(line.size) : font_height(line.font);
    float width_px = rich_text_size(text, line.font, size_px).width_px;
    const float shrink = line.most_px > 0.0F ? std::clamp(line.most_px / width_px, least_shrink, 1.0F) : 1.0F;
    size_px *= shrink;
    width_px *= shrink;
    const bool is_cut = line.most_px > 0.0F && width_px > line.most_px;
    if (is_cut) width_px = line.most_px;
    const float share = line.anchor == render::Anchor::left     ? 0.0F
                        : line.anchor == render::Anchor::center ? 0.5F
                                                                : 1.0F;
    const float x = std::round(position.x - share * width_px);
    const float y = std::round(position.y - 0.5F * size_px);
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (is_cut) list->PushClipRect(ImVec2(x, y), ImVec2(x + width_px, y + size_px), true);
    draw_rich_text(list, text, line.font, size_px, x, y, line.color);
    if (is_cut) {
        list->PopClipRect();
        show_cut_text(context, text, {x, y}, {x + width_px, y + size_px});
    }
    return width_px;
}

void report_item(const PanelContext& context, std::string name, std::string value) {
    const ImVec2 clip_lower = ImGui::GetWindowDrawList()->GetClipRectMin();
    const ImVec2 clip_upper = ImGui::GetWindowDrawList()->GetClipRectMax();
    const glm::dvec2 lower(std::max(ImGui::GetItemRectMin().x, clip_lower.x),
                           std::max(ImGui::GetItemRectMin().y, clip_lower.y));
    const glm::dvec2 upper(std::min(ImGui::GetItemRectMax().x, clip_upper.x),
                           std::min(ImGui::GetItemRectMax().y, clip_upper.y));
    if (lower.x >= upper.x || lower.y >= upper.y) return;
    context.widgets.push_back({std::move(name), {lower, upper - lower}, std::move(value)});
}

// Beside the panel rather than at the pointer, so that it hides none of the fields below.
void show_typed_tooltip(const PanelContext& context, const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered()) return;
    const float right = ImGui::GetWindowPos().x - context.px(6);
    if (right < context.px(least_tooltip_room)) return draw_side_tooltip(context, text);
    const float y = ImGui::GetItemRectMin().y;
    const bool is_low = y > 0.7F * ImGui::GetIO().DisplaySize.y;
    draw_tooltip_at(context, text, {right, is_low ? ImGui::GetItemRectMax().y : y}, {1.0F, is_low ? 1.0F : 0.0F});
}

void show_tooltip(const PanelContext& context, const std::string& text) {
    if (!text.empty() && ImGui::IsItemHovered()) show_typed_tooltip(context, context.notated(text));
}

void draw_field_frame(const PanelContext& context, ImVec2 origin, ImVec2 size, bool is_lit) {
    const editor::Theme& theme = context.theme;
    const render::Color fill = is_lit ? render::blended(theme.accent, 0.14, theme.field) : theme.field;
    ImGui::GetWindowDrawList()->AddRectFilled(origin, ImVec2(origin.x + size.x, origin.y + size.y), imgui_packed(fill),
                                              context.px(5));
}

bool draw_button(const PanelContext& context, const Button& button) {
    const ImVec2 size(button.width_px, context.px(button.height));
    const bool is_clicked = ImGui::InvisibleButton(button.name.c_str(), size);
    const ImVec2 lower = ImGui::GetItemRectMin();
    const ImVec2 upper = ImGui::GetItemRectMax();
    draw_button_frame(context, button, lower, upper);
    const ImVec2 center(0.5F * (lower.x + upper.x), 0.5F * (lower.y + upper.y));
    const render::Color color = text_color(context, button);
    draw_icon(context, center, button.icon, color);
    draw_button_text(context, button, lower, upper, color);
    report_item(context, button.name, button.text);
    show_tooltip(context, button.tooltip);
    return is_clicked && button.is_enabled;
}

namespace {

bool draw_described_button(const PanelContext& context, Button button, const editor::CommandSpec& spec) {
    button.is_enabled = button.is_enabled && !refusal_of(spec, context.state);
    if (button.tooltip.empty()) button.tooltip = command_tooltip(spec, context.state);
    return draw_button(context, button);
}

}  // namespace

void draw_command_button(const PanelContext& context, Button button, const editor::Command& command) {
    if (draw_described_button(context, std::move(button), command.spec())) context.queue.run(command);
}

void draw_command_button(const PanelContext& context, Button button, const editor::CommandSpec& spec) {
    if (draw_described_button(context, std::move(button), spec)) run_command(context, spec);
}

bool draw_check_box(const PanelContext& context, const Button& button) {
    const bool is_clicked =
        ImGui::InvisibleButton(button.name.c_str(), ImVec2(button.width_px, context.px(button.height)));
    const ImVec2 lower = ImGui::GetItemRectMin();
    const float center = 0.5F * (lower.y + ImGui::GetItemRectMax().y);
    const bool is_lit = button.is_enabled && ImGui::IsItemHovered();
    if (button.has_frame) draw_field_frame(context, lower, minus(ImGui::GetItemRectMax(), lower), is_lit);
    const float left = lower.x + (button.has_frame ? context.px(9) : 0.0F);
    draw_box(context, ImVec2(left + context.px(7), center), button);
    const render::Color color = button.is_enabled ? context.theme.text : context.theme.dim;
    draw_text(context, ImVec2(left + context.px(22), center),
              {button.text, context.fonts.text, 0.0, color, render::Anchor::left, button.width_px - context.px(24)});
    report_item(context, button.name, button.is_active ? "on" : "off");
    show_tooltip(context, button.tooltip);
    return is_clicked && button.is_enabled;
}

bool begin_choices(const PanelContext& context, const ChoiceField& field) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 size(field.width_px, context.px(24));
    ImGui::PushID(field.name.c_str());
    if (ImGui::InvisibleButton("field", size) && field.is_enabled) ImGui::OpenPopup("choices");
    report_item(context, field.name, field.text);
    show_tooltip(context, field.tooltip);
    draw_field_frame(context, origin, size, ImGui::IsItemHovered());
    const ImVec2 left(origin.x + context.px(9), origin.y + context.px(12));
    const float width = draw_text(
        context, left,
        {field.text, context.fonts.text, 0.0, context.theme.text, render::Anchor::left, size.x - context.px(9 + 20)});
    const ImVec2 mark(left.x + width + context.px(10), left.y);
    ImGui::GetWindowDrawList()->AddTriangleFilled(ImVec2(mark.x - context.px(3.5), mark.y - context.px(2)),
                                                  ImVec2(mark.x + context.px(3.5), mark.y - context.px(2)),
                                                  ImVec2(mark.x, mark.y + context.px(3)),
                                                  imgui_packed(context.theme.text));
    const float gap = context.px(2);
    if (field.opens_upward) {
        ImGui::SetNextWindowPos(ImVec2(origin.x, origin.y - gap), ImGuiCond_Always, ImVec2(0.0F, 1.0F));
        ImGui::SetNextWindowSizeConstraints(
            ImVec2(0.0F, 0.0F), ImVec2(std::numeric_limits<float>::max(), origin.y - field.top_px - 2.0F * gap));
    } else {
        ImGui::SetNextWindowPos(ImVec2(origin.x, origin.y + size.y + gap));
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(4), context.px(4)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    if (!ImGui::BeginPopup("choices")) {
        ImGui::PopStyleVar(2);
        ImGui::PopID();
        return false;
    }
    if (is_pressed(context, editor::Key::escape)) ImGui::CloseCurrentPopup();
    return true;
}

void end_choices() {
    ImGui::EndPopup();
    ImGui::PopStyleVar(2);
    ImGui::PopID();
}

bool draw_choice(const PanelContext& context, Button button) {
    button.width_px -= context.px(8);
    button.has_frame = false;
    button.anchor = render::Anchor::left;
    const bool is_chosen = draw_button(context, button);
    if (is_chosen) ImGui::CloseCurrentPopup();
    return is_chosen;
}

}  // namespace batten::ui
