#include "app/ui/number_field.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/fields/expression.h"
#include "app/editor/words/field_number.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/reading_text.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/rich_text.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/typing.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::ui {
namespace {

constexpr double number_padding = 8.0;  // of the text, in design pixels
constexpr float drag_threshold = 3.0F;  // design pixels before a press becomes a drag
constexpr double slow_factor = 0.1;     // with Shift

/// The text that fits: fewer digits rather than cut ones.
std::string shown_number(const PanelContext& context, const NumberField& field, float room_px) {
    ImFont* font = context.fonts.number;
    const auto fits = [&](const std::string& text) {
        return rich_text_size(text + field.unit, font, font_height(font)).width_px <= room_px;
    };
    const editor::FieldDigits digits{field.decimals, field.most_decimals, field.is_multiplicative, field.extent};
    return editor::field_number(field.value, digits, fits) + field.unit;
}

/// What is not all on the field is in its tip.
std::string number_tooltip(const NumberField& field, const std::string& shown) {
    std::string full = editor::full_reading_text(core::shortest_text(field.value)) + field.unit;
    const bool is_exact = editor::without_trailing_zeros(shown) == full || shown == full;
    if (is_exact) return field.tooltip;
    return field.tooltip.empty() ? full : fmt::format("{}\n{}", full, field.tooltip);
}

/// Rounded to what the field shows; a factor to three significant digits.
double dragged_value(const FieldState& state, const NumberField& field) {
    const int decimals =
        field.is_multiplicative ? 2 - static_cast<int>(std::floor(std::log10(state.dragged))) : field.decimals;
    const double power = std::pow(10.0, decimals);
    return std::clamp(std::round(state.dragged * power) / power, field.lowest, field.highest);
}

void follow_pointer(const PanelContext& context, const NumberField& field) {
    FieldState& state = context.panels.field;
    const ImGuiIO& io = ImGui::GetIO();
    const double change =
        field.speed * static_cast<double>(io.MouseDelta.x) / context.scale * (io.KeyShift ? slow_factor : 1.0);
    state.dragged = field.is_multiplicative ? state.dragged * std::exp(change) : state.dragged + change;
}

std::optional<NumberEdit> drag(const PanelContext& context, const NumberField& field) {
    FieldState& state = context.panels.field;
    state.last_frame = ImGui::GetFrameCount();
    if (state.is_given_up) return std::nullopt;
    if (is_pressed(context, editor::Key::escape)) {
        state.is_given_up = true;
        return NumberEdit{state.start, EditPhase::cancel};
    }
    follow_pointer(context, field);
    const double value = dragged_value(state, field);
    if (value == state.previewed) return std::nullopt;
    state.previewed = value;
    return NumberEdit{value, EditPhase::preview};
}

std::optional<NumberEdit> end_drag(FieldState& state) {
    state.active_id = 0;
    state.is_dragging = false;
    if (state.is_given_up) return std::nullopt;
    const bool is_changed = state.previewed != state.start;
    return NumberEdit{state.previewed, is_changed ? EditPhase::commit : EditPhase::cancel};
}

void begin_drag(FieldState& state, unsigned id, double value) {
    state.active_id = id;
    state.is_dragging = true;
    state.is_given_up = false;
    state.start = state.dragged = state.previewed = value;
    state.last_frame = ImGui::GetFrameCount();
    state.problem_id = 0;
}

/// The field at rest or being dragged.
std::optional<NumberEdit> press(const PanelContext& context, const NumberField& field, unsigned id, ImVec2 size) {
    FieldState& state = context.panels.field;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const bool is_clicked = ImGui::InvisibleButton(field.name.c_str(), size);
    const bool is_hovered = ImGui::IsItemHovered() && field.is_enabled;
    draw_field_frame(context, origin, size, is_hovered || ImGui::IsItemActive());
    const std::string text = shown_number(context, field, size.x - 2.0F * context.px(number_padding));
    const render::Color color = field.is_enabled ? context.theme.text : context.theme.dim;
    draw_text(context, ImVec2(origin.x + context.px(number_padding), origin.y + 0.5F * size.y),
              {text, context.fonts.number, 0.0, color});
    report_item(context, field.name, text);
    if (!ImGui::IsItemActive()) show_tooltip(context, number_tooltip(field, text));
    if (!field.is_enabled) return std::nullopt;
    if (is_hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);

    const bool is_dragging = state.is_dragging && state.active_id == id;
    if (is_dragging) return ImGui::IsItemActive() ? drag(context, field) : end_drag(state);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, context.px(drag_threshold)))
        begin_drag(state, id, field.value);
    else if (is_clicked)
        begin_typing(state, id, core::shortest_text(field.value));
    return std::nullopt;
}

