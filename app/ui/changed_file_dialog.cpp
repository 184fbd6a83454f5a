#include <imgui.h>

#include <array>

#include "app/editor/commands/file_commands.h"
#include "app/ui/answer_buttons.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/panels.h"
#include "core/base/sentence.h"

namespace batten::ui {

void draw_changed_file_dialog(const PanelContext& context, const Rectangle& window) {
    if (context.state.dialog != editor::Dialog::changed_file) return;
    const bool is_gone = !core::file_stamp(context.state.path);
    DialogFrame frame;
    frame.title = is_gone ? "The file is gone" : "The file has changed";
    frame.size = {460.0, 172.0};
    frame.closes_on_outside = false;
    const bool is_left = begin_dialog(context, window, frame);
    ImGui::TextWrapped("%s", core::sentence(is_gone ? "{file} was moved or deleted meanwhile."
                                                    : "Another program has changed {file} meanwhile.",
                                            {{"file", context.state.file_name()}})
                                 .c_str());
    ImGui::TextDisabled("%s", is_gone ? "Saving makes it anew." : "Overwriting gives up what the other program wrote.");
    const std::array answers{Answer{"dialog cancel", "Cancel"}, Answer{"dialog save-as", "Save as…"},
                             Answer{"dialog overwrite", is_gone ? "Save" : "Overwrite"}};
    const std::array meanings{editor::ChangedAnswer::cancel, editor::ChangedAnswer::save_as,
                              editor::ChangedAnswer::overwrite};
    const auto given = draw_answers(context, answers, 1);
    if (is_left)
        context.queue.run(editor::AnswerChanged{.answer = editor::ChangedAnswer::cancel});
    else if (given)
        context.queue.run(editor::AnswerChanged{.answer = meanings[*given]});
    end_dialog();
}

}  // namespace batten::ui
