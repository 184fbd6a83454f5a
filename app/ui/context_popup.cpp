#include "app/ui/context_popup.h"

#include <imgui.h>

#include "app/ui/menu_entry.h"
#include "app/ui/shell_widgets.h"

namespace batten::ui {

namespace {

constexpr const char* popup_name = "context menu";

void draw_entries_of_menu(const PanelContext& context, const std::vector<editor::MenuEntry>& entries) {
    Columns columns;
    for (const editor::MenuEntry& entry : entries) make_room(context, columns, entry);
    for (const editor::MenuEntry& entry : entries) {
        if (entry.begins_group) ImGui::Separator();
        draw_menu_entry(context, entry, columns);
    }
    if (columns.sign > 0.0F) draw_menu_legend(context);
}

}  // namespace

void open_context_menu(const PanelContext& context, const editor::MenuTarget& target) {
    editor::select_for_menu(context.state, target, context.queue);
    context.panels.context_menu = {target, true};
}

bool asks_for_menu() {
    return ImGui::IsMouseReleased(ImGuiMouseButton_Right);
}

void draw_context_menu(const PanelContext& context) {
    ContextMenuState& menu = context.panels.context_menu;
    begin_panel("context menu host", {{0.0, 0.0}, {1.0, 1.0}},
                ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoInputs);
    if (std::exchange(menu.opens, false)) ImGui::OpenPopup(popup_name);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(14), context.px(11)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(16), context.px(9)));
    if (ImGui::BeginPopup(popup_name)) {
        draw_entries_of_menu(context, editor::context_menu(context.state, menu.target));
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
    end_panel();
}

}  // namespace batten::ui