/// A length in the unit of the field, or a plain number.
tl::expected<double, std::string> typed_number(const NumberField& field, const std::string& typed) {
    const std::string text = editor::typed_over(typed, core::shortest_text(field.value));
    return editor::parse_length(text, field.length).map([&](double world) {
        return editor::in_units(field.length, world);
    });
}

/// Keeps what was typed in the input, so that it can be mended.
void refuse(FieldState& state, unsigned id, TypingStep step, const std::string& problem) {
    const std::string original = state.original;
    if (step == TypingStep::entered) {
        begin_typing(state, id, state.typed);
        state.original = original;
    }
    set_problem(state, id, problem);
}

/// Tab goes to the number field that is drawn next, Shift+Tab to the one drawn before.
void pass_on(FieldState& state) {
    if (ImGui::GetIO().KeyShift)
        state.wanted_id = state.previous_id;
    else
        state.begins_next = true;
}

std::optional<NumberEdit> end_typed(const PanelContext& context, const NumberField& field, unsigned id,
                                    TypingStep step) {
    FieldState& state = context.panels.field;
    if (step == TypingStep::escaped) return std::nullopt;
    if (is_pressed(context, editor::Key::tab)) pass_on(state);
    const bool is_entered = step == TypingStep::entered;
    // What was not touched stays exactly as it is.
    if (state.typed == state.original)
        return is_entered ? std::optional(NumberEdit{field.value, EditPhase::commit, true}) : std::nullopt;
    const auto value = typed_number(field, state.typed);
    if (!value) {
        refuse(state, id, step, value.error());
        return std::nullopt;
    }
    if (field.is_whole && std::trunc(*value) != *value) {
        refuse(state, id, step,
               core::sentence("{value} is not a whole number", {{"value", editor::number_text(*value, 6)}}));
        return std::nullopt;
    }
    if (*value == field.value && !is_entered) return std::nullopt;
    return NumberEdit{*value, EditPhase::commit, is_entered};
}

std::optional<NumberEdit> type(const PanelContext& context, const NumberField& field, unsigned id, ImVec2 size) {
    FieldState& state = context.panels.field;
    const TypingStep step = draw_typing(context, size);
    report_item(context, field.name, state.typed);
    return step == TypingStep::goes_on ? std::nullopt : end_typed(context, field, id, step);
}

/// Whether Tab or Shift+Tab in another field leads here.
bool is_next(FieldState& state, const NumberField& field, unsigned id) {
    if (!field.is_enabled || state.is_typing) return false;
    return state.begins_next || state.wanted_id == id;
}

}  // namespace

std::optional<NumberEdit> edit_number(const PanelContext& context, const NumberField& field) {
    FieldState& state = context.panels.field;
    const unsigned id = ImGui::GetID(field.name.c_str());
    const float width = field.width_px > 0.0F ? field.width_px : ImGui::GetContentRegionAvail().x;
    const ImVec2 size(width, context.px(field.height));
    if (is_next(state, field, id)) begin_typing(state, id, core::shortest_text(field.value));
    const std::optional<NumberEdit> edit =
        is_typing(state, id) ? type(context, field, id, size) : press(context, field, id, size);
    draw_problem(context, id);
    if (field.is_enabled) state.previous_id = id;
    return edit;
}

void draw_number_field(const PanelContext& context, const NumberField& field,
                       const std::function<editor::Command(double)>& command) {
    const std::optional<NumberEdit> edit = edit_number(context, field);
    if (!edit) return;
    const bool changes_nothing = edit->value == field.value && (edit->is_entered || field.is_live);
    if (changes_nothing) return;
    if (edit->phase == EditPhase::cancel && !field.is_live) return context.queue.cancel_preview();
    editor::Command request = command(edit->value);
    if (edit->phase == EditPhase::preview && !field.is_live)
        context.queue.preview(std::move(request));
    else
        context.queue.run(std::move(request));
}

int decimals_in(const PanelContext& context, float width_px, double lowest, double highest) {
    const float room = width_px - 2.0F * context.px(number_padding);
    const double largest = std::max({std::abs(lowest), std::abs(highest), 1.0});
    const double whole = std::floor(std::log10(largest)) + (lowest < 0.0 ? 2.0 : 1.0);
    const double digits = std::floor(room / text_width("0", context.fonts.number));
    // One for the point.
    return static_cast<int>(std::clamp(digits - whole - 1.0, 0.0, 17.0));
}

double step_of(int decimals) {
    return std::pow(10.0, -decimals);
}

void drop_lost_field(const PanelContext& context) {
    FieldState& state = context.panels.field;
    if (state.active_id == 0 || state.last_frame + 1 >= ImGui::GetFrameCount()) return;
    if (state.is_dragging && !state.is_given_up) context.queue.cancel_preview();
    state.active_id = 0;
    state.is_typing = state.is_dragging = false;
}

}  // namespace batten::ui
