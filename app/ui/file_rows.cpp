#include "app/ui/file_rows.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/ui/inspector_widgets.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double hover_share = 0.1;

/// Draws one row; returns whether it was clicked.
bool draw_entry_row(const PanelContext& context, const FolderEntry& entry, bool is_chosen) {
    const std::string shown = entry.is_folder ? fmt::format("{}/", entry.name) : entry.name;
    ImGui::PushID(entry.name.c_str());
    if (entry.is_folder) ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    // Weaker than what is chosen.
    if (!is_chosen)
        ImGui::PushStyleColor(ImGuiCol_HeaderHovered, imgui_color(render::faded(context.theme.accent, hover_share)));
    const bool is_clicked = ImGui::Selectable("##entry", is_chosen, ImGuiSelectableFlags_AllowDoubleClick);
    if (!is_chosen) ImGui::PopStyleColor();
    const Rectangle place = last_item_place();
    report_item(context, fmt::format("{} {}", entry.is_folder ? "folder" : "file", entry.name),
                is_chosen ? "chosen" : "");
    const float room = static_cast<float>(place.size_px.x) - context.px(20);
    const std::string fitting = elided(shown, context.fonts.text, room);
    if (fitting != shown && ImGui::IsItemHovered())
        draw_tooltip_at(context, shown, place.origin_px + glm::dvec2(0.0, place.size_px.y), {0.0, 0.0});
    const glm::vec2 corner(place.origin_px);
    ImGui::GetWindowDrawList()->AddText({corner.x + context.px(10), corner.y + 0.5F * ImGui::GetStyle().ItemSpacing.y},
                                        ImGui::GetColorU32(ImGuiCol_Text), fitting.c_str());
    if (entry.is_folder) ImGui::PopStyleColor();
    ImGui::PopID();
    return is_clicked;
}

}  // namespace

void scroll_to_choice(FileDialogState& dialog, float pitch_px) {
    if (!std::exchange(dialog.follows_choice, false)) return;
    const float top = pitch_px * static_cast<float>(dialog.choice.chosen.value_or(0));
    const float height = ImGui::GetWindowHeight() - 2.0F * ImGui::GetStyle().WindowPadding.y;
    const float most = top;
    const float least = top + pitch_px - height;
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), std::min(least, most), most));
}

std::optional<std::size_t> draw_file_rows(const PanelContext& context, float pitch_px) {
    const FileChoice& choice = context.panels.file_dialog.choice;
    std::optional<std::size_t> clicked;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(choice.shown.size()), pitch_px);
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            const auto index = static_cast<std::size_t>(row);
            const FolderEntry& entry = choice.listed.entries[choice.shown[index]];
            if (draw_entry_row(context, entry, choice.chosen == index)) clicked = index;
        }
    }
    return clicked;
}

}  // namespace batten::ui
