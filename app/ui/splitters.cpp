#include "app/ui/splitters.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/plot_layout.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double reach = 4.0;  // design pixels to either side of the edge
constexpr double usual_inspector_width = 340.0;
constexpr double usual_cards_width = 360.0;
constexpr double usual_dock_height = 260.0;

/// One edge: its line, and the change that moves it.
struct Edge {
    const char* name;
    editor::ViewChange (*change)(double size);
    glm::dvec2 from;
    glm::dvec2 to;
    double size_at_pointer;  ///< design pixels, if the edge were where the pointer is
    double usual_size;
    ImGuiMouseCursor cursor;
};

editor::ViewChange set_inspector_width(double size) {
    return editor::SetInspectorWidth{size};
}

editor::ViewChange set_cards_width(double size) {
    return editor::SetCardsWidth{size};
}

editor::ViewChange set_dock_height(double size) {
    return editor::SetDockHeight{size};
}

void draw_edge_handle(const PanelContext& context, const Edge& edge) {
    const glm::dvec2 grip = reach * context.scale * (edge.from.x == edge.to.x ? glm::dvec2(1, 0) : glm::dvec2(0, 1));
    const Rectangle place{edge.from - grip, edge.to - edge.from + 2.0 * grip};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    begin_panel(edge.name, place, ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton("##edge", imgui_pair(place.size_px));
    report_item(context, edge.name);
    draw_edge(context, edge.from, edge.to);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(edge.cursor);
        const glm::vec2 a(edge.from);
        const glm::vec2 b(edge.to);
        ImGui::GetWindowDrawList()->AddLine({a.x, a.y}, {b.x, b.y}, imgui_packed(context.theme.accent), context.px(2));
    }
    if (ImGui::IsItemHovered() && asks_for_menu()) open_context_menu(context, editor::OnPanel{});
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        context.queue.change(edge.change(edge.usual_size));
    } else if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1.0F)) {
        context.queue.change(edge.change(std::max(0.0, std::round(edge.size_at_pointer))));
    }
    end_panel();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_splitters(const PanelContext& context, const FrameAreas& areas) {
    const ImVec2 mouse = ImGui::GetMousePos();
    if (areas.inspector.size_px.x > 0.0) {
        const glm::dvec2 from = areas.inspector.origin_px;
        const double width = (areas.window.size_px.x - mouse.x) / context.scale;
        draw_edge_handle(
            context, {"inspector edge", set_inspector_width, from, from + glm::dvec2(0.0, areas.inspector.size_px.y),
                      width, usual_inspector_width, ImGuiMouseCursor_ResizeEW});
    }
    if (areas.cards.size_px.x > 0.0) {
        const glm::dvec2 from = areas.cards.origin_px;
        const double width = (from.x + areas.cards.size_px.x - mouse.x) / context.scale;
        draw_edge_handle(context, {"cards edge", set_cards_width, from, from + glm::dvec2(0.0, areas.cards.size_px.y),
                                   width, usual_cards_width, ImGuiMouseCursor_ResizeEW});
    }
    if (areas.dock.size_px.y > 0.0) {
        const glm::dvec2 from = areas.dock.origin_px;
        const double height =
            (from.y + areas.dock.size_px.y - mouse.y) / context.scale - editor::height_of_plots(context.state.view);
        draw_edge_handle(context, {"dock edge", set_dock_height, from, from + glm::dvec2(areas.dock.size_px.x, 0.0),
                                   height, usual_dock_height, ImGuiMouseCursor_ResizeNS});
    }
}

}  // namespace batten::ui
