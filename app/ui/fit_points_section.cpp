#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "app/editor/commands/fit_point_commands.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/style.h"
#include "core/evaluate/evaluate.h"
#include "core/make/fit_points.h"

namespace batten::ui {
namespace {

constexpr double fit_row_height = 25.0;
constexpr double fit_overhang = 6.0;  // of a lit row beyond the margins
constexpr double fit_number_width = 44.0;
constexpr double fit_gap = 6.0;
constexpr double joint_share = 0.3;        // of the width of a row
constexpr std::size_t most_fit_rows = 10;  // more points scroll in their own region

const core::FitPoints& shown_fit(const PanelContext& context) {
    return *context.state.shown().active_curve()->fit;
}

void draw_fit_row_back(const PanelContext& context, std::size_t i, ImVec2 origin, float width) {
    const ImVec2 end(origin.x + width, origin.y + context.px(fit_row_height));
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(origin, end))
        wish_hover(context, editor::HoveredFitPoint{i});
    const bool is_selected = context.state.selection.fit_point == i;
    const bool is_lit = context.state.hover == editor::Hover(editor::HoveredFitPoint{i});
    if (!is_selected && !is_lit) return;
    const render::Color color = render::blended(context.theme.accent, is_selected ? 0.17 : 0.08, context.theme.panel);
    ImGui::GetWindowDrawList()->AddRectFilled(origin, end, imgui_packed(color), context.px(5));
}

void draw_fit_number(const PanelContext& context, std::size_t i, ImVec2 origin) {
    const std::string name = fmt::format("fit point {}", i);
    if (ImGui::InvisibleButton(name.c_str(),
                               ImVec2(context.px(fit_overhang + fit_number_width), context.px(fit_row_height))))
        context.queue.run(editor::SelectFitPoint{.index = i});
    report_item(context, name, context.state.selection.fit_point == i ? "selected" : "");
    draw_text(context, ImVec2(origin.x + context.px(fit_overhang), origin.y + 0.5F * context.px(fit_row_height)),
              {std::to_string(i), context.fonts.text, 0.0, context.theme.text, render::Anchor::left,
               context.px(fit_number_width)});
}

void draw_fit_coordinate(const PanelContext& context, std::size_t i, bool is_x, float width) {
    const core::Point place = shown_fit(context).points[i].place;
    const editor::Units& units = context.state.shown().units;
    NumberField field;
    field.name = fmt::format("fit point {} {}", i, is_x ? "x" : "y");
    field.value = editor::in_units(units, is_x ? place.x : place.y);
    field.length = units;
    const double size = context.state.derived.of(*context.state.active_curve())->size;
    field.extent = editor::in_units(units, size);
    field.decimals = editor::decimals_for(field.extent);
    field.speed = step_of(field.decimals);
    field.width_px = width;
    field.height = 20.0;
    field.is_enabled = is_editable(context.state);
    field.tooltip = locked_sentence(context.state);
    const double scale = editor::world_per_length(units);
    draw_number_field(context, field, [=](double value) {
        const core::Point moved = is_x ? core::Point(value * scale, place.y) : core::Point(place.x, value * scale);
        return editor::MoveFitPoint{.index = i, .position = moved};
    });
}

/// What the curve does there; a click offers what else it may do.
void draw_fit_joint(const PanelContext& context, std::size_t i, float width) {
    Button joint{fmt::format("fit point {} joint", i), core::title_of(shown_fit(context).points[i].joint), Icon::none,
                 width, 20.0};
    joint.is_small = true;
    joint.anchor = render::Anchor::left;
    joint.is_enabled = is_editable(context.state);
    joint.tooltip = locked_sentence(context.state);
    if (draw_button(context, joint)) open_context_menu(context, editor::OnPart{editor::HoveredFitPoint{i}});
}

void draw_fit_row(const PanelContext& context, std::size_t i, float width) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    draw_fit_row_back(context, i, origin, width);
    draw_fit_number(context, i, origin);
    const float rest = width - context.px(2.0 * fit_overhang + fit_number_width + 2.0 * fit_gap);
    const float joint_width = static_cast<float>(joint_share) * rest;
    const float coordinate_width = 0.5F * (rest - joint_width);
    ImGui::SetCursorScreenPos(ImVec2(origin.x + context.px(fit_overhang + fit_number_width),
                                     origin.y + context.px(0.5 * (fit_row_height - 20.0))));
    draw_fit_coordinate(context, i, true, coordinate_width);
    stay_in_row(context, fit_gap);
    draw_fit_coordinate(context, i, false, coordinate_width);
    stay_in_row(context, fit_gap);
    draw_fit_joint(context, i, joint_width);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(ImVec2(width, context.px(fit_row_height)));
}

