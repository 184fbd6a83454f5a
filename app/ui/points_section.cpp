#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/selected_parts.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

constexpr double point_row_height = 25.0;
constexpr double point_overhang = 6.0;     // of a lit row beyond the margins
constexpr double point_name_width = 64.0;  // before the first field
constexpr double coordinate_gap = 8.0;
constexpr std::size_t most_point_rows = 12;  // more points scroll in their own region
constexpr double largest_weight = 1e9;

/// What the rows have in common.
struct PointTable {
    const PanelContext& context;
    const core::Curve& curve;
    double extent = 0.0;  ///< of the points, in the document's unit
    int decimals = 2;
    int weight_decimals = 2;
    float row_width = 0.0F;
    float field_width = 0.0F;
    int most_decimals = 0;  ///< for which the fields have room
    int most_weight_decimals = 0;

    const editor::Units& units() const { return context.state.shown().units; }
};

/// Shift adds all from the nearest selected point on.
void extend_to(std::vector<std::size_t>& points, std::size_t i) {
    const auto distance = [i](std::size_t k) { return k < i ? i - k : k - i; };
    const std::size_t anchor = *std::min_element(
        points.begin(), points.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    for (std::size_t k = std::min(anchor, i); k <= std::max(anchor, i); ++k) points.push_back(k);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

void toggle(std::vector<std::size_t>& points, std::size_t i) {
    const auto place = std::lower_bound(points.begin(), points.end(), i);
    if (place != points.end() && *place == i)
        points.erase(place);
    else
        points.insert(place, i);
}

void select(const PanelContext& context, std::size_t i) {
    std::vector<std::size_t> points = context.state.selection.points;
    if (ImGui::GetIO().KeyShift && !points.empty())
        extend_to(points, i);
    else if (ImGui::GetIO().KeyCtrl)
        toggle(points, i);
    else
        points = {i};
    // The row that was clicked is in sight already.
    context.panels.inspector.followed_points = points;
    const bool keeps_others = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
    editor::Selection selection = keeps_others ? context.state.selection : editor::Selection{};
    if (selection.others.empty()) {
        context.queue.run(editor::SelectPoints{.points = points});
        return;
    }
    selection.points = std::move(points);
    selection.is_whole = false;
    const std::size_t active = context.state.history.present().active;
    context.queue.run(editor::SelectParts{.parts = editor::text_of_parts(editor::selected_parts(selection, active))});
}

void draw_row_back(const PointTable& table, std::size_t i, ImVec2 origin) {
    const PanelContext& context = table.context;
    const ImVec2 end(origin.x + table.row_width, origin.y + context.px(point_row_height));
    const bool is_selected = context.state.selection.contains_point(i);
    const bool is_hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(origin, ImVec2(end.x, end.y));
    if (is_hovered) wish_hover(context, editor::HoveredPoint{i});
    const bool is_lit = context.state.hover == editor::Hover(editor::HoveredPoint{i});
    if (!is_selected && !is_lit) return;
    const render::Color color = render::blended(context.theme.accent, is_selected ? 0.17 : 0.08, context.theme.panel);
    const float inset = 0.5F * context.px(1);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(origin.x, origin.y + inset), ImVec2(end.x, end.y - inset),
                                              imgui_packed(color), context.px(5));
}

void draw_name(const PointTable& table, std::size_t i, ImVec2 origin) {
    const PanelContext& context = table.context;
    const std::string text = fmt::format("P_{{{}}}", i);
    const std::string name = fmt::format("point {} name", i);
    if (ImGui::InvisibleButton(name.c_str(),
                               ImVec2(context.px(point_overhang + point_name_width), context.px(point_row_height))))
        select(context, i);
    const bool is_selected = context.state.selection.contains_point(i);
    report_item(context, name, is_selected ? fmt::format("P{} selected", i) : fmt::format("P{}", i));
    const float middle = origin.y + 0.5F * context.px(point_row_height);
    const ImVec2 dot(origin.x + context.px(point_overhang + 8), middle);
    const std::size_t hue = editor::point_hue(*context.state.shown().active_curve(), i);
    ImGui::GetWindowDrawList()->AddCircleFilled(dot, context.px(5), imgui_packed(context.theme.point(hue)));
    draw_text(
        context, ImVec2(origin.x + context.px(point_overhang + 20), middle),
        {text, context.fonts.text, 0.0, context.theme.text, render::Anchor::left, context.px(point_name_width - 20)});
}

NumberField field_of(const PointTable& table, std::size_t i, const char* axis, double value) {
    NumberField field;
    field.name = fmt::format("point {} {}", i, axis);
    field.value = value;
    field.decimals = table.decimals;
    field.most_decimals = table.most_decimals;
    field.speed = step_of(table.decimals);
    field.width_px = table.field_width;
    field.height = 20.0;
    field.is_enabled = is_editable(table.context.state);
    field.tooltip = locked_sentence(table.context.state);
    return field;
}

NumberField coordinate_field(const PointTable& table, std::size_t i, const char* axis, double world) {
    NumberField field = field_of(table, i, axis, editor::in_units(table.units(), world));
    field.length = table.units();
    field.extent = table.extent;
    return field;
}

void draw_coordinates(const PointTable& table, std::size_t i) {
    const core::Point point = table.curve.control_points()[i];
    const double scale = editor::world_per_length(table.units());
    draw_number_field(table.context, coordinate_field(table, i, "x", point.x), [=](double x) {
        return editor::SetPoint{.index = i, .position = {x * scale, point.y}};
    });
    stay_in_row(table.context, coordinate_gap);
    draw_number_field(table.context, coordinate_field(table, i, "y", point.y), [=](double y) {
        return editor::SetPoint{.index = i, .position = {point.x, y * scale}};
    });
}

void draw_weight(const PointTable& table, std::size_t i) {
    NumberField field = field_of(table, i, "w", table.curve.weights()[i]);
    field.decimals = table.weight_decimals;
    field.most_decimals = table.most_weight_decimals;
    field.speed = 0.01;
    field.is_multiplicative = true;
    field.lowest = 1.0 / largest_weight;
    field.highest = largest_weight;
    draw_number_field(table.context, field, [i](double w) { return editor::SetWeight{.index = i, .weight = w}; });
}

void draw_point_row(const PointTable& table, std::size_t i) {
    const PanelContext& context = table.context;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    draw_row_back(table, i, origin);
    draw_name(table, i, origin);
    const float inset = context.px(0.5 * (point_row_height - 20.0));
    ImGui::SetCursorScreenPos(ImVec2(origin.x + context.px(point_overhang + point_name_width), origin.y + inset));
    draw_coordinates(table, i);
    stay_in_row(context, coordinate_gap);
    draw_weight(table, i);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(ImVec2(table.row_width, context.px(point_row_height)));
}

/// The place where a new point goes: in the middle of the leg after the last selected point, or beyond the end.
editor::AddPoint add_command(const editor::EditorState& state) {
    const auto points = state.active_curve()->control_points();
    const std::size_t n = points.size();
    const std::size_t before = state.selection.points.empty() ? n - 1 : std::min(state.selection.points.back(), n - 1);
    const bool has_next = before + 1 < n || state.active_curve()->is_periodic();
    const core::Point place = has_next ? core::middle(points[before], points[(before + 1) % n])
                                       : points[before] + 0.5 * (points[before] - points[before - 1]);
    return editor::AddPoint{.index = before + 1, .position = {place.x, place.y}};
}

void draw_header(const PointTable& table) {
    const PanelContext& context = table.context;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    Button add{"add point", "", Icon::plus, context.px(24), 18.0};
    add.tooltip = "Add a control point after the selected one, or at the end.\n\u2260 changes the shape";
    draw_command_button(context, add, add_command(context.state));
    stay_in_row(context);
    draw_command_button(context, {"delete points", "", Icon::minus, context.px(24), 18.0},
                        editor::DeletePoints::spec());
    float x = origin.x + context.px(point_name_width + 8);
    const std::string unit = editor::unit_ending(table.units());
    for (const std::string& axis : {fmt::format("x{}", unit), fmt::format("y{}", unit), std::string("w")}) {
        draw_text(context, ImVec2(x, origin.y + context.px(9)), {axis, context.fonts.small, 0.0, context.theme.dim});
        x += table.field_width + context.px(coordinate_gap);
    }
}

/// Brings the first selected row into sight once, after the selection changed elsewhere.
void follow_selection(const PanelContext& context) {
    InspectorState& inspector = context.panels.inspector;
    const std::vector<std::size_t>& points = context.state.selection.points;
    if (inspector.followed_points == points) return;
    inspector.followed_points = points;
    if (points.empty()) return;
    const float height = context.px(point_row_height);
    const float top = static_cast<float>(points.front()) * height;
    const bool is_in_sight =
        top >= ImGui::GetScrollY() && top + height <= ImGui::GetScrollY() + ImGui::GetWindowHeight();
    if (!is_in_sight) ImGui::SetScrollY(top - 0.5F * (ImGui::GetWindowHeight() - height));
}

void draw_rows(const PointTable& table, std::size_t count) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), table.context.px(point_row_height));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_point_row(table, static_cast<std::size_t>(i));
    ImGui::PopStyleVar();
}

