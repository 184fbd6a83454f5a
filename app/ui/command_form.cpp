#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/command_reader.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/picture_commands.h"
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
constexpr double least_above_share = 0.6;  // of the margin that a high form may reach over above
constexpr double explanation_gap = 12.0;
constexpr double rows_gap = 16.0;  // below the rows
constexpr int message_lines = 3;   // kept free, where there is room
constexpr double footer_gap = 12.0;
constexpr double digits_shown = 6.0;  // of a number that suggests itself
constexpr double least_decimals = 3.0;
constexpr std::size_t digits_worth_a_cut = 2;

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
editor::Outcome<std::vector<Argument>> arguments_of(const FormState& form, std::size_t i,
                                                    const editor::EditorState& state) {
    const Field& field = form.spec->fields[i];
    const std::vector<std::string>& texts = form.typed[i];
    if (!field.is_asked || is_empty(texts)) {
        const editor::FieldValue suggestion = field.suggestion(state);
        if (editor::is_absent(suggestion) && !field.is_optional)
            return tl::unexpected(sentence("{name} is needed: {meaning}", {{"name", field.parts.front().name},
                                                                           {"meaning", field.parts.front().meaning}}));
        return editor::arguments_of(field, suggestion);
    }
    std::vector<Argument> arguments;
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const Argument& begun = form.begun[i][k];
        // What was not typed counts to the last bit; in few digits or in the document's unit it would not.
        if (texts[k] == form.shown[i][k] && begun != Argument(std::monostate{}))
            arguments.push_back(begun);
        else
            arguments.emplace_back(
                editor::Word{editor::takes_text(field) ? texts[k] : editor::typed_over(texts[k], form.initial[i][k])});
    }
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
        auto arguments = arguments_of(form, i, state);
        if (!arguments) return tl::unexpected(arguments.error());
        all.insert(all.end(), arguments->begin(), arguments->end());
    }
    return editor::read_command(*form.spec, state, all);
}

/// A number with the digits that someone reads, `exact` where that is hardly longer.
std::string text_in_digits(const std::string& exact, double value) {
    const double decade = value == 0.0 ? 0.0 : std::floor(std::log10(std::abs(value)));
    const double unit = std::pow(10.0, std::max(least_decimals, digits_shown - 1.0 - decade));
    const double rounded = std::round(value * unit) / unit;
    const std::string text = std::isfinite(rounded) ? core::shortest_text(rounded) : exact;
    return text.size() + digits_worth_a_cut < exact.size() ? text : exact;
}

std::vector<double> numbers_in_units(const editor::Units& units, std::vector<double> numbers) {
    for (double& number : numbers) number = editor::in_units(units, number);
    return numbers;
}

/// A length is written in the document's unit. One that suggests itself is a share of a size, of which the first digits
/// are enough.
std::string text_of_argument(const Field& field, const Argument& argument, const editor::Units& units) {
    const auto* list = std::get_if<std::vector<double>>(&argument);
    if (editor::is_of_lengths(field) && list != nullptr) return TextOf{}(numbers_in_units(units, *list));
    const auto* world = std::get_if<double>(&argument);
    if (!editor::is_of_lengths(field) || world == nullptr) return std::visit(TextOf{}, argument);
    const bool is_place = field.kind != FieldKind::length;
    if (is_place || field.suggestion_from == nullptr)
        return editor::with_unit(units, core::shortest_text(editor::in_units(units, *world)));
    return editor::with_unit(units, fmt::format("{:.4g}", editor::in_units(units, *world)));
}

/// What stands there at first for an argument that is written as `exact`.
std::string shown_text_of(const Field& field, const Argument& argument, const std::string& exact,
                          const editor::Units& units) {
    const auto* world = std::get_if<double>(&argument);
    if (world == nullptr) return exact;
    if (!editor::is_of_lengths(field)) return text_in_digits(exact, *world);
    const double length = editor::in_units(units, *world);
    const std::string text = text_in_digits(core::shortest_text(length), length);
    const bool is_place = field.kind != FieldKind::length;
    return is_place || field.suggestion_from == nullptr ? editor::with_unit(units, text) : exact;
}

