#include <fmt/core.h>
#include <imgui.h>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
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
constexpr std::size_t most_curve_rows = 8;
constexpr std::size_t swatches_in_row = 4;

core::DocumentColor document_color(render::Color color) {
    return {color.red, color.green, color.blue};
}

render::Color shown_color(const PanelContext& context, const core::DocumentCurve& curve) {
    if (!curve.color) return context.theme.curve;
    return {curve.color->red, curve.color->green, curve.color->blue, 255};
}

void set_color(const PanelContext& context, std::size_t i, std::optional<core::DocumentColor> color) {
    context.queue.run(editor::SetCurveColor{.index = i, .color = color});
}

/// What was typed; a text that is no color is refused with a sentence.
void set_typed_color(const PanelContext& context, std::size_t i, const std::string& text) {
    if (const auto color = core::color_of_text(text))
        set_color(context, i, *color);
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

void draw_typed_color(const PanelContext& context, std::size_t i, const core::DocumentCurve& curve) {
    TextField field;
    field.name = "color typed";
    field.shown = curve.color ? core::color_text(*curve.color) : "#";
    field.width_px = context.px(4 * 26 + 3 * row_gap);
    field.font = context.fonts.number;
    field.tooltip = "Red, green and blue as #rrggbb";
    const TextEvents events = draw_text_field(context, field);
    if (events.begins) begin_typing(context.panels.field, events.id, field.shown);
    if (events.typed) set_typed_color(context, i, *events.typed);
}

void draw_color_popup(const PanelContext& context, std::size_t i, const core::DocumentCurve& curve) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(8), context.px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(row_gap), context.px(row_gap)));
    if (ImGui::BeginPopup("colors")) {
        if (is_pressed(context, editor::Key::escape) && !context.panels.field.is_typing) ImGui::CloseCurrentPopup();
        for (std::size_t k = 0; k < context.theme.palette.size(); ++k) {
            if (k % swatches_in_row != 0) stay_in_row(context);
            const render::Color color = context.theme.palette[k];
            if (draw_swatch(context, fmt::format("color {}", k), color, context.px(26)))
                set_color(context, i, document_color(color));
        }
        draw_typed_color(context, i, curve);
        Button none{"color none", "as the theme", Icon::none, context.px(4 * 26 + 3 * row_gap)};
        none.is_active = !curve.color;
        if (draw_button(context, none)) set_color(context, i, std::nullopt);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

void draw_color(const PanelContext& context, std::size_t i, const core::DocumentCurve& curve, ImVec2 origin) {
    const float size = context.px(14);
    const float top = origin.y + 0.5F * (context.px(curve_row_height) - size);
    ImGui::SetCursorScreenPos(ImVec2(origin.x + context.px(curve_overhang), top));
    const std::string name = fmt::format("curve {} color", i);
    if (draw_swatch(context, name, shown_color(context, curve), size)) ImGui::OpenPopup("colors");
    draw_color_popup(context, i, curve);
}

void draw_name(const PanelContext& context, std::size_t i, const core::DocumentCurve& curve, ImVec2 origin,
               float right) {
    TextField field;
    field.name = fmt::format("curve {} name", i);
    field.shown = curve.name;
    const float left = origin.x + context.px(curve_overhang + 24);
    field.width_px = right - left - context.px(row_gap);
    field.height = curve_row_height;
    field.font = context.fonts.text;
    field.has_frame = false;
    field.needs_double_click = true;
    field.tooltip = "Click to make it the active curve, double-click to rename it";
    ImGui::SetCursorScreenPos(ImVec2(left, origin.y));
    const TextEvents events = draw_text_field(context, field);
    if (events.begins) begin_typing(context.panels.field, events.id, curve.name);
    if (events.typed) context.queue.run(editor::RenameCurve{.index = i, .name = *events.typed});
    if (events.is_clicked && context.state.shown().active != i) context.queue.run(editor::ActivateCurve{.index = i});
}

void draw_switches(const PanelContext& context, std::size_t i, const core::DocumentCurve& curve, ImVec2 origin,
                   float left) {
    ImGui::SetCursorScreenPos(ImVec2(left, origin.y + context.px(0.5)));
    Button eye{fmt::format("curve {} visible", i), "", curve.visible ? Icon::eye : Icon::closed_eye,
               context.px(icon_width)};
    eye.has_frame = false;
    eye.tooltip = curve.visible ? "Shown; click to hide" : "Hidden; click to show";
    if (draw_button(context, eye)) context.queue.run(editor::SetCurveVisible{.index = i, .visible = !curve.visible});
    stay_in_row(context, 0.0);
    Button lock{fmt::format("curve {} locked", i), "", curve.locked ? Icon::lock : Icon::open_lock,
                context.px(icon_width)};
    lock.has_frame = false;
    lock.tooltip = curve.locked ? "Locked; click to allow edits" : "Click to lock against edits";
    if (draw_button(context, lock)) context.queue.run(editor::SetCurveLocked{.index = i, .locked = !curve.locked});
}

void draw_curve_row(const PanelContext& context, std::size_t i, float width) {
    const core::DocumentCurve& curve = context.state.shown().curves[i];
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 end(origin.x + width, origin.y + context.px(curve_row_height));
    const bool is_active = context.state.shown().active == i;
    const bool is_hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(origin, end);
    if (is_hovered && !is_active) wish_hover(context, editor::HoveredOtherCurve{i});
    if (is_hovered && asks_for_menu()) open_context_menu(context, editor::OnCurve{i});
    const bool is_lit = context.state.hover == editor::Hover(editor::HoveredOtherCurve{i});
    if (is_active || is_lit) {
        const render::Color color = render::blended(context.theme.accent, is_active ? 0.17 : 0.08, context.theme.panel);
        ImGui::GetWindowDrawList()->AddRectFilled(origin, end, imgui_packed(color), context.px(5));
    }
    ImGui::PushID(static_cast<int>(i));
    const float right = end.x - context.px(curve_overhang) - 2.0F * context.px(icon_width);
    draw_color(context, i, curve, origin);
    draw_name(context, i, curve, origin, right);
    draw_switches(context, i, curve, origin, right);
    ImGui::PopID();
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(ImVec2(width, context.px(curve_row_height)));
}

void draw_buttons(const PanelContext& context) {
    const float width = (content_width(context) - 2.0F * context.px(row_gap)) / 3.0F;
    Button add{"new curve", "new", Icon::none, width};
    add.is_active = context.state.tool == editor::Tool::draw_curve;
    draw_command_button(context, add, editor::TakeTool<editor::Tool::draw_curve>{});
    stay_in_row(context);
    draw_command_button(context, {"duplicate curve", "duplicate", Icon::none, width}, editor::DuplicateCurve::spec());
    stay_in_row(context);
    draw_command_button(context, {"delete curve", "delete", Icon::none, width}, editor::DeleteCurve::spec());
}

}  // namespace

void draw_curves_section(const PanelContext& context) {
    const std::size_t count = context.state.shown().curves.size();
    if (draw_section_heading(context, {"curves", "Curves", std::to_string(count), false})) {
        if (count > 0)
            draw_row_list(context, {"curves", count, most_curve_rows, curve_row_height, curve_overhang},
                          draw_curve_row);
        draw_buttons(context);
    }
    add_space(context, 6);
}

}  // namespace batten::ui
