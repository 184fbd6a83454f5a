#include "app/ui/answer_buttons.h"

#include <imgui.h>

#include "app/ui/shell_widgets.h"

namespace batten::ui {

namespace {

void place_answers(const PanelContext& context, std::span<const Answer> answers) {
    float width = -ImGui::GetStyle().ItemSpacing.x;
    for (const Answer& answer : answers)
        width += label_button_width(context, answer.label) + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPos({ImGui::GetWindowWidth() - width - context.px(18), ImGui::GetWindowHeight() - context.px(46)});
}

void move_by_answer_keys(const PanelContext& context, std::size_t count, std::size_t& chosen) {
    using editor::Key;
    if (was_pressed(context, Key::tab)) chosen = (chosen + 1) % count;
    if (was_pressed(context, Key::tab, {.shift = true})) chosen = (chosen + count - 1) % count;
    if (was_pressed(context, Key::left) && chosen > 0) --chosen;
    if (was_pressed(context, Key::right) && chosen + 1 < count) ++chosen;
}

}  // namespace

std::optional<std::size_t> draw_answers(const PanelContext& context, std::span<const Answer> answers,
                                        std::size_t first) {
    AnswerState& state = context.panels.answer;
    if (state.dialog != context.state.dialog) state = {context.state.dialog, first};
    move_by_answer_keys(context, answers.size(), state.chosen);
    const bool is_given = was_pressed(context, editor::Key::enter) || was_pressed(context, editor::Key::space);
    std::optional<std::size_t> given;
    if (is_given) given = state.chosen;
    place_answers(context, answers);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const ButtonLook look = i == state.chosen ? ButtonLook::primary : ButtonLook::plain;
        if (draw_label_button(context, answers[i].name, answers[i].label, look)) given = i;
    }
    return given;
}

}  // namespace batten::ui
