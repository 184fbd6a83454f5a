#include "app/ui/section.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/hint_text.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

constexpr double row_label_width = 102.0;
constexpr float largest_label_share = 0.36F;  // of a narrow inspector

bool is_open(const PanelContext& context, const Section& section) {
    const auto& sections = context.panels.inspector.open_sections;
    const auto found = sections.find(section.name);
    return found == sections.end() ? section.is_open_at_first : found->second;
}

ImVec2 heading_size(const PanelContext& context) {
    return {content_width(context), context.px(heading_height)};
}

/// Reports the last item as the heading, and draws it there.
void draw_heading_texts(const PanelContext& context, const Section& section) {
    const ImVec2 origin = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    const std::string value =
        section.info.empty() ? section.title : fmt::format("{} | {}", section.title, section.info);
    report_item(context, fmt::format("section {}", section.name), value);

    const float middle = origin.y + 0.5F * size.y;
    const float title_width =
        draw_text(context, ImVec2(origin.x, middle), {section.title, context.fonts.bold, 0.0, context.theme.text});
    draw_text(context, ImVec2(origin.x + size.x, middle),
              {section.info, context.fonts.text, 0.0, context.theme.dim, render::Anchor::right,
               size.x - title_width - context.px(12)});
    const float bottom = origin.y + size.y + 0.5F * context.px(1);
    ImGui::GetWindowDrawList()->AddLine(ImVec2(origin.x, bottom), ImVec2(origin.x + size.x, bottom),
                                        imgui_packed(context.theme.line), context.px(1));
}

float row_label_room(const PanelContext& context) {
    return std::floor(std::min(context.px(row_label_width), largest_label_share * content_width(context)));
}

}  // namespace

void draw_fold_mark(const PanelContext& context, ImVec2 center, bool is_open) {
    const auto at = [&](double x, double y) { return ImVec2(center.x + context.px(x), center.y + context.px(y)); };
    const ImU32 color = imgui_packed(context.theme.dim);
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (is_open)
        list->AddTriangleFilled(at(-3.5, -1.8), at(3.5, -1.8), at(0, 2.6), color);
    else
        list->AddTriangleFilled(at(-1.8, -3.5), at(2.6, 0), at(-1.8, 3.5), color);
}

bool draw_section_heading(const PanelContext& context, const Section& section) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    bool open = is_open(context, section);
    if (ImGui::InvisibleButton(section.name.c_str(), heading_size(context)))
        context.panels.inspector.open_sections[section.name] = open = !open;
    const bool is_hovered = ImGui::IsItemHovered();
    draw_heading_texts(context, section);
    const ImVec2 mark(origin.x - context.px(9), origin.y + 0.5F * context.px(heading_height));
    if (is_hovered || !open) draw_fold_mark(context, mark, open);
    return open;
}

void draw_heading(const PanelContext& context, const Section& section) {
    ImGui::Dummy(heading_size(context));
    draw_heading_texts(context, section);
}

float content_width(const PanelContext& context) {
    return ImGui::GetWindowWidth() - 2.0F * context.px(section_margin);
}

void draw_row_label(const PanelContext& context, const std::string& label) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    draw_text(context, ImVec2(origin.x, origin.y + context.px(12)),
              {label, context.fonts.text, 0.0, context.theme.dim, render::Anchor::left,
               row_label_room(context) - context.px(row_gap)});
    ImGui::SetCursorScreenPos(ImVec2(origin.x + row_label_room(context), origin.y));
}

float field_width(const PanelContext& context) {
    return content_width(context) - row_label_room(context);
}

void add_space(const PanelContext& context, double design_px) {
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + context.px(design_px));
}

void stay_in_row(const PanelContext& context, double gap) {
    ImGui::SameLine(0.0F, context.px(gap));
}

void draw_row_list(const PanelContext& context, const RowList& list,
                   const std::function<void(const PanelContext& context, std::size_t i, float width)>& draw_row) {
    const bool scrolls = list.count > list.most;
    const float row = context.px(list.row_height);
    const float width = content_width(context) + 2.0F * context.px(list.overhang);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - context.px(list.overhang));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild(list.name, ImVec2(width, row * static_cast<float>(std::min(list.count, list.most))), false,
                      scrolls ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollbar);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(list.count), row);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_row(context, static_cast<std::size_t>(i), width - (scrolls ? context.px(6) : 0.0F));
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

bool is_editable(const editor::EditorState& state) {
    const core::DocumentCurve* curve = state.shown().active_curve();
    return curve != nullptr && !curve->locked;
}

std::string locked_sentence(const editor::EditorState& state) {
    const core::DocumentCurve* curve = state.shown().active_curve();
    if (curve == nullptr || !curve->locked) return {};
    return editor::locked_sentence(*curve);
}

}  // namespace batten::ui
