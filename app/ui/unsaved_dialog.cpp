#include <imgui.h>

#include <array>

#include "app/editor/commands/file_commands.h"
#include "app/ui/answer_buttons.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/panels.h"
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

    constexpr std::array answers{Answer{"dialog discard", "Don't save"}, Answer{"dialog cancel", "Cancel"},
                                 Answer{"dialog save", "Save"}};
    const std::array meanings{editor::UnsavedAnswer::discard, editor::UnsavedAnswer::cancel,
                              editor::UnsavedAnswer::save};
    const auto given = draw_answers(context, answers, 2);
    if (is_left)
        context.queue.run(editor::AnswerUnsaved{.answer = editor::UnsavedAnswer::cancel});
    else if (given)
        context.queue.run(editor::AnswerUnsaved{.answer = meanings[*given]});
    end_dialog();
}

}  // namespace batten::ui
