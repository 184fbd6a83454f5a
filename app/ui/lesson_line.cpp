#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/lesson_commands.h"
#include "app/editor/words/formula.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/section.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "app/ui/text_lines.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

// Design pixels.
constexpr double side_margin = 16.0;
constexpr double edge_margin = 8.0;
constexpr double line_share = 1.3;  // of the height of the font
constexpr double button_width = 30.0;
constexpr double button_height = 24.0;
constexpr double button_gap = 6.0;
constexpr double buttons_width = 3.0 * (button_width + button_gap) + button_height;
constexpr double mark_width = 20.0;
constexpr double most_share = 0.4;  // of the canvas
constexpr std::size_t most_lines = 30;

/// A paragraph of the step, broken into lines.
struct Paragraph {
    std::string name;
    TextLines lines;
    ImFont* font = nullptr;
    render::Color color;
    std::string mark{};  ///< before the first line
};

std::string title_of(const editor::LessonRun& run) {
    return core::sentence("{title} · {step} of {count}",
                          {{"title", run.lesson->title}, {"step", run.step + 1}, {"count", run.lesson->steps.size()}});
}

/// What the line says, from top to bottom, in lines of `width`.
std::vector<Paragraph> paragraphs_of(const PanelContext& context, float width) {
    const editor::LessonRun& run = *context.state.lesson;
    const editor::LessonStep& step = run.present();
    const editor::Theme& theme = context.theme;
    std::vector<Paragraph> paragraphs;
    const auto add = [&](const std::string& name, const std::string& text, ImFont* font, render::Color color,
                         const std::string& mark = {}) {
        if (text.empty()) return;
        const float room = mark.empty() ? width : width - context.px(mark_width);
        const std::string shown = editor::notated(text, context.state.view.notation);
        paragraphs.push_back({name, broken_into_lines(shown, font, room, most_lines), font, color, mark});
    };
    add("lesson title", title_of(run), context.fonts.bold, theme.text);
    if (run.step == 0) add("lesson intro", run.lesson->text, context.fonts.text, theme.dim);
    add("lesson text", step.text, context.fonts.text, theme.text);
    add("lesson task", step.task, context.fonts.bold, theme.accent);
    const std::vector<editor::CheckResult> results = editor::results_of(run, context.state);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const editor::CheckResult& result = results[i];
        add(fmt::format("lesson check {}", i), result.sentence, context.fonts.text,
            result.holds ? theme.text : theme.dim, result.holds ? "✓" : "○");
    }
    return paragraphs;
}

float pitch_of(ImFont* font) {
    return std::round(static_cast<float>(line_share) * font_height(font));
}

float height_of(const std::vector<Paragraph>& paragraphs) {
    float height = 0.0F;
    for (const Paragraph& paragraph : paragraphs)
        height += pitch_of(paragraph.font) * static_cast<float>(paragraph.lines.lines.size());
    return height;
}

float text_room(const PanelContext& context, double width) {
    return std::max(static_cast<float>(width) - 3.0F * context.px(side_margin) - context.px(buttons_width), 1.0F);
}

void draw_paragraph(const PanelContext& context, const Paragraph& paragraph) {
    const float pitch = pitch_of(paragraph.font);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float indent = paragraph.mark.empty() ? 0.0F : context.px(mark_width);
    std::string value = paragraph.mark;
    for (std::size_t i = 0; i < paragraph.lines.lines.size(); ++i) {
        const std::string& line = paragraph.lines.lines[i];
        draw_text(context, ImVec2(corner.x + indent, corner.y + (static_cast<float>(i) + 0.5F) * pitch),
                  {line, paragraph.font, 0.0, paragraph.color});
        value.append(value.empty() ? "" : " ").append(editor::plain_text(line));
    }
    if (!paragraph.mark.empty())
        draw_text(context, ImVec2(corner.x, corner.y + 0.5F * pitch),
                  {paragraph.mark, context.fonts.bold, 0.0, paragraph.color});
    ImGui::Dummy(ImVec2(indent + paragraph.lines.width_px, pitch * static_cast<float>(paragraph.lines.lines.size())));
    report_item(context, paragraph.name, value);
}

void draw_step_button(const PanelContext& context, const char* name, const char* text, const editor::Command& command) {
    Button button{name, text, Icon::none, context.px(button_width), button_height};
    draw_command_button(context, button, command);
}

/// To the right, so that each is in the same place in every step.
void draw_buttons(const PanelContext& context, const Rectangle& place) {
    const bool has_solution = !context.state.lesson->present().solution.empty();
    const double width = has_solution ? buttons_width : buttons_width - button_width - button_gap;
    const double right = place.origin_px.x + place.size_px.x - context.px(side_margin);
    ImGui::SetCursorScreenPos(ImVec2(static_cast<float>(right) - context.px(width),
                                     static_cast<float>(place.origin_px.y) + context.px(edge_margin)));
    if (has_solution) {
        draw_step_button(context, "lesson solve", "?", editor::SolveTask{});
        stay_in_row(context, button_gap);
    }
    draw_step_button(context, "lesson previous", "‹", editor::PreviousStep{});
    stay_in_row(context, button_gap);
    draw_step_button(context, "lesson next", "›", editor::NextStep{});
    stay_in_row(context, button_gap);
    if (draw_cross_button(context, "lesson close", context.px(button_height))) context.queue.run(editor::CloseLesson{});
}

}  // namespace

double lesson_line_height(const PanelContext& context, glm::dvec2 room_px) {
    if (!context.state.lesson) return 0.0;
    const float text = height_of(paragraphs_of(context, text_room(context, room_px.x)));
    const float least = context.px(button_height);
    return std::min<double>(std::max(text, least) + 2.0F * context.px(edge_margin), std::floor(most_share * room_px.y));
}

void draw_lesson_line(const PanelContext& context, const Rectangle& place) {
    if (!context.state.lesson || place.size_px.y <= 0.0) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    begin_panel("lesson line", place);
    draw_buttons(context, place);
    const glm::vec2 corner(place.origin_px);
    const float width = text_room(context, place.size_px.x);
    ImGui::SetCursorScreenPos(ImVec2(corner.x + context.px(side_margin), corner.y + context.px(edge_margin)));
    ImGui::BeginChild("lesson texts", ImVec2(width + context.px(side_margin),
                                             static_cast<float>(place.size_px.y) - context.px(edge_margin)));
    for (const Paragraph& paragraph : paragraphs_of(context, width)) draw_paragraph(context, paragraph);
    ImGui::EndChild();
    const double bottom = place.origin_px.y + place.size_px.y - 0.5;
    draw_edge(context, {place.origin_px.x, bottom}, {place.origin_px.x + place.size_px.x, bottom});
    end_panel();
    ImGui::PopStyleVar(2);
}

}  // namespace batten::ui
