#include <imgui.h>

#include "app/editor/commands/file_commands.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

const char* consequence_of(const std::optional<editor::Pending>& pending) {
    if (pending && std::holds_alternative<editor::Quit>(*pending)) return "Batten is about to close.";
    return "Another document is about to take its place.";
}

}  // namespace

void draw_unsaved_dialog(const PanelContext& context, const Rectangle& window) {
    if (context.state.dialog != editor::Dialog::unsaved_changes) return;
    DialogFrame frame;
    frame.title = "Save the changes?";
    frame.size = {440.0, 172.0};
    frame.closes_on_outside = false;
    const bool is_left = begin_dialog(context, window, frame);
    ImGui::TextWrapped(
        "%s", core::sentence("{file} has changes that are not saved.", {{"file", context.state.file_name()}}).c_str());
    ImGui::TextDisabled("%s", consequence_of(context.state.pending));

    const float buttons = label_button_width(context, "Don't save") + label_button_width(context, "Cancel") +
                          label_button_width(context, "Save") + 2.0F * ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPos(
        {ImGui::GetWindowWidth() - buttons - context.px(18), ImGui::GetWindowHeight() - context.px(46)});
    if (draw_label_button(context, "dialog discard", "Don't save"))
        context.queue.run(editor::AnswerUnsaved{.answer = editor::UnsavedAnswer::discard});
    ImGui::SameLine();
    if (draw_label_button(context, "dialog cancel", "Cancel") || is_left)
        context.queue.run(editor::AnswerUnsaved{.answer = editor::UnsavedAnswer::cancel});
    ImGui::SameLine();
    const bool is_saved = draw_label_button(context, "dialog save", "Save", ButtonLook::primary);
    if (is_saved || was_pressed(context, editor::Key::enter))
        context.queue.run(editor::AnswerUnsaved{.answer = editor::UnsavedAnswer::save});
    end_dialog();
}

}  // namespace batten::ui
