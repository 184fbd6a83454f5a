#include <fmt/core.h>
#include <imgui.h>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/group_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/state/selected_parts.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/style.h"
#include "app/ui/typing.h"
#include "core/base/sentence.h"

namespace batten::ui {
namespace {

constexpr double curve_row_height = 25.0;
constexpr double curve_overhang = 6.0;
constexpr double icon_width = 26.0;
constexpr double fold_width = 18.0;
constexpr std::size_t most_curve_rows = 8;
constexpr std::size_t swatches_in_row = 4;

core::DocumentColor document_color(render::Color color) {
    return {color.red, color.green, color.blue};
}

render::Color shown_color(const PanelContext& context, const core::DocumentCurve& curve) {
    if (!curve.color) return context.theme.curve;
    return {curve.color->red, curve.color->green, curve.color->blue, 255};
}

using Indices = std::vector<std::size_t>;

/// The name of a widget of a row, "curve 3 color"; of the heading of a group by that name.
std::string widget_name(const PanelContext& context, const CurveRow& row, const char* what) {
    if (row.is_heading) return fmt::format("group {} {}", context.state.shown().curves[row.curve].group, what);
    return fmt::format("curve {} {}", row.curve, what);
}

bool is_selected_whole(const editor::EditorState& state, std::size_t i) {
    if (i == state.history.present().active) return state.selection.is_whole;
    const editor::SelectedPart* part = editor::part_of(state.selection.others, i);
    return part != nullptr && part->is_whole();
}

/// What the widgets of a row are about: all of the group, all curves that are selected with this one, or it alone.
Indices curves_of(const PanelContext& context, const CurveRow& row) {
    const core::Document& document = context.state.shown();
    if (row.is_heading) return editor::curves_of_group(document, document.curves[row.curve].group);
    if (!is_selected_whole(context.state, row.curve)) return {row.curve};
    return editor::selected_curves(context.state);
}

void set_color(const PanelContext& context, const CurveRow& row, std::optional<core::DocumentColor> color) {
    const Indices curves = curves_of(context, row);
    if (curves.size() > 1)
        context.queue.run(editor::ColorCurves{.curves = curves, .color = color});
    else
        context.queue.run(editor::SetCurveColor{.index = row.curve, .color = color});
}

/// What was typed; a text that is no color is refused with a sentence.
void set_typed_color(const PanelContext& context, const CurveRow& row, const std::string& text) {
    if (const auto color = core::color_of_text(text))
        set_color(context, row, *color);
    else
        context.queue.change(editor::ShowRefusal{
            core::sentence("the color is '{text}'; it must be of the form #4c7fe0", {{"text", text}})});
}

bool draw_swatch(const PanelContext& context, const std::string& name, render::Color color, float size_px) {
    const bool is_clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(size_px, size_px));
    report_item(context, name, core::color_text(document_color(color)));
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), imgui_packed(color), context.px(4));
    const render::Color edge = ImGui::IsItemHovered() ? context.theme.text : context.theme.line;
    list->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), imgui_packed(edge), context.px(4), 0,
                  context.px(1));
    return is_clicked;
}

void draw_typed_color(const PanelContext& context, const CurveRow& row, const core::DocumentCurve& curve) {
    TextField field;
    field.name = "color typed";
    field.shown = curve.color ? core::color_text(*curve.color) : "#";
    field.width_px = context.px(4 * 26 + 3 * row_gap);
    field.font = context.fonts.number;
    field.tooltip = "Red, green and blue as #rrggbb";
    const TextEvents events = draw_text_field(context, field);
    if (events.begins) begin_typing(context.panels.field, events.id, field.shown);
    if (events.typed) set_typed_color(context, row, *events.typed);
}

