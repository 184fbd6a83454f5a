#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "app/editor/commands/recovery_commands.h"
#include "app/editor/words/moment_text.h"
#include "app/editor/words/recoverable_name.h"
#include "app/ui/answer_buttons.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

using editor::Recoverable;

std::string told_edits(const Recoverable& document) {
    return core::sentence({.one = "one edit, {when}", .many = "{count} edits, the last {when}"}, document.edit_count,
                          {{"when", editor::moment_text(document.seconds, std::time(nullptr))}});
}

// One line of the list; returns whether it was clicked.
bool draw_recovery_row(const PanelContext& context, std::size_t row, bool is_chosen) {
    const Recoverable& document = context.state.recoverable[row];
    const std::string edits = told_edits(document);
    ImGui::PushID(static_cast<int>(row));
    const bool is_clicked = ImGui::Selectable("##document", is_chosen);
    ImGui::PopID();
    report_item(context, fmt::format("recovery {}", row), is_chosen ? "chosen" : "");
    if (ImGui::IsItemHovered() && !document.file.empty()) show_typed_tooltip(context, document.file.string());
    const glm::vec2 corner(last_item_place().origin_px);
    const float right = corner.x + static_cast<float>(last_item_place().size_px.x) - context.px(10);
    const float edits_width = text_width(edits, context.fonts.text);
    const float y = corner.y + 0.5F * ImGui::GetStyle().ItemSpacing.y;
    const float room = right - edits_width - corner.x - context.px(30);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddText({corner.x + context.px(10), y}, imgui_packed(context.theme.text),
                  elided(recoverable_name(document, context.state.recoverable), context.fonts.text, room).c_str());
    list->AddText({right - edits_width, y}, imgui_packed(context.theme.dim), edits.c_str());
    return is_clicked;
}

void draw_recovery_list(const PanelContext& context) {
    std::size_t& chosen = context.panels.recovery_row;
    const std::size_t count = context.state.recoverable.size();
    const std::size_t before = chosen;
    if (was_pressed(context, editor::Key::down) && chosen + 1 < count) ++chosen;
    if (was_pressed(context, editor::Key::up) && chosen > 0) --chosen;
    const bool is_moved = chosen != before;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imgui_color(context.theme.canvas));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(8), context.px(6)));
    ImGui::BeginChild("documents", ImVec2(0.0F, context.px(120)), true, ImGuiWindowFlags_NoNav);
    for (std::size_t row = 0; row < count; ++row) {
        if (draw_recovery_row(context, row, row == chosen)) chosen = row;
        if (is_moved && row == chosen) ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

void draw_one_recoverable(const PanelContext& context, const Recoverable& document) {
    const char* pattern = document.file.empty() ? "Batten ended before a document without a file was saved."
                                                : "Batten ended before changes to {file} were saved.";
    ImGui::TextWrapped("%s",
                       core::filled_as_needed(pattern, {{"file", editor::recoverable_name(document, {})}}).c_str());
    if (!document.file.empty() && ImGui::IsItemHovered()) show_typed_tooltip(context, document.file.string());
    const std::string edits = told_edits(document);
    ImGui::TextDisabled("%s", edits.c_str());
    report_item(context, "recovery 0", edits);
}

void give_recovery_answer(const PanelContext& context, std::size_t answer, const Recoverable& document) {
    switch (answer) {
        case 0:
            return context.queue.run(editor::DiscardRecovery{.journal = document.journal});
        case 1:
            return context.queue.run(editor::LeaveRecovery{});
        default:
            return context.queue.run(editor::Recover{.journal = document.journal});
    }
}

}  // namespace

void draw_recovery_dialog(const PanelContext& context, const Rectangle& window) {
    const std::vector<Recoverable>& documents = context.state.recoverable;
    if (context.state.dialog != editor::Dialog::recovery || documents.empty()) return;
    std::size_t& chosen = context.panels.recovery_row;
    chosen = std::min(chosen, documents.size() - 1);
    const bool is_list = documents.size() > 1;
    DialogFrame frame;
    frame.title = is_list ? "Recover unsaved documents?" : "Recover the unsaved document?";
    frame.size = {520.0, is_list ? 290.0 : 172.0};
    frame.closes_on_outside = false;
    const bool is_left = begin_dialog(context, window, frame);
    if (is_list) {
        ImGui::TextWrapped("Batten ended before these documents were saved.");
        draw_recovery_list(context);
        draw_dialog_error(context, context.state.message.is_error ? context.state.message.text : "");
    } else {
        draw_one_recoverable(context, documents.front());
        draw_dialog_error(context, context.state.message.is_error ? context.state.message.text : "");
    }
    constexpr std::array answers{Answer{"recovery discard", "Discard"}, Answer{"recovery later", "Later"},
                                 Answer{"recovery recover", "Recover"}};
    const auto given = draw_answers(context, answers, 2);
    if (is_left)
        context.queue.run(editor::LeaveRecovery{});
    else if (given)
        give_recovery_answer(context, *given, documents[chosen]);
    end_dialog();
}

}  // namespace batten::ui