void draw_point_table(const PanelContext& context, const core::Curve& curve) {
    const std::size_t count = curve.control_points().size();
    const bool scrolls = count > most_point_rows;
    const float bar = scrolls ? context.px(6) : 0.0F;
    const float fields = content_width(context) - context.px(point_name_width + 2.0 * coordinate_gap) - bar;
    const float field_width = std::floor(fields / 3.0F);
    const auto facts = context.state.derived.of(curve);
    const auto weights = context.state.derived.weights_of(curve);
    const editor::Units& units = context.state.shown().units;
    const core::Point lower = editor::in_units(units, facts->control_box.lower);
    const core::Point upper = editor::in_units(units, facts->control_box.upper);
    const double extent = editor::in_units(units, facts->size);
    const PointTable table{context,
                           curve,
                           extent,
                           editor::decimals_for(extent),
                           std::max(2, weights->column.decimals),
                           content_width(context) + 2.0F * context.px(point_overhang) - bar,
                           field_width,
                           decimals_in(context, field_width, std::min(lower.x, lower.y), std::max(upper.x, upper.y)),
                           decimals_in(context, field_width, 0.0, weights->heaviest)};
    draw_header(table);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - context.px(point_overhang));
    const float height = context.px(point_row_height) * static_cast<float>(std::min(count, most_point_rows));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild("points", ImVec2(content_width(context) + 2.0F * context.px(point_overhang), height), false,
                      scrolls ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollbar);
    follow_selection(context);
    draw_rows(table, count);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_points_section(const PanelContext& context) {
    const core::Curve& curve = *context.state.active_curve();
    if (draw_section_heading(context, {"points", "Control points", std::to_string(curve.control_points().size())}))
        draw_point_table(context, curve);
    add_space(context, 6);
}

}  // namespace batten::ui
