#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/ui/command_entry.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "app/ui/tool_icon.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

constexpr double button_size = 38.0;
constexpr double button_pitch = 43.0;
constexpr double least_pitch = 38.0;  // before some go into the menu of the rest
constexpr double bar_padding = 12.0;
constexpr double divider_height = 6.0;
constexpr double overflow_row_height = 26.0;  // of the menu with what has no room
constexpr double row_width = 190.0;

/// One button of the bar.
struct ToolButton {
    const editor::CommandSpec& spec;
    std::string place_name;
    bool is_active = false;
};

std::vector<ToolButton> tool_buttons(const editor::EditorState& state) {
    std::vector<ToolButton> buttons;
    for (const editor::Tool tool : editor::all_tools) {
        const std::string name = fmt::format("tool {}", core::name_of(tool));
        buttons.push_back({editor::take_tool_spec(tool), name, state.tool == tool});
    }
    return buttons;
}

std::vector<ToolButton> other_buttons() {
    std::vector<ToolButton> buttons;
    for (const editor::CommandSpec& spec :
         {std::cref(editor::SetSnap::spec()), std::cref(editor::Undo::spec()), std::cref(editor::Redo::spec()),
          std::cref(editor::FitView::spec()), std::cref(editor::TogglePlay::spec())})
        buttons.push_back({spec, fmt::format("tool-bar {}", spec.name)});
    return buttons;
}

render::Color icon_color(const PanelContext& context, const ToolButton& button, bool is_enabled) {
    if (button.is_active) return context.theme.accent;
    if (!is_enabled) return render::faded(context.theme.dim, 0.35);
    return ImGui::IsItemHovered() ? context.theme.text : context.theme.dim;
}

void draw_back(const PanelContext& context, bool is_active, const Rectangle& place) {
    if (!is_active && !ImGui::IsItemHovered()) return;
    const glm::vec2 low(place.origin_px);
    const glm::vec2 high(place.origin_px + place.size_px);
    const render::Color color = render::faded(context.theme.accent, is_active ? 0.24 : 0.10);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y}, {high.x, high.y}, imgui_packed(color), context.px(8));
}

/// Runs the command; the pen also offers its modes, the shape tool its shapes, and snapping its kinds.
void press_button(const PanelContext& context, const ToolButton& button) {
    if (&button.spec == &editor::SetSnap::spec()) return open_context_menu(context, editor::OnSnapping{});
    run_command(context, button.spec);
    if (&button.spec == &editor::take_tool_spec(editor::Tool::shape)) open_context_menu(context, editor::OnShapes{});
    if (&button.spec == &editor::take_tool_spec(editor::Tool::draw_curve)) open_context_menu(context, editor::OnPens{});
    if (&button.spec == &editor::take_tool_spec(editor::Tool::joint)) open_context_menu(context, editor::OnJoints{});
    if (&button.spec == &editor::take_tool_spec(editor::Tool::brush)) open_context_menu(context, editor::OnBrushes{});
}

void draw_tool_button(const PanelContext& context, const ToolButton& button) {
    const bool is_enabled = !refusal_of(button.spec, context.state);
    ImGui::SetCursorPosX(0.5F * (ImGui::GetWindowWidth() - context.px(button_size)));
    ImGui::PushID(button.spec.name);
    const bool is_clicked = ImGui::InvisibleButton("##tool", ImVec2(context.px(button_size), context.px(button_size)));
    ImGui::PopID();
    report_item(context, button.place_name, button.is_active ? "active" : "");
    if (ImGui::IsItemHovered()) draw_side_tooltip(context, command_tooltip(button.spec, context.state));
    const Rectangle place = last_item_place();
    draw_back(context, button.is_active, place);
    const glm::vec2 center(place.origin_px + 0.5 * place.size_px);
    draw_icon(ImGui::GetWindowDrawList(), button.spec, {center.x, center.y, context.px(18)},
              icon_color(context, button, is_enabled));
    if (is_clicked && is_enabled) press_button(context, button);
}

void draw_divider(const PanelContext& context) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetWindowPos().x + context.px(14);
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - context.px(14);
    const float y = corner.y + context.px(3);
    ImGui::GetWindowDrawList()->AddLine({left, y}, {right, y}, imgui_packed(context.theme.line), context.px(1));
    ImGui::Dummy(ImVec2(1.0F, context.px(divider_height)));
}

