#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/command_reader.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/fields/expression.h"
#include "app/editor/fields/field_text.h"
#include "app/editor/words/length.h"
#include "app/editor/words/reading_text.h"
#include "app/ui/command_entry.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/form_row.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

using core::sentence;
using editor::Argument;
using editor::Field;
using editor::FieldKind;

constexpr double form_width = 380.0;
constexpr double form_margin = 20.0;
constexpr double explanation_gap = 12.0;
constexpr double rows_gap = 16.0;  // below the rows
constexpr int message_lines = 3;

/// What is written in a form for `argument`.
struct TextOf {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(bool value) const { return editor::flag_text(value); }
    std::string operator()(double value) const { return core::shortest_text(value); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const editor::Word& word) const { return word.text; }
    std::string operator()(const std::vector<double>& numbers) const {
        std::vector<std::string> texts;
        for (const double number : numbers) texts.push_back(core::shortest_text(number));
        return fmt::format("{}", fmt::join(texts, ", "));
    }
};

bool is_empty(const std::vector<std::string>& texts) {
    return std::all_of(texts.begin(), texts.end(), [](const auto& text) { return text.empty(); });
}

/// The texts of a field's parts as arguments; empty ones stand for what suggests itself, or for nothing.
editor::Outcome<std::vector<Argument>> arguments_of(const Field& field, const std::vector<std::string>& texts,
                                                    const std::vector<std::string>& initial,
                                                    const editor::EditorState& state) {
    if (!field.is_asked || is_empty(texts)) {
        const editor::FieldValue suggestion = field.suggestion(state);
        if (editor::is_absent(suggestion) && !field.is_optional)
            return tl::unexpected(sentence("{name} is needed: {meaning}", {{"name", field.parts.front().name},
                                                                           {"meaning", field.parts.front().meaning}}));
        return editor::arguments_of(field, suggestion);
    }
    std::vector<Argument> arguments;
    for (std::size_t k = 0; k < texts.size(); ++k)
        arguments.emplace_back(
            editor::Word{editor::takes_text(field) ? texts[k] : editor::typed_over(texts[k], initial[k])});
    return arguments;
}

/// Whether a field that must be filled in is empty.
bool lacks_a_text(const FormState& form, const editor::EditorState& state) {
    for (std::size_t i = 0; i < form.spec->fields.size(); ++i) {
        const Field& field = form.spec->fields[i];
        if (is_empty(form.typed[i]) && !field.is_optional && editor::is_absent(field.suggestion(state))) return true;
    }
    return false;
}

/// The command that the form describes now.
editor::Outcome<editor::Command> command_of(const FormState& form, const editor::EditorState& state) {
    std::vector<Argument> all;
    for (std::size_t i = 0; i < form.spec->fields.size(); ++i) {
        auto arguments = arguments_of(form.spec->fields[i], form.typed[i], form.initial[i], state);
        if (!arguments) return tl::unexpected(arguments.error());
        all.insert(all.end(), arguments->begin(), arguments->end());
    }
    return editor::read_command(*form.spec, state, all);
}

/// A length is written in the document's unit. One that suggests itself is a share of a size, of which the first digits
/// are enough.
std::string text_of_argument(const Field& field, const Argument& argument, const editor::Units& units) {
    const auto* world = std::get_if<double>(&argument);
    if (field.kind != FieldKind::length || world == nullptr) return std::visit(TextOf{}, argument);
    if (field.suggestion_from == nullptr) return editor::length_words(units, *world);
    return editor::with_unit(units, fmt::format("{:.4g}", editor::in_units(units, *world)));
}

void begin_form(FormState& form, const editor::CommandSpec& spec, const editor::EditorState& state) {
    form = {};
    form.spec = &spec;
    for (const Field& field : spec.fields) {
        std::vector<std::string>& texts = form.typed.emplace_back();
        for (const Argument& argument : editor::arguments_of(field, field.initial(state)))
            texts.push_back(text_of_argument(field, argument, state.history.present().units));
        if (field.kind == FieldKind::choice && texts.front().empty()) texts.front() = field.choices.front().name;
        if (field.kind == FieldKind::flag && texts.front().empty()) texts.front() = "yes";
    }
    form.initial = form.typed;
    form.earlier_message = state.message.text;
}

/// Shows on the canvas what the command would do, whenever something was changed.
void follow_texts(const PanelContext& context) {
    FormState& form = context.panels.form;
    if (form.previewed == form.typed) return;
    form.previewed = form.typed;
    form.problem.clear();
    if (const auto command = command_of(form, context.state)) {
        context.queue.preview(*command);
        form.was_previewed = true;
    } else {
        context.queue.cancel_preview();
        form.problem = command.error();
    }
}

/// What the command does to the shape, with the deviation of what the canvas shows.
std::string effect_of(const PanelContext& context) {
    const editor::CommandSpec& spec = *context.panels.form.spec;
    const std::optional<editor::Ghost>& ghost = context.state.ghost;
    const editor::Message& message = context.state.message;
    const bool is_of_form = !message.is_error && message.text != context.panels.form.earlier_message;
    if (spec.effect == editor::ShapeEffect::none && context.state.preview && is_of_form)
        return editor::reading_text(message.text);
    const bool is_told = ghost && !std::isnan(ghost->deviation);
    if (spec.effect != editor::ShapeEffect::changes || !context.state.preview || !is_told)
        return effect_text(spec.effect);
    if (!std::isfinite(ghost->deviation)) return "≠ changes the shape; how far cannot be computed";
    return editor::reading_text(
        sentence("≠ changes the shape by at most {deviation}",
                 {{"deviation", editor::length_words(context.state.shown().units, ghost->deviation)}}));
}

