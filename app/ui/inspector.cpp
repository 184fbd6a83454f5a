#include <imgui.h>

#include <algorithm>

#include "app/ui/context_popup.h"
#include "app/ui/number_field.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

constexpr double top_margin = 8.0;
constexpr double bottom_margin = 16.0;

/// Keeps the sections where they are when the findings below them go and leave more room than they fill.
void hold_scroll(const PanelContext& context, float height_px) {
    InspectorState& inspector = context.panels.inspector;
    if (height_px > inspector.height_px && inspector.scroll_y > 0.0F)
        ImGui::SetNextWindowContentSize(ImVec2(0.0F, inspector.scroll_y + height_px));
    inspector.height_px = height_px;
}

/// What the sections lack to stay as far scrolled as was asked for, until they are scrolled back.
void draw_room_below(const PanelContext& context) {
    InspectorState& inspector = context.panels.inspector;
    if (context.state.findings)
        inspector.scroll_y = ImGui::GetScrollY();
    else if (!inspector.insert_row_y)
        inspector.scroll_y = std::min(inspector.scroll_y, ImGui::GetScrollY());
    const float lacking = inspector.scroll_y - (ImGui::GetCursorPosY() - ImGui::GetWindowHeight());
    if (inspector.scroll_y > 0.0F && lacking > -ImGui::GetStyle().ItemSpacing.y)
        ImGui::Dummy(ImVec2(1.0F, std::max(lacking, 0.0F)));
}

void draw_sections(const PanelContext& context) {
    add_space(context, top_margin);
    draw_curves_section(context);
    draw_pictures_section(context);
    if (context.state.active_curve() != nullptr) {
        draw_curve_section(context);
        draw_fit_points_section(context);
        draw_points_section(context);
        draw_knots_section(context);
        draw_construction_section(context);
    }
    draw_show_section(context);
    ImGui::Dummy(ImVec2(1.0F, context.px(bottom_margin)));
    draw_room_below(context);
}

/// The menu of the row under the pointer, which asks for itself unless it stands for a part of the active curve.
void open_row_menu(const PanelContext& context, bool is_inside) {
    if (!is_inside || !asks_for_menu() || context.panels.context_menu.opens) return;
    const std::optional<editor::Hover>& wish = context.panels.hover.wish;
    if (wish)
        open_context_menu(context, editor::OnPart{*wish});
    else
        open_context_menu(context, editor::OnPanel{});
}

void push_metrics(const PanelContext& context) {
    // The rest of the margin is indented: Dear ImGui clips at half the padding, and lit rows reach into the margin.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(window_padding), 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(row_gap), context.px(row_gap)));
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, context.px(8));
}

void draw_section_panel(const PanelContext& context, const Rectangle& place) {
    hold_scroll(context, static_cast<float>(place.size_px.y));
    ImGui::SetNextWindowPos(imgui_pair(place.origin_px));
    ImGui::SetNextWindowSize(imgui_pair(place.size_px));
    ImGui::Begin("inspector", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::Indent(context.px(section_margin - window_padding));
    draw_sections(context);
    const bool is_inside = ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    open_row_menu(context, is_inside);
    draw_edge(context, place.origin_px + glm::dvec2(0.5, 0.0), place.origin_px + glm::dvec2(0.5, place.size_px.y));
    ImGui::End();
    note_panel_hover(context, is_inside);
}

}  // namespace

void draw_inspector(const PanelContext& context, const Rectangle& place) {
    drop_lost_field(context);
    const double findings = findings_height(context, place);
    const double sections = place.size_px.y - findings;
    push_metrics(context);
    draw_section_panel(context, {place.origin_px, {place.size_px.x, sections}});
    draw_findings_panel(context, {place.origin_px + glm::dvec2(0.0, sections), {place.size_px.x, findings}});
    ImGui::PopStyleVar(3);
}

}  // namespace batten::ui
