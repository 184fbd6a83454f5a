#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/example_list.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double side_width = 232.0;
constexpr double card_width = 196.0;
constexpr double thumbnail_height = 104.0;
constexpr double card_height = 178.0;
constexpr double card_gap = 12.0;

void draw_recent(const PanelContext& context) {
    if (context.state.recent_files.empty()) return;
    ImGui::Dummy(ImVec2(1.0F, context.px(10)));
    ImGui::TextDisabled("Recent files");
    ImGui::BeginChild("recent", ImVec2(0.0F, 0.0F), false, ImGuiWindowFlags_NoNav);
    for (std::size_t i = 0; i < context.state.recent_files.size(); ++i) {
        const std::filesystem::path& file = context.state.recent_files[i];
        ImGui::PushID(static_cast<int>(i));
        const std::string name = elided(file.filename().string(), context.fonts.text, context.px(side_width - 24.0));
        if (ImGui::Selectable(name.c_str())) context.queue.run(editor::Open{.path = file});
        ImGui::PopID();
        report_item(context, fmt::format("recent {}", i), file.string());
        show_tooltip(context, file.string());
    }
    ImGui::EndChild();
}

void draw_side(const PanelContext& context) {
    ImGui::BeginChild("side", ImVec2(context.px(side_width), 0.0F), false, ImGuiWindowFlags_NoNav);
    ImGui::PushFont(context.fonts.large);
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.accent));
    ImGui::TextUnformatted("batten");
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    ImGui::TextWrapped("B-spline and NURBS curves: draw them, and see what knots do.");
    ImGui::PopStyleColor();
    ImGui::Dummy(ImVec2(1.0F, context.px(10)));
    if (draw_label_button(context, "welcome new", "New", ButtonLook::primary)) context.queue.run(editor::NewDocument{});
    ImGui::SameLine();
    if (draw_label_button(context, "welcome open", "Open…")) context.queue.run(editor::Open{});
    if (context.state.message.is_error) {
        ImGui::Dummy(ImVec2(1.0F, context.px(4)));
        draw_dialog_error(context, context.state.message.text);
    }
    draw_recent(context);
    ImGui::EndChild();
}

void draw_card_back(const PanelContext& context, const Rectangle& place, bool is_hovered) {
    const glm::vec2 low(place.origin_px);
    const glm::vec2 high(place.origin_px + place.size_px);
    const float picture_bottom = low.y + context.px(thumbnail_height);
    const float rounding = context.px(8);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({low.x, low.y}, {high.x, high.y}, imgui_packed(context.theme.field), rounding);
    list->AddRectFilled({low.x, low.y}, {high.x, picture_bottom}, imgui_packed(context.theme.canvas), rounding,
                        ImDrawFlags_RoundCornersTop);
    const render::Color edge = is_hovered ? context.theme.accent : context.theme.line;
    list->AddRect({low.x, low.y}, {high.x, high.y}, imgui_packed(edge), rounding, 0,
                  is_hovered ? context.px(1.5) : std::max(1.0F, context.px(1)));
}

void draw_card_texts(const PanelContext& context, const Example& example, const Rectangle& place) {
    const float left = static_cast<float>(place.origin_px.x) + context.px(10);
    const float width = static_cast<float>(place.size_px.x) - context.px(20);
    const float top = static_cast<float>(place.origin_px.y) + context.px(thumbnail_height + 8.0);
    const float bottom = static_cast<float>(place.origin_px.y + place.size_px.y) - context.px(6);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float line = font_height(context.fonts.bold);
    const std::string title = elided(title_of(example), context.fonts.bold, width);
    list->AddText(context.fonts.bold, line, {left, top}, imgui_packed(context.theme.text), title.c_str());
    // Three lines; what is longer is in the tool tip.
    const float small = font_height(context.fonts.small);
    const float text_top = top + line + context.px(3);
    const float most = std::min(bottom, text_top + 3.0F * small + 1.0F);
    list->PushClipRect({left, text_top}, {left + width, most}, true);
    list->AddText(context.fonts.small, small, {left, text_top}, imgui_packed(context.theme.dim),
                  example.document.description.c_str(), nullptr, width);
    list->PopClipRect();
}

void draw_card(const PanelContext& context, const Example& example, float width_px) {
    ImGui::PushID(example.name.c_str());
    const bool is_clicked = ImGui::InvisibleButton("##card", ImVec2(width_px, context.px(card_height)));
    ImGui::PopID();
    report_item(context, fmt::format("example {}", example.name), title_of(example));
    const bool is_hovered = ImGui::IsItemHovered();
    show_tooltip(context, example.document.description);
    const Rectangle place = last_item_place();
    draw_card_back(context, place, is_hovered);
    const double inset = 14.0 * context.scale;
    draw_thumbnail(
        context, example,
        {place.origin_px + inset, {place.size_px.x - 2.0 * inset, context.px(thumbnail_height) - 2.0 * inset}});
    draw_card_texts(context, example, place);
    if (is_clicked) context.queue.run(editor::OpenExample{.name = example.name});
}

void draw_grid(const PanelContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(card_gap), context.px(card_gap)));
    ImGui::BeginChild("examples", ImVec2(0.0F, 0.0F), false, ImGuiWindowFlags_NoNav);
    // Room for the scroll bar, whether it is there or not, so that cards do not jump.
    const float room = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize - context.px(4);
    const float gap = context.px(card_gap);
    const int columns = std::max(1, static_cast<int>((room + gap) / (context.px(card_width) + gap)));
    const float width = std::floor((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    int index = 0;
    for (const Example& example : examples_of(context)) {
        if (index % columns != 0) ImGui::SameLine();
        draw_card(context, example, width);
        ++index;
    }
    if (index == 0) ImGui::TextDisabled("The folder of examples is missing.");
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_welcome_screen(const PanelContext& context, const Rectangle& window) {
    if (context.state.dialog != editor::Dialog::welcome) return;
    DialogFrame frame;
    frame.title = "Welcome";
    frame.size = {970.0, 740.0};
    const bool is_left = begin_dialog(context, window, frame);
    draw_side(context);
    ImGui::SameLine(0.0F, context.px(16));
    draw_grid(context);
    end_dialog();
    if (is_left) context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
