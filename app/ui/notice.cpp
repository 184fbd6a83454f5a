#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/commands/help_commands.h"
#include "app/editor/words/reading_text.h"
#include "app/ui/context_popup.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double most_width = 560.0;
constexpr double notice_padding = 12.0;
constexpr double sign_width = 26.0;
constexpr double notice_cross_size = 24.0;

/// A triangle with an exclamation mark.
void draw_warning_sign(const PanelContext& context, float left, float center_y) {
    const auto at = [&](double x, double y) { return ImVec2(left + context.px(x), center_y + context.px(y)); };
    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 color = imgui_packed(context.theme.error);
    list->AddTriangle(at(8, -7), at(16, 7), at(0, 7), color, context.px(1.6));
    list->AddLine(at(8, -2), at(8, 2.5), color, context.px(1.6));
    list->AddCircleFilled(at(8, 4.8), context.px(1), color);
}

Rectangle notice_place(const PanelContext& context, const Rectangle& canvas, ImVec2 text_size) {
    const glm::dvec2 size(
        text_size.x + context.px(2.0 * notice_padding + sign_width + notice_cross_size + 8.0),
        std::max(text_size.y, context.px(notice_cross_size)) + context.px(2.0 * notice_padding - 4.0));
    return {{std::floor(canvas.origin_px.x + 0.5 * (canvas.size_px.x - size.x)), canvas.origin_px.y + context.px(16)},
            size};
}

}  // namespace

void draw_notice(const PanelContext& context, const Rectangle& canvas) {
    const editor::Message& message = context.state.message;
    if (!message.is_error || message.text.empty()) return;
    const std::string text = context.notated(editor::reading_text(message.text));
    const float room =
        static_cast<float>(std::min(most_width * context.scale, canvas.size_px.x - 48.0 * context.scale)) -
        context.px(2.0 * notice_padding + sign_width + notice_cross_size + 8.0);
    const ImVec2 text_size = ImGui::CalcTextSize(text.c_str(), nullptr, false, std::max(room, context.px(80)));
    const Rectangle place = notice_place(context, canvas, text_size);
    const glm::vec2 corner(place.origin_px);
    const glm::vec2 size(place.size_px);
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, imgui_color(context.theme.field));
    ImGui::PushStyleColor(ImGuiCol_Border, imgui_color(context.theme.error));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0F, context.px(1)));
    ImGui::Begin("notice", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(2);
    draw_warning_sign(context, corner.x + context.px(notice_padding), corner.y + 0.5F * size.y);
    const ImVec2 text_corner(corner.x + context.px(notice_padding + sign_width),
                             corner.y + std::floor(0.5F * (size.y - text_size.y)));
    ImGui::GetWindowDrawList()->AddText(context.fonts.text, font_height(context.fonts.text), text_corner,
                                        imgui_packed(context.theme.text), text.c_str(), nullptr,
                                        std::max(room, context.px(80)));
    ImGui::SetCursorScreenPos(text_corner);
    ImGui::InvisibleButton("text", text_size);
    report_item(context, "notice text", text);
    offer_full_message(context, message.text, {corner.x, corner.y + size.y + context.px(4)}, {0.0, 0.0});
    ImGui::SetCursorScreenPos({corner.x + size.x - context.px(notice_padding + notice_cross_size - 4.0),
                               corner.y + context.px(notice_padding - 2.0)});
    if (draw_cross_button(context, "notice dismiss", context.px(notice_cross_size)))
        context.queue.run(editor::DismissMessage{});
    if (ImGui::IsWindowHovered() && asks_for_menu())
        open_context_menu(context, editor::OnText{context.notated(message.text)});
    ImGui::End();
}

}  // namespace batten::ui