/// A row of the menu of what has no room on the bar: the icon with its title.
void draw_menu_row(const PanelContext& context, const ToolButton& button) {
    const bool is_enabled = !refusal_of(button.spec, context.state);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = context.px(overflow_row_height);
    ImGui::PushID(button.spec.name);
    const int flags = is_enabled ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    const bool is_chosen = ImGui::Selectable("##row", button.is_active, flags, ImVec2(context.px(row_width), height));
    ImGui::PopID();
    report_item(context, button.place_name, button.is_active ? "active" : "");
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        draw_side_tooltip(context, command_tooltip(button.spec, context.state));
    const float middle = corner.y + 0.5F * height;
    draw_icon(ImGui::GetWindowDrawList(), button.spec, {corner.x + 0.5F * height, middle, context.px(18)},
              icon_color(context, button, is_enabled));
    draw_text(context, {corner.x + height + context.px(6), middle},
              {button.spec.title, context.fonts.text, 0.0, is_enabled ? context.theme.text : context.theme.dim});
    if (is_chosen) press_button(context, button);
}

/// The last button of a bar that is too low: three dots that open a menu with the rest.
void draw_rest(const PanelContext& context, const std::vector<ToolButton>& rest) {
    ImGui::SetCursorPosX(0.5F * (ImGui::GetWindowWidth() - context.px(button_size)));
    if (ImGui::InvisibleButton("##rest", ImVec2(context.px(button_size), context.px(button_size))))
        ImGui::OpenPopup("rest of the tools");
    const auto taken = std::ranges::find_if(rest, &ToolButton::is_active);
    const bool has_taken = taken != rest.end();
    report_item(context, "tool-bar more", has_taken ? "active" : "");
    if (ImGui::IsItemHovered())
        draw_side_tooltip(context, has_taken
                                       ? core::sentence("More tools; taken is '{tool}'", {{"tool", taken->spec.title}})
                                       : std::string("More tools"));
    draw_back(context, has_taken, last_item_place());
    const render::Color color = has_taken                ? context.theme.accent
                                : ImGui::IsItemHovered() ? context.theme.text
                                                         : context.theme.dim;
    const glm::dvec2 center = last_item_place().origin_px + 0.5 * last_item_place().size_px;
    for (const double offset : {-6.0, 0.0, 6.0})
        ImGui::GetWindowDrawList()->AddCircleFilled(
            {static_cast<float>(center.x) + context.px(offset), static_cast<float>(center.y)}, context.px(1.8),
            imgui_packed(color));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(8), context.px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(8), context.px(1)));
    if (ImGui::BeginPopup("rest of the tools")) {
        for (const ToolButton& button : rest) draw_menu_row(context, button);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace

void draw_tool_bar(const PanelContext& context, const Rectangle& place) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, context.px(bar_padding)));
    const std::vector<ToolButton> tools = tool_buttons(context.state);
    std::vector<ToolButton> all = tools;
    for (const ToolButton& button : other_buttons()) all.push_back(button);
    const double room = place.size_px.y / context.scale - 2.0 * bar_padding;
    const auto count = static_cast<double>(all.size());
    const double pitch = std::clamp((room - divider_height) / (count + 1.0), least_pitch, button_pitch);
    const bool has_room = count * pitch + divider_height <= room;
    const auto slots = static_cast<std::size_t>(std::max(room / pitch, 1.0));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.px(pitch - button_size)));
    begin_panel("tool bar", place, ImGuiWindowFlags_NoScrollWithMouse);
    const std::size_t shown = has_room ? all.size() : std::min(slots - 1, tools.size());
    for (std::size_t i = 0; i < shown; ++i) {
        if (i == tools.size()) draw_divider(context);
        draw_tool_button(context, all[i]);
    }
    if (!has_room) draw_rest(context, {all.begin() + static_cast<std::ptrdiff_t>(shown), all.end()});
    if (ImGui::IsWindowHovered() && asks_for_menu()) open_context_menu(context, editor::OnToolBar{});
    const double right = place.origin_px.x + place.size_px.x - 0.5;
    draw_edge(context, {right, place.origin_px.y}, {right, place.origin_px.y + place.size_px.y});
    end_panel();
    ImGui::PopStyleVar(2);
}

}  // namespace batten::ui
