#include "app/ui/insert_row.h"

#include <imgui.h>

#include <algorithm>

#include "app/editor/commands/knot_commands.h"
#include "app/editor/words/formula.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/section.h"
#include "core/base/sentence.h"

namespace batten::ui {
namespace {

NumberField insert_field(const PanelContext& context, const core::Curve& curve) {
    NumberField field;
    field.name = "insert u";
    field.value = context.panels.inspector.insert_at.value_or(context.state.parameter());
    field.decimals = editor::decimals_for(curve.domain().length());
    field.speed = step_of(field.decimals);
    field.lowest = curve.domain().lower;
    field.highest = curve.domain().upper;
    field.is_enabled = is_editable(context.state);
    field.tooltip = locked_sentence(context.state);
    return field;
}

/// Enter in the field inserts at once; the click on the button that may follow is not to insert again.
bool was_inserted_by_enter(const PanelContext& context, const core::Curve& curve, double u) {
    const auto knots = curve.knots().stored();
    return context.panels.inspector.inserted_at == u && std::binary_search(knots.begin(), knots.end(), u);
}

void draw_insert_button(const PanelContext& context, const core::Curve& curve, Button button, double u) {
    if (!was_inserted_by_enter(context, curve, u))
        return draw_command_button(context, std::move(button), editor::InsertKnot{.u = u});
    button.is_enabled = false;
    button.tooltip = core::sentence("Enter has inserted the knot {u}; press it there again for another one.",
                                    {{"u", editor::number_text(u)}});
    draw_button(context, button);
}

/// Keeps the row where it is while the pointer is on it, though the lists above and below it grow.
void hold_insert_row(const PanelContext& context) {
    InspectorState& inspector = context.panels.inspector;
    const float y = ImGui::GetCursorPosY();
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 end(origin.x + content_width(context), origin.y + context.px(24));
    const float shift = y - inspector.insert_row_y.value_or(y);
    if (shift != 0.0F) {
        inspector.scroll_y = ImGui::GetScrollY() + shift;
        ImGui::SetScrollY(inspector.scroll_y);
    }
    const bool is_on_row = ImGui::IsMouseHoveringRect({origin.x, origin.y - shift}, {end.x, end.y - shift}, false);
    inspector.insert_row_y = is_on_row ? std::optional(y) : std::nullopt;
}

}  // namespace

void draw_insert_row(const PanelContext& context, const core::Curve& curve) {
    hold_insert_row(context);
    draw_row_label(context, "Insert at u");
    const bool is_narrow = field_width(context) < context.px(190);
    Button insert{"insert knot", "insert", Icon::none, context.px(is_narrow ? 42 : 62)};
    Button midpoints{"insert midpoints", is_narrow ? "mid" : "midpoints", Icon::none, context.px(is_narrow ? 34 : 62)};
    insert.is_small = is_narrow;
    midpoints.is_small = true;
    NumberField field = insert_field(context, curve);
    field.width_px = field_width(context) - insert.width_px - midpoints.width_px - 2.0F * context.px(row_gap);
    const std::optional<NumberEdit> edit = edit_number(context, field);
    InspectorState& inspector = context.panels.inspector;
    if (edit) inspector.insert_at = edit->value;
    const double u = edit ? edit->value : field.value;
    if (edit && edit->is_entered) {
        inspector.inserted_at = u;
        context.queue.run(editor::InsertKnot{.u = u});
    }
    stay_in_row(context);
    draw_insert_button(context, curve, insert, u);
    stay_in_row(context);
    draw_command_button(context, midpoints, editor::InsertMidpoints{});
}

}  // namespace batten::ui