/// The part to be typed first, where that is not the first one: pictures, and points of them, were pointed at.
std::string first_part(const editor::CommandSpec& spec) {
    if (&spec == &editor::ScalePicture::spec()) return "length";
    const auto is_of_picture = [](const Field& field) {
        return std::string_view(field.parts.front().name) == "picture";
    };
    if (spec.fields.size() < 2 || !is_of_picture(spec.fields.front())) return {};
    const Field& second = spec.fields[1];
    return second.kind == FieldKind::flag ? "" : second.parts.front().name;
}

void begin_form(FormState& form, const editor::CommandSpec& spec, const editor::EditorState& state) {
    form = {};
    form.spec = &spec;
    for (const Field& field : spec.fields) {
        const editor::Units& units = state.history.present().units;
        std::vector<std::string>& texts = form.initial.emplace_back();
        std::vector<std::string>& shown = form.shown.emplace_back();
        form.begun.push_back(editor::arguments_of(field, field.initial(state)));
        for (const Argument& argument : form.begun.back()) {
            texts.push_back(text_of_argument(field, argument, units));
            shown.push_back(shown_text_of(field, argument, texts.back(), units));
        }
        if (field.kind == FieldKind::choice && texts.front().empty()) texts.front() = field.choices.front().name;
        if (field.kind == FieldKind::flag && texts.front().empty()) texts.front() = "yes";
        if (shown.front().empty()) shown = texts;
    }
    form.typed = form.shown;
    form.focused = first_part(spec);
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
    if (ghost->deviation == 0.0) return effect_text(editor::ShapeEffect::keeps);
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
std::string line_below_fields(const PanelContext& context) {
    const std::string problem = problem_of(context);
    return problem.empty() ? effect_of(context) : problem;
}

void draw_message(const PanelContext& context) {
    const FormState& form = context.panels.form;
    const bool is_problem = !problem_of(context).empty();
    const bool only_lacks = !form.was_tried && lacks_a_text(form, context.state);
    const std::string message = line_below_fields(context);
    if (is_problem && !only_lacks) return draw_dialog_error(context, message);
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    ImGui::TextWrapped("%s", context.notated(message).c_str());
    ImGui::PopStyleColor();
    report_item(context, is_problem ? "form hint" : "form effect", message);
}

/// Of the message with so many lines.
float message_height_px(int lines) {
    return static_cast<float>(lines) * ImGui::GetTextLineHeightWithSpacing();
}

/// Message and buttons, with the gap above them.
float footer_height_px(const PanelContext& context, float message_px) {
    return message_px + ImGui::GetFrameHeight() + context.px(footer_gap);
}

float rows_height_px(const PanelContext& context, float width_px) {
    float height = 0.0F;
    for (const Field& field : context.panels.form.spec->fields)
        if (field.is_asked) height += form_row_height_px(context, field, width_px);
    return height;
}

/// What the message takes below the rows: no more than it needs where the window is too low for all.
float kept_message_height_px(const PanelContext& context) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float most = message_height_px(message_lines);
    if (rows_height_px(context, room.x) + footer_height_px(context, most) <= room.y) return most;
    // As wide as with the sign of an error.
    const std::string message = fmt::format("⚠ {}", context.notated(line_below_fields(context)));
    const float height = wrapped_height_px(message, context.fonts.text, room.x);
    return std::clamp(height + ImGui::GetStyle().ItemSpacing.y, message_height_px(1), most);
}

/// What is previewed is applied; what happens only then is named.
const char* label_of_apply(const editor::CommandSpec& spec) {
    return spec.run.act == nullptr ? "Apply" : spec.title;
}

