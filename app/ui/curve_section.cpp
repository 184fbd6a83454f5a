#include <fmt/core.h>

#include <algorithm>

#include "app/editor/commands/brush_commands.h"
#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/stroke_commands.h"
#include "app/editor/commands/tear_commands.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "app/ui/command_entry.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/section.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/knot_edit.h"

namespace batten::ui {
namespace {

using core::KnotKind;

std::string family_text(const core::Curve& curve, const editor::KnotFacts& facts) {
    if (facts.is_bezier) return curve.is_rational() ? "rational Bézier" : "Bézier";
    return curve.is_rational() ? "NURBS" : "B-spline";
}

/// "NURBS · clamped · C^{2}"
std::string info_text(const core::Curve& curve, const editor::KnotFacts& facts) {
    const char* ends = curve.is_periodic() ? "periodic" : core::is_clamped(curve.knots()) ? "clamped" : "unclamped";
    return fmt::format("{} · {} · {}", family_text(curve, facts), ends,
                       facts.least_continuity ? editor::continuity_text(*facts.least_continuity) : "C^{∞}");
}

NumberField whole_field(const char* name, int value, int lowest, int highest) {
    NumberField field;
    field.name = name;
    field.value = value;
    field.decimals = 0;
    field.is_whole = true;
    field.lowest = lowest;
    field.highest = highest;
    return field;
}

void draw_degree_number(const PanelContext& context, const core::Curve& curve, float width_px) {
    NumberField field = whole_field("degree", curve.degree(), core::min_degree, core::max_degree);
    field.speed = 0.04;
    field.width_px = width_px;
    field.is_enabled = is_editable(context.state);
    field.tooltip = locked_sentence(context.state);
    draw_number_field(context, field,
                      [](double value) { return editor::SetDegree{.degree = static_cast<int>(value)}; });
}

/// How smooth the stroke of the last step is fitted, as long as that is the last step.
void draw_stroke_row(const PanelContext& context) {
    const editor::EditorState& state = context.state;
    if (editor::no_stroke(state) || state.stroke->curve != state.history.present().active) return;
    draw_row_label(context, "Smoothness");
    NumberField field =
        whole_field("stroke smoothness", state.stroke->smoothness, core::least_smoothness, core::most_smoothness);
    field.speed = 0.1;
    field.width_px = field_width(context);
    field.tooltip = "Drag to the right for a smoother stroke, to the left for one truer to the hand; from 0 to 10.";
    draw_number_field(context, field,
                      [](double value) { return editor::RefitStroke{.smoothness = static_cast<int>(value)}; });
}

/// How far the part that the last step faired may have moved, as long as that is the last step.
void draw_faired_row(const PanelContext& context) {
    const editor::EditorState& state = context.state;
    if (editor::no_faired_part(state) || state.faired->curve != state.history.present().active) return;
    draw_row_label(context, "Fair within");
    NumberField field;
    field.name = "faired distance";
    field.value = state.faired->distance;
    field.decimals = 17;
    field.most_decimals = 4;
    field.speed = 0.02;
    field.is_multiplicative = true;
    field.width_px = field_width(context);
    field.tooltip = "Drag to the right for a fairer part, to the left for one nearer to the old curve.";
    draw_number_field(context, field, [](double value) { return editor::RefairPart{.distance = value}; });
}

/// Another degree with the same control points.
void draw_degree_step(const PanelContext& context, const char* name, Icon icon, int degree) {
    Button button{name, "", icon, context.px(24)};
    button.is_enabled = degree >= core::min_degree && degree <= core::max_degree;
    draw_command_button(context, button, editor::SetDegree{.degree = degree});
}

/// Where there is no room for words the sign alone says whether the shape stays.
void draw_degree_buttons(const PanelContext& context, bool has_words, float width_px) {
    Button button{"degree raise", has_words ? "≅ raise" : "≅", Icon::none, width_px};
    button.is_small = has_words;
    draw_command_button(context, button, editor::Elevate{.by = 1});
    stay_in_row(context);
    button.name = "degree lower";
    button.text = has_words ? "≠ lower" : "≠";
    draw_command_button(context, button, editor::Reduce{.by = 1});
}

void draw_degree_row(const PanelContext& context, const core::Curve& curve) {
    const bool has_order = context.state.view.notation.degree == editor::DegreeOrOrder::order;
    draw_row_label(
        context, core::filled_as_needed(has_order ? "Degree, k = {order}" : "Degree", {{"order", curve.degree() + 1}}));
    const bool has_words = field_width(context) >= context.px(200);
    const float button_width = context.px(has_words ? 52 : 24);
    const float rest = field_width(context) - 2.0F * (button_width + context.px(24)) - 4.0F * context.px(row_gap);
    draw_degree_number(context, curve, rest);
    stay_in_row(context);
    draw_degree_step(context, "degree less", Icon::minus, curve.degree() - 1);
    stay_in_row(context);
    draw_degree_step(context, "degree more", Icon::plus, curve.degree() + 1);
    stay_in_row(context);
    draw_degree_buttons(context, has_words, button_width);
}

void draw_knot_choice(const PanelContext& context, const core::Curve& curve, KnotKind kind, float width_px) {
    const core::Result<core::Curve> result = core::set_knot_kind(curve, kind);
    Button button{fmt::format("knots {}", core::name_of(kind)), core::title_of(kind), Icon::none, width_px};
    const KnotKind present = context.state.derived.of(curve.knots())->kind;
    button.is_active = kind == present;
    button.is_enabled = result && (kind != KnotKind::custom || kind == present);
    if (kind == KnotKind::custom) button.tooltip = "Any other spacing: move a knot, or type the knots.";
    if (!result)
        button.tooltip =
            core::sentence("Not possible: {reason}.",
                           {{"reason", editor::refusal_words(context.state.shown().units, result.error())}});
    if (draw_choice(context, button)) context.queue.run(editor::SetKind{.kind = kind});
}

void draw_kind_row(const PanelContext& context, const core::Curve& curve) {
    draw_row_label(context, "Knots");
    const float width = field_width(context);
    const ChoiceField field{"knot kind", core::title_of(context.state.derived.of(curve.knots())->kind), width,
                            is_editable(context.state), locked_sentence(context.state)};
    if (!begin_choices(context, field)) return;
    for (const auto& kind : core::Names<KnotKind>::table) draw_knot_choice(context, curve, kind.value, width);
    end_choices();
}

constexpr double least_tears_width = 96.0;

void draw_tears_box(const PanelContext& context, float width_px) {
    const core::DocumentCurve& active = *context.state.shown().active_curve();
    const bool is_allowed =
        active.tears == core::Tears::allow || context.state.derived.of(active.curve->knots())->is_torn();
    const editor::CommandSpec& spec = is_allowed ? editor::ForbidTears::spec() : editor::AllowTears::spec();
    Button box{"tears", "may tear", Icon::none, width_px};
    box.is_active = is_allowed;
    box.is_enabled = !spec.refusal(context.state);
    box.tooltip = command_tooltip(spec, context.state);
    if (draw_check_box(context, box)) run_command(context, spec);
}

void draw_closed_row(const PanelContext& context, const core::Curve& curve) {
    draw_row_label(context, "Closed");
    Button box{"closed", "", Icon::none,
               std::min(0.4F * field_width(context), field_width(context) - context.px(least_tears_width))};
    box.is_active = curve.is_periodic();
    // A closed curve opens only with enough points for its degree; anything can be closed.
    const bool is_possible =
        !curve.is_periodic() || curve.control_points().size() > static_cast<std::size_t>(curve.degree());
    box.is_enabled = is_possible && is_editable(context.state);
    box.tooltip = is_possible
                      ? locked_sentence(context.state)
                      : core::sentence("Not possible: {reason}.",
                                       {{"reason", editor::refusal_words(context.state.shown().units,
                                                                         core::set_periodic(curve, false).error())}});
    if (draw_check_box(context, box)) context.queue.run(editor::CloseOrOpen{});
    stay_in_row(context);
    draw_tears_box(context, field_width(context) - box.width_px - context.px(row_gap));
}

}  // namespace

void draw_curve_section(const PanelContext& context) {
    const core::Curve& curve = *context.state.active_curve();
    if (draw_section_heading(context, {"curve", "Curve", info_text(curve, *context.state.derived.of(curve.knots()))})) {
        draw_stroke_row(context);
        draw_faired_row(context);
        draw_degree_row(context, curve);
        draw_kind_row(context, curve);
        draw_closed_row(context, curve);
    }
    add_space(context, 6);
}

}  // namespace batten::ui