template <class Enum, class Set>
void draw_fit_choice(const PanelContext& context, const char* label, const char* name, Enum present, const Set& set) {
    draw_row_label(context, label);
    const float width = field_width(context);
    const ChoiceField field{name, core::title_of(present), width, is_editable(context.state),
                            locked_sentence(context.state)};
    if (!begin_choices(context, field)) return;
    for (const auto& choice : core::Names<Enum>::table) {
        Button button{fmt::format("{} {}", name, choice.name), choice.title, Icon::none, width};
        button.is_active = choice.value == present;
        if (draw_choice(context, button)) context.queue.run(set(choice.value));
    }
    end_choices();
}

void draw_fit_form(const PanelContext& context, const core::FitPoints& fit) {
    draw_fit_choice(context, "Kind", "fit kind", fit.kind, [&](core::FitKind kind) {
        return editor::SetFitKind{.kind = kind, .parametrization = fit.parametrization, .closed = fit.closed};
    });
    draw_fit_choice(context, "Parameters", "fit parameters", fit.parametrization, [&](core::Parametrization by) {
        return editor::SetFitKind{.kind = fit.kind, .parametrization = by, .closed = fit.closed};
    });
}

/// On the curve in the middle of the span after the selected point, or as far beyond the end as the last span is long.
editor::InsertFitPoint inserted_point(const PanelContext& context, const core::FitPoints& fit) {
    const std::size_t last = fit.points.size() - 1;
    const std::size_t i = std::min(context.state.selection.fit_point.value_or(last), last);
    if (i == last && !fit.closed) {
        const core::Point end = fit.points[last].place;
        return {.index = last + 1, .position = end + (end - fit.points[last - 1].place)};
    }
    const double u = 0.5 * (fit.parameters[i] + fit.parameters[i + 1]);
    return {.index = i + 1, .position = core::point_at(*context.state.active_curve(), u)};
}

void draw_fit_buttons(const PanelContext& context, const core::FitPoints& fit) {
    Button add{"add fit point", "", Icon::plus, context.px(24), 18.0};
    add.tooltip = "Put in a point after the selected one, or at the end.\n\u2260 changes the shape";
    draw_command_button(context, add, inserted_point(context, fit));
    stay_in_row(context);
    Button remove{"delete fit point", "", Icon::minus, context.px(24), 18.0};
    const std::optional<std::size_t> selected = context.state.selection.fit_point;
    remove.is_enabled = selected.has_value();
    draw_command_button(context, remove, editor::DeleteFitPoint{.index = selected.value_or(0)});
}

}  // namespace

void draw_fit_points_section(const PanelContext& context) {
    if (context.state.shown().active_curve()->fit == nullptr) return;
    const core::FitPoints& fit = shown_fit(context);
    const std::size_t count = fit.points.size();
    if (draw_section_heading(context, {"fit points", "Fit points", std::to_string(count)})) {
        draw_fit_form(context, fit);
        draw_fit_buttons(context, fit);
        draw_row_list(context, {"fit points", count, most_fit_rows, fit_row_height, fit_overhang}, draw_fit_row);
    }
    add_space(context, 6);
}

}  // namespace batten::ui