/// Why the command cannot be applied: what is wrong in the fields, or why its preview was refused.
std::string problem_of(const PanelContext& context) {
    const FormState& form = context.panels.form;
    if (!form.problem.empty()) return form.problem;
    return form.was_previewed && context.state.message.is_error ? context.state.message.text : "";
}

/// Closes the form and runs the command; the form opens again if the command is refused.
void apply(const PanelContext& context) {
    FormState& form = context.panels.form;
    const auto command = command_of(form, context.state);
    if (!command) {
        form.problem = command.error();
        return;
    }
    context.queue.cancel_preview();
    context.queue.run(editor::CloseDialog{});
    context.queue.run(*command);
    form.was_submitted = true;
}

/// What is wrong, else what the command does to the shape.
void draw_message(const PanelContext& context, const std::string& problem) {
    const FormState& form = context.panels.form;
    const std::string effect = effect_of(context);
    const bool only_lacks = !form.was_tried && lacks_a_text(form, context.state);
    if (!problem.empty() && !only_lacks) return draw_dialog_error(context, problem);
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    ImGui::TextWrapped("%s", context.notated(problem.empty() ? effect : problem).c_str());
    ImGui::PopStyleColor();
    report_item(context, problem.empty() ? "form effect" : "form hint", problem.empty() ? effect : problem);
}

/// Message and buttons, with the gap above them.
float footer_height_px(const PanelContext& context) {
    return static_cast<float>(message_lines) * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeight() +
           context.px(12);
}

void draw_footer(const PanelContext& context) {
    FormState& form = context.panels.form;
    const std::string problem = problem_of(context);
    const float top = ImGui::GetCursorPosY();
    draw_message(context, problem);
    ImGui::SetCursorPosY(top + static_cast<float>(message_lines) * ImGui::GetTextLineHeightWithSpacing());
    const float width = label_button_width(context, "Apply") + label_button_width(context, "Cancel") + context.px(8);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - width);
    if (draw_label_button(context, "form cancel", "Cancel")) form.is_given_up = true;
    ImGui::SameLine(0.0F, context.px(8));
    const bool is_applied = draw_label_button(context, "form apply", "Apply", ButtonLook::primary);
    if (!is_applied && !was_pressed(context, editor::Key::enter)) return;
    form.takes_focus = form.was_tried = true;
    if (problem.empty()) apply(context);
}

void draw_form_rows(const PanelContext& context) {
    FormState& form = context.panels.form;
    ImGui::BeginChild("rows", ImVec2(0.0F, -footer_height_px(context)), false);
    for (std::size_t i = 0; i < form.spec->fields.size(); ++i)
        if (form.spec->fields[i].is_asked) draw_form_row(context, form.spec->fields[i], form.typed[i]);
    ImGui::EndChild();
}

/// Over the inspector, so that the canvas shows what would come of it.
Rectangle right_side(const PanelContext& context, const Rectangle& window, const Rectangle& canvas) {
    const double width = (form_width + 2.0 * form_margin) * context.scale;
    const double left = std::max(window.origin_px.x, window.origin_px.x + window.size_px.x - width);
    return {{left, canvas.origin_px.y}, {width, canvas.size_px.y}};
}

/// As high as everything in it.
DialogFrame frame_of(const PanelContext& context, const Rectangle& place) {
    const editor::CommandSpec& spec = *context.panels.form.spec;
    const float width = context.px(form_width) - 2.0F * dialog_padding_px(context);
    float height = wrapped_height_px(context.notated(spec.explanation), context.fonts.text, width) +
                   context.px(explanation_gap + rows_gap);
    for (const Field& field : spec.fields)
        if (field.is_asked) height += form_row_height_px(context, field, width);
    DialogFrame frame;
    frame.title = context.notated(spec.title);
    frame.size = {form_width, (height + footer_height_px(context) + dialog_head_px(context)) / context.scale};
    frame.beside = place;
    frame.closes_on_outside = false;
    return frame;
}

/// A command that was refused brings the form back with what was typed and the reason.
void reopen_form_after_refusal(const PanelContext& context) {
    FormState& form = context.panels.form;
    form.was_submitted = false;
    if (!context.state.message.is_error) return;
    form.problem = context.state.message.text;
    context.queue.change(editor::ShowForm{form.spec});
}

}  // namespace

void draw_command_form(const PanelContext& context, const Rectangle& window, const Rectangle& canvas) {
    FormState& form = context.panels.form;
    if (context.state.dialog != editor::Dialog::command_form || context.state.form == nullptr) {
        if (form.was_submitted)
            reopen_form_after_refusal(context);
        else if (form.problem.empty())
            form = {};
        return;
    }
    if (form.spec != context.state.form) begin_form(form, *context.state.form, context.state);
    form.is_given_up = begin_dialog(context, window, frame_of(context, right_side(context, window, canvas)));
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", context.notated(form.spec->explanation).c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy(ImVec2(1.0F, context.px(explanation_gap) - ImGui::GetStyle().ItemSpacing.y));
    draw_form_rows(context);
    draw_footer(context);
    end_dialog();
    follow_texts(context);
    if (!form.is_given_up) return;
    form = {};
    context.queue.cancel_preview();
    context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
