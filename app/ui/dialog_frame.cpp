#include "app/ui/dialog_frame.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/words/reading_text.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double margin = 20.0;
constexpr double padding = 18.0;
constexpr double title_gap = 12.0;
constexpr double rounding = 10.0;

Rectangle dialog_place(const PanelContext& context, const Rectangle& window, const DialogFrame& frame) {
    const glm::dvec2 corner = frame.beside ? frame.beside->origin_px : window.origin_px;
    const glm::dvec2 room = window.origin_px + window.size_px - corner - 2.0 * margin * context.scale;
    const glm::dvec2 size(std::floor(std::min(frame.size.x * context.scale, room.x)),
                          std::floor(std::min(frame.size.y * context.scale, room.y)));
    if (frame.beside) return {corner + std::floor(margin * context.scale), size};
    const double share = frame.is_at_top ? 0.25 : 0.5;
    const glm::dvec2 free = window.size_px - size;
    return {{std::floor(window.origin_px.x + 0.5 * free.x), std::floor(window.origin_px.y + share * free.y)}, size};
}

void draw_shadow(const PanelContext& context, const Rectangle& place) {
    constexpr int layers = 5;
    for (int i = 1; i <= layers; ++i) {
        const double reach = 3.0 * i * context.scale;
        const glm::vec2 low(place.origin_px - reach);
        const glm::vec2 high(place.origin_px + place.size_px + reach);
        ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y + context.px(4)}, {high.x, high.y + context.px(4)},
                                                  IM_COL32(0, 0, 0, 10), context.px(rounding + 3.0 * i));
    }
}

/// Covers the window, so that nothing below reacts. Returns whether it was clicked beside `place`.
bool begin_cover(const PanelContext& context, const Rectangle& window, const Rectangle& place, bool is_dimmed) {
    const glm::vec2 low(window.origin_px);
    const glm::vec2 high(window.origin_px + window.size_px);
    ImGui::SetNextWindowPos({low.x, low.y});
    ImGui::SetNextWindowSize({high.x - low.x, high.y - low.y});
    // Without padding, which would take its share from what can be drawn on.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::Begin("dialog cover", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const bool appears = ImGui::IsWindowAppearing();
    if (appears) ImGui::SetWindowFocus();
    if (is_dimmed)
        ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y}, {high.x, high.y},
                                                  imgui_packed(render::faded(context.theme.canvas, 0.62)));
    draw_shadow(context, place);
    const ImVec2 mouse = ImGui::GetMousePos();
    return !appears && ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
           !place.contains({mouse.x, mouse.y});
}

bool draw_title(const PanelContext& context, const std::string& title) {
    const float line = font_height(context.fonts.text);
    const float cross = std::round(1.5F * line);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddText(context.fonts.bold, font_height(context.fonts.bold), corner,
                                        imgui_packed(context.theme.text), title.c_str());
    ImGui::SetCursorScreenPos({right - cross, corner.y + std::floor(0.5F * (line - cross))});
    const bool is_closed = draw_cross_button(context, "dialog close", cross);
    ImGui::SetCursorScreenPos({corner.x, corner.y + line + context.px(title_gap)});
    return is_closed;
}

}  // namespace

bool begin_dialog(const PanelContext& context, const Rectangle& window, const DialogFrame& frame) {
    const Rectangle place = dialog_place(context, window, frame);
    const bool is_clicked_outside = begin_cover(context, window, place, !frame.beside);
    const glm::vec2 corner(place.origin_px);
    const glm::vec2 size(place.size_px);
    ImGui::SetCursorScreenPos({corner.x, corner.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, context.px(rounding));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(padding), context.px(padding)));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imgui_color(context.theme.panel));
    ImGui::BeginChild("dialog", {size.x, size.y}, true, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    context.widgets.push_back({"dialog", place, frame.title});
    const bool is_crossed = draw_title(context, frame.title);
    return is_crossed || was_pressed(context, editor::Key::escape) || (frame.closes_on_outside && is_clicked_outside);
}

void end_dialog() {
    ImGui::EndChild();
    ImGui::End();
}

float dialog_padding_px(const PanelContext& context) {
    return context.px(padding);
}

float dialog_head_px(const PanelContext& context) {
    return 2.0F * context.px(padding) + font_height(context.fonts.text) + context.px(title_gap);
}

void draw_dialog_error(const PanelContext& context, const std::string& sentence) {
    if (sentence.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.error));
    const std::string text = context.notated(editor::reading_text(sentence));
    ImGui::TextWrapped("⚠ %s", text.c_str());
    ImGui::PopStyleColor();
    report_item(context, "dialog error", text);
    const std::string full = context.notated(editor::full_reading_text(sentence));
    if (full != text) show_tooltip(context, full);
}

}  // namespace batten::ui