void draw_footer(const PanelContext& context, float message_px) {
    FormState& form = context.panels.form;
    const std::string problem = problem_of(context);
    const float top = ImGui::GetCursorPosY();
    draw_message(context);
    ImGui::SetCursorPosY(top + message_px);
    const char* apply_label = label_of_apply(*form.spec);
    const float width =
        label_button_width(context, apply_label) + label_button_width(context, "Cancel") + context.px(8);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - width);
    if (draw_label_button(context, "form cancel", "Cancel")) form.is_given_up = true;
    ImGui::SameLine(0.0F, context.px(8));
    const bool is_applied = draw_label_button(context, "form apply", apply_label, ButtonLook::primary);
    if (!is_applied && !was_pressed(context, editor::Key::enter)) return;
    form.takes_focus = form.was_tried = true;
    if (problem.empty()) apply(context);
}

void draw_form_rows(const PanelContext& context, float message_px) {
    FormState& form = context.panels.form;
    ImGui::BeginChild("rows", ImVec2(0.0F, -footer_height_px(context, message_px)), false);
    for (std::size_t i = 0; i < form.spec->fields.size(); ++i)
        if (form.spec->fields[i].is_asked) draw_form_row(context, form.spec->fields[i], form.typed[i]);
    const bool is_cut = ImGui::GetScrollY() < ImGui::GetScrollMaxY();
    ImGui::EndChild();
    if (is_cut)
        draw_edge(context, {ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y},
                  {ImGui::GetItemRectMax().x, ImGui::GetItemRectMax().y});
}

/// Over the inspector, so that the canvas shows what would come of it; higher up where it is too high for that.
Rectangle right_side(const PanelContext& context, const Rectangle& window, const Rectangle& canvas, double height) {
    const double width = (form_width + 2.0 * form_margin) * context.scale;
    const double left = std::max(window.origin_px.x, window.origin_px.x + window.size_px.x - width);
    const double lowest = window.origin_px.y + window.size_px.y - (height + 2.0 * form_margin) * context.scale;
    const double highest = window.origin_px.y - least_above_share * form_margin * context.scale;
    const double top = std::max(highest, std::min(canvas.origin_px.y, lowest));
    return {{left, top}, {width, canvas.size_px.y}};
}

float explanation_height_px(const PanelContext& context, float width_px) {
    return wrapped_height_px(context.notated(context.panels.form.spec->explanation), context.fonts.text, width_px) +
           context.px(explanation_gap);
}

/// As high as everything in it.
DialogFrame frame_of(const PanelContext& context, const Rectangle& window, const Rectangle& canvas) {
    const float width = context.px(form_width) - 2.0F * dialog_padding_px(context);
    const float height = explanation_height_px(context, width) + context.px(rows_gap) + rows_height_px(context, width);
    DialogFrame frame;
    frame.title = context.notated(context.panels.form.spec->title);
    frame.size = {form_width,
                  (height + footer_height_px(context, message_height_px(message_lines)) + dialog_head_px(context)) /
                      context.scale};
    frame.beside = right_side(context, window, canvas, frame.size.y);
    frame.closes_on_outside = false;
    return frame;
}

/// What the command does; in a low window the fields have its room.
void draw_explanation(const PanelContext& context) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float explanation = explanation_height_px(context, room.x);
    const float rest = room.y - explanation - footer_height_px(context, message_height_px(1));
    if (rest < rows_height_px(context, room.x)) return;
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", context.notated(context.panels.form.spec->explanation).c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy(ImVec2(1.0F, context.px(explanation_gap) - ImGui::GetStyle().ItemSpacing.y));
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
    form.is_given_up = begin_dialog(context, window, frame_of(context, window, canvas));
    draw_explanation(context);
    const float message_px = kept_message_height_px(context);
    draw_form_rows(context, message_px);
    draw_footer(context, message_px);
    end_dialog();
    follow_texts(context);
    if (!form.is_given_up) return;
    form = {};
    context.queue.cancel_preview();
    context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