void draw_color_popup(const PanelContext& context, const CurveRow& row, const core::DocumentCurve& curve) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(8), context.px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(row_gap), context.px(row_gap)));
    if (ImGui::BeginPopup("colors")) {
        if (is_pressed(context, editor::Key::escape) && !context.panels.field.is_typing) ImGui::CloseCurrentPopup();
        for (std::size_t k = 0; k < context.theme.palette.size(); ++k) {
            if (k % swatches_in_row != 0) stay_in_row(context);
            const render::Color color = context.theme.palette[k];
            if (draw_swatch(context, fmt::format("color {}", k), color, context.px(26)))
                set_color(context, row, document_color(color));
        }
        draw_typed_color(context, row, curve);
        Button none{"color none", "as the theme", Icon::none, context.px(4 * 26 + 3 * row_gap)};
        none.is_active = !curve.color;
        if (draw_button(context, none)) set_color(context, row, std::nullopt);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

void draw_color(const PanelContext& context, const CurveRow& row, ImVec2 origin) {
    const core::DocumentCurve& curve = context.state.shown().curves[row.curve];
    const float size = context.px(14);
    const float top = origin.y + 0.5F * (context.px(curve_row_height) - size);
    ImGui::SetCursorScreenPos(ImVec2(origin.x, top));
    if (draw_swatch(context, widget_name(context, row, "color"), shown_color(context, curve), size))
        ImGui::OpenPopup("colors");
    draw_color_popup(context, row, curve);
}

editor::SelectedParts wholes_of(const PanelContext& context, editor::SelectedParts parts, const Indices& curves) {
    for (const std::size_t i : editor::selectable(context.state.shown(), curves))
        parts = editor::with_part(std::move(parts), {i});
    return parts;
}

void select(const PanelContext& context, const editor::SelectedParts& parts) {
    context.queue.run(editor::SelectParts{.parts = editor::text_of_parts(parts)});
}

/// Ctrl takes the curve in or out, Shift takes all from the one that was clicked before.
void click_curve(const PanelContext& context, std::size_t i) {
    CurveListState& list = context.panels.inspector.curves;
    const std::size_t active = context.state.shown().active;
    const std::size_t anchor = list.anchor.value_or(active);
    if (ImGui::GetIO().KeyShift) return select(context, wholes_of(context, {}, curves_between(list.rows, anchor, i)));
    list.anchor = i;
    if (!ImGui::GetIO().KeyCtrl) {
        if (i != active)
            context.queue.run(editor::ActivateCurve{.index = i});
        else if (context.state.selection.is_over_curves())
            context.queue.run(editor::SelectNone{});
        return;
    }
    editor::SelectedParts parts = editor::selected_parts(context.state);
    if (is_selected_whole(context.state, i)) return select(context, editor::without_part(std::move(parts), {i}));
    if (parts.empty() && i != active) parts = wholes_of(context, {}, {active});
    select(context, editor::with_part(std::move(parts), {i}));
}

void click_group(const PanelContext& context, const CurveRow& row) {
    const bool adds = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
    select(context, wholes_of(context, adds ? editor::selected_parts(context.state) : editor::SelectedParts{},
                              curves_of(context, row)));
}

/// Begins to drag the entry that was drawn last.
void follow_drag(const PanelContext& context, const CurveRow& row) {
    CurveListState& list = context.panels.inspector.curves;
    if (list.is_given_up || !ImGui::IsItemActive() || !ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return;
    list.dragged = row;
}

TextField name_field(const PanelContext& context, const CurveRow& row, float width_px) {
    const core::DocumentCurve& curve = context.state.shown().curves[row.curve];
    TextField field;
    field.name = widget_name(context, row, "name");
    field.shown = row.is_heading ? curve.group : curve.name;
    field.width_px = width_px;
    field.height = curve_row_height;
    field.font = row.is_heading ? context.fonts.bold : context.fonts.text;
    field.has_frame = false;
    field.needs_double_click = true;
    field.tooltip = row.is_heading ? "Click to select the group, double-click to rename it, drag to move it in the list"
                                   : "Click to make it the active curve, with Ctrl or Shift to select several; "
                                     "double-click to rename it, drag to move it in the list";
    return field;
}

void draw_name(const PanelContext& context, const CurveRow& row, ImVec2 origin, float right) {
    const TextField field = name_field(context, row, right - origin.x - context.px(row_gap));
    ImGui::SetCursorScreenPos(origin);
    const TextEvents events = draw_text_field(context, field);
    if (!is_typing(context.panels.field, events.id)) follow_drag(context, row);
    if (events.begins) begin_typing(context.panels.field, events.id, field.shown);
    if (events.typed && row.is_heading)
        context.queue.run(editor::RenameGroup{.group = field.shown, .name = *events.typed});
    else if (events.typed)
        context.queue.run(editor::RenameCurve{.index = row.curve, .name = *events.typed});
    if (!events.is_clicked || context.panels.inspector.curves.is_given_up) return;
    if (row.is_heading)
        click_group(context, row);
    else
        click_curve(context, row.curve);
}

void set_visible(const PanelContext& context, const CurveRow& row, bool is_visible) {
    const Indices curves = curves_of(context, row);
    if (curves.size() == 1)
        context.queue.run(editor::SetCurveVisible{.index = row.curve, .visible = is_visible});
    else if (is_visible)
        context.queue.run(editor::ShowCurves{.curves = curves});
    else
        context.queue.run(editor::HideCurves{.curves = curves});
}

void set_locked(const PanelContext& context, const CurveRow& row, bool is_locked) {
    const Indices curves = curves_of(context, row);
    if (curves.size() == 1)
        context.queue.run(editor::SetCurveLocked{.index = row.curve, .locked = is_locked});
    else if (is_locked)
        context.queue.run(editor::LockCurves{.curves = curves});
    else
        context.queue.run(editor::UnlockCurves{.curves = curves});
}

void draw_switches(const PanelContext& context, const CurveRow& row, ImVec2 left) {
    const core::DocumentCurve& curve = context.state.shown().curves[row.curve];
    ImGui::SetCursorScreenPos(ImVec2(left.x, left.y + context.px(0.5)));
    Button eye{widget_name(context, row, "visible"), "", curve.visible ? Icon::eye : Icon::closed_eye,
               context.px(icon_width)};
    eye.has_frame = false;
    eye.tooltip = curve.visible ? "Shown; click to hide" : "Hidden; click to show";
    if (draw_button(context, eye)) set_visible(context, row, !curve.visible);
    stay_in_row(context, 0.0);
    Button lock{widget_name(context, row, "locked"), "", curve.locked ? Icon::lock : Icon::open_lock,
                context.px(icon_width)};
    lock.has_frame = false;
    lock.tooltip = curve.locked ? "Locked; click to allow edits" : "Click to lock against edits";
    if (draw_button(context, lock)) set_locked(context, row, !curve.locked);
}

/// Folds and unfolds a group.
void draw_fold_button(const PanelContext& context, const CurveRow& row) {
    const std::string& group = context.state.shown().curves[row.curve].group;
    std::set<std::string>& folded = context.panels.inspector.curves.folded_groups;
    const bool is_open = !folded.contains(group);
    const std::string name = widget_name(context, row, "fold");
    if (ImGui::InvisibleButton(name.c_str(), ImVec2(context.px(fold_width), context.px(curve_row_height)))) {
        if (is_open)
            folded.insert(group);
        else
            folded.erase(group);
    }
    report_item(context, name, is_open ? "open" : "folded");
    const ImVec2 lower = ImGui::GetItemRectMin();
    const ImVec2 upper = ImGui::GetItemRectMax();
    draw_fold_mark(context, ImVec2(0.5F * (lower.x + upper.x), 0.5F * (lower.y + upper.y)), is_open);
}

void draw_row_back(const PanelContext& context, const CurveRow& row, ImVec2 origin, ImVec2 end) {
    if (row.is_heading) return;
    const bool is_active = context.state.shown().active == row.curve;
    const bool is_hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(origin, end);
    if (is_hovered && !is_active) wish_hover(context, editor::HoveredOtherCurve{row.curve});
    if (is_hovered && asks_for_menu()) open_context_menu(context, editor::OnCurve{row.curve});
    const bool is_lit = context.state.hover == editor::Hover(editor::HoveredOtherCurve{row.curve});
    const bool is_selected = is_selected_whole(context.state, row.curve);
    if (!is_active && !is_lit && !is_selected) return;
    const double share = is_active ? 0.17 : is_selected ? 0.12 : 0.08;
    ImGui::GetWindowDrawList()->AddRectFilled(
        origin, end, imgui_packed(render::blended(context.theme.accent, share, context.theme.panel)), context.px(5));
    if (is_selected)
        ImGui::GetWindowDrawList()->AddRectFilled(origin, ImVec2(origin.x + context.px(3), end.y),
                                                  imgui_packed(context.theme.accent));
}

/// Where the dragged entry would go, while the pointer is on row `r`; near the edges the list scrolls.
void follow_drop(const PanelContext& context, std::size_t r, ImVec2 origin, ImVec2 end) {
    CurveListState& list = context.panels.inspector.curves;
    if (!list.dragged) return;
    const float y = ImGui::GetIO().MousePos.y;
    const float middle = 0.5F * (origin.y + end.y);
    const float line = y < middle ? origin.y : end.y;
    if (y < origin.y || y >= end.y) return;
    const std::size_t slot = y < middle ? r : r + 1;
    list.slot.reset();
    if (!can_be_dropped(list.rows, *list.dragged, slot)) return;
    list.slot = slot;
    ImGui::GetWindowDrawList()->AddLine(ImVec2(origin.x, line), ImVec2(end.x, line), imgui_packed(context.theme.accent),
                                        context.px(2));
    const float top = ImGui::GetWindowPos().y;
    const float reach = 0.5F * context.px(curve_row_height);
    if (y < top + reach) ImGui::SetScrollY(ImGui::GetScrollY() - 0.25F * reach);
    if (y > top + ImGui::GetWindowHeight() - reach) ImGui::SetScrollY(ImGui::GetScrollY() + 0.25F * reach);
}

void draw_curve_row(const PanelContext& context, std::size_t r, float width) {
    const CurveRow row = context.panels.inspector.curves.rows[r];
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 end(origin.x + width, origin.y + context.px(curve_row_height));
    draw_row_back(context, row, origin, end);
    ImGui::PushID(static_cast<int>(r));
    if (row.is_heading) draw_fold_button(context, row);
    const float indent = row.is_heading || row.is_member ? context.px(fold_width) : 0.0F;
    const float left = origin.x + context.px(curve_overhang) + indent;
    const float right = end.x - context.px(curve_overhang) - 2.0F * context.px(icon_width);
    draw_color(context, row, ImVec2(left, origin.y));
    draw_name(context, row, ImVec2(left + context.px(24), origin.y), right);
    draw_switches(context, row, ImVec2(right, origin.y));
    ImGui::PopID();
    follow_drop(context, r, origin, end);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(ImVec2(width, context.px(curve_row_height)));
}

/// Puts the dragged entry where it was let go.
void drop(const PanelContext& context, const CurveRow& row, std::size_t slot) {
    const CurveListState& list = context.panels.inspector.curves;
    const core::Document& document = context.state.history.present();
    if (row.curve >= document.curves.size() || slot > list.rows.size()) return;
    if (row.is_heading) {
        if (auto command = dropped_group(document, list.rows, row, slot)) context.queue.run(*std::move(command));
    } else if (auto command = dropped_curve(document, list.rows, row.curve, slot)) {
        context.queue.run(*std::move(command));
    }
}

/// Escape gives the drag up until the button is released.
void finish_drag(const PanelContext& context) {
    CurveListState& list = context.panels.inspector.curves;
    const bool is_held = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const bool is_given_up = list.is_given_up || is_pressed(context, editor::Key::escape);
    if (is_held && !is_given_up) return;
    if (list.dragged && list.slot && !is_given_up) drop(context, *list.dragged, *list.slot);
    list.is_given_up = is_held && is_given_up;
    list.dragged.reset();
    list.slot.reset();
}

void draw_buttons(const PanelContext& context) {
    const float width = (content_width(context) - 2.0F * context.px(row_gap)) / 3.0F;
    Button add{"new curve", "new", Icon::none, width};
    add.is_active = context.state.tool == editor::Tool::draw_curve;
    draw_command_button(context, add, editor::TakeTool<editor::Tool::draw_curve>{});
    stay_in_row(context);
    const bool are_several = context.state.selection.is_over_curves();
    draw_command_button(context, {"duplicate curve", "duplicate", Icon::none, width},
                        are_several ? editor::Duplicate::spec() : editor::DuplicateCurve::spec());
    stay_in_row(context);
    draw_command_button(context, {"delete curve", "delete", Icon::none, width},
                        are_several ? editor::Delete::spec() : editor::DeleteCurve::spec());
}

}  // namespace

void draw_curves_section(const PanelContext& context) {
    const std::size_t count = context.state.shown().curves.size();
    if (draw_section_heading(context, {"curves", "Curves", std::to_string(count), false})) {
        CurveListState& list = context.panels.inspector.curves;
        list.rows = curve_rows(context.state.shown(), list.folded_groups);
        if (count > 0)
            draw_row_list(context, {"curves", list.rows.size(), most_curve_rows, curve_row_height, curve_overhang},
                          draw_curve_row);
        finish_drag(context);
        draw_buttons(context);
    }
    add_space(context, 6);
}

}  // namespace batten::ui
