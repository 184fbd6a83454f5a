#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/fields/expression.h"
#include "app/editor/state/kept_joints.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/reading_text.h"
#include "app/ui/insert_row.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/style.h"
#include "app/ui/typing.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"

namespace batten::ui {
namespace {

constexpr double knot_row_height = 25.0;
constexpr double knot_overhang = 6.0;
constexpr double knot_name_width = 64.0;
constexpr double value_width = 92.0;
constexpr double multiplicity_width = 82.0;
constexpr double steps_width = 52.0;
constexpr std::size_t most_knot_rows = 10;
constexpr std::size_t shown_characters = 60;  // of the knot vector before it is typed

/// One run of equal knots, by its first and last index in stored().
struct Stack {
    core::DistinctKnot knot;
    std::size_t first = 0;
    std::size_t last = 0;
    double lowest = 0.0;  ///< the neighboring values
    double highest = 0.0;
};

struct KnotTable {
    const PanelContext& context;
    const core::Curve& curve;
    const std::vector<std::uint32_t>& runs;  ///< as KnotFacts has them
    int decimals = 3;
    float row_width = 0.0F;
    float value_width = 0.0F;
};

Stack stack_at(const KnotTable& table, std::size_t row) {
    const auto stored = table.curve.knots().stored();
    Stack stack{.knot = core::distinct_knot(table.curve.knots(), table.runs[row]), .first = table.runs[row]};
    const auto after = std::upper_bound(stored.begin(), stored.end(), stack.knot.value);
    stack.last = static_cast<std::size_t>(after - stored.begin()) - 1;
    stack.lowest = stack.first == 0 ? -std::numeric_limits<double>::infinity() : stored[stack.first - 1];
    stack.highest = after == stored.end() ? std::numeric_limits<double>::infinity() : stored[stack.last + 1];
    return stack;
}

/// The most knots that may be equal here.
int most_equal(const core::Curve& curve, const Stack& stack) {
    return curve.degree() + (stack.knot.is_interior ? 0 : 1);
}

bool is_selected(const PanelContext& context, const Stack& stack) {
    const std::optional<std::size_t> knot = context.state.selection.knot;
    return knot && *knot >= stack.first && *knot <= stack.last;
}

bool is_hovered(const PanelContext& context, const Stack& stack) {
    const auto* hover = std::get_if<editor::HoveredKnot>(&context.state.hover);
    return hover != nullptr && hover->index >= stack.first && hover->index <= stack.last;
}

void draw_row_back(const KnotTable& table, const Stack& stack, ImVec2 origin) {
    const PanelContext& context = table.context;
    const ImVec2 end(origin.x + table.row_width, origin.y + context.px(knot_row_height));
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(origin, end))
        wish_hover(context, editor::HoveredKnot{stack.last});
    const bool selected = is_selected(context, stack);
    if (!selected && !is_hovered(context, stack)) return;
    const render::Color color = render::blended(context.theme.accent, selected ? 0.17 : 0.08, context.theme.panel);
    const float inset = 0.5F * context.px(1);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(origin.x, origin.y + inset), ImVec2(end.x, end.y - inset),
                                              imgui_packed(color), context.px(5));
}

void draw_diamond(const PanelContext& context, ImVec2 center, render::Color color, bool is_filled) {
    const float r = context.px(5);
    ImDrawList* list = ImGui::GetWindowDrawList();
    const std::array corners{ImVec2(center.x, center.y - r), ImVec2(center.x + r, center.y),
                             ImVec2(center.x, center.y + r), ImVec2(center.x - r, center.y)};
    if (is_filled) list->AddConvexPolyFilled(corners.data(), 4, imgui_packed(color));
    list->AddPolyline(corners.data(), 4, imgui_packed(color), ImDrawFlags_Closed, context.px(1.3));
}

/// What stands in place of the diamond where edits keep the joint: the same as on the canvas.
void draw_mark(const PanelContext& context, ImVec2 center, render::Color color, core::JointMark mark) {
    const float r = context.px(4.5);
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (mark == core::JointMark::corner)
        list->AddRect(ImVec2(center.x - r, center.y - r), ImVec2(center.x + r, center.y + r), imgui_packed(color));
    else
        list->AddCircle(center, r, imgui_packed(color), 0, context.px(1.3));
    if (mark == core::JointMark::curvature) list->AddCircle(center, 0.5F * r, imgui_packed(color), 0, context.px(1.3));
}

std::string marked_sentence(core::JointMark mark) {
    return core::sentence("Edits keep this joint {mark}", {{"mark", core::title_of(mark)}});
}

void draw_name(const KnotTable& table, const Stack& stack, ImVec2 origin) {
    const PanelContext& context = table.context;
    const std::string indices =
        stack.first == stack.last ? fmt::format("{}", stack.first) : fmt::format("{}–{}", stack.first, stack.last);
    const std::string name = fmt::format("knot {} name", stack.first);
    if (ImGui::InvisibleButton(name.c_str(),
                               ImVec2(context.px(knot_overhang + knot_name_width), context.px(knot_row_height)))) {
        context.panels.inspector.followed_knot = stack.last;
        context.queue.run(editor::SelectKnot{.index = stack.last});
    }
    const auto mark = editor::mark_of_knot(*context.state.shown().active_curve(), stack.knot.value);
    if (mark && ImGui::IsItemHovered()) show_tooltip(context, marked_sentence(*mark));
    report_item(context, name,
                mark ? fmt::format("u{} {}", indices, core::name_of(*mark)) : fmt::format("u{}", indices));
    const float middle = origin.y + 0.5F * context.px(knot_row_height);
    const render::Color color = stack.knot.in_domain ? context.theme.text : context.theme.dim;
    if (mark)
        draw_mark(context, ImVec2(origin.x + context.px(knot_overhang + 8), middle), color, *mark);
    else
        draw_diamond(context, ImVec2(origin.x + context.px(knot_overhang + 8), middle),
                     is_selected(context, stack) ? context.theme.accent : color, is_selected(context, stack));
    draw_text(context, ImVec2(origin.x + context.px(knot_overhang + 20), middle),
              {fmt::format("u_{{{}}}", indices), context.fonts.text, 0.0, color, render::Anchor::left,
               context.px(knot_name_width - 22)});
}

/// Sets the knot to `u`; what reaches a neighbor joins it only where dragged knots do.
editor::Command value_command(const Stack& stack, core::KnotMove move, double u) {
    const std::size_t index = u < stack.knot.value ? stack.first : stack.last;
    const bool reaches_neighbor = u == stack.lowest || u == stack.highest;
    if (reaches_neighbor && move != core::KnotMove::snap) return editor::MoveKnot{.index = index, .u = u, .mode = move};
    return editor::SetKnot{.index = index, .u = u};
}

void draw_value(const KnotTable& table, const Stack& stack) {
    const PanelContext& context = table.context;
    NumberField field;
    field.name = fmt::format("knot {} value", stack.first);
    field.value = stack.knot.value;
    const auto stored = table.curve.knots().stored();
    field.decimals = table.decimals;
    field.extent = stored.back() - stored.front();
    field.most_decimals = decimals_in(context, table.value_width, stored.front(), stored.back());
    field.speed = step_of(table.decimals);
    field.width_px = table.value_width;
    field.height = 20.0;
    field.lowest = stack.lowest;
    field.highest = stack.highest;
    field.is_enabled = is_editable(context.state);
    field.tooltip = locked_sentence(context.state);
    if (field.is_enabled && stack.first != stack.last)
        field.tooltip = "Takes one knot out of the stack: the last one upwards, the first one downwards.";
    draw_number_field(context, field,
                      [stack, move = context.state.view.knot_move](double u) { return value_command(stack, move, u); });
}

void draw_multiplicity(const KnotTable& table, const Stack& stack, ImVec2 origin) {
    const PanelContext& context = table.context;
    const float middle = origin.y + 0.5F * context.px(knot_row_height);
    const float left = origin.x + context.px(knot_overhang + knot_name_width + 10) + table.value_width;
    const render::Color color = stack.knot.is_interior ? context.theme.text : context.theme.dim;
    const std::string count = fmt::format("×{}", stack.knot.multiplicity);
    const bool is_end = stack.knot.in_domain && !stack.knot.is_interior;
    const bool is_clamped = is_end && stack.knot.multiplicity > table.curve.degree();
    const std::string continuity = !stack.knot.in_domain ? "outside"
                                   : is_clamped          ? "clamped"
                                   : is_end              ? "end"
                                                         : editor::continuity_text(stack.knot.continuity);
    draw_text(context, ImVec2(left, middle), {count, context.fonts.text, 0.0, color});
    draw_text(context, ImVec2(left + context.px(26), middle),
              {continuity, context.fonts.text, 0.0, color, render::Anchor::left, context.px(48)});
    ImGui::SetCursorScreenPos(ImVec2(left, origin.y));
    ImGui::Dummy(ImVec2(context.px(70), context.px(knot_row_height)));
    report_item(context, fmt::format("knot {} continuity", stack.first),
                fmt::format("{} {}", count, editor::plain_text(continuity)));
}

void draw_steps(const KnotTable& table, const Stack& stack, ImVec2 origin) {
    const PanelContext& context = table.context;
    const float width = context.px(22);
    const float left = origin.x + table.row_width - context.px(knot_overhang + row_gap) - 2.0F * width;
    ImGui::SetCursorScreenPos(ImVec2(left, origin.y + context.px(0.5 * (knot_row_height - 20.0))));
    draw_command_button(context, {fmt::format("knot {} less", stack.first), "", Icon::minus, width, 20.0},
                        editor::DeleteKnot{.index = stack.last});
    stay_in_row(context);
    Button more{fmt::format("knot {} more", stack.first), "", Icon::plus, width, 20.0};
    more.is_enabled = stack.knot.in_domain && stack.knot.multiplicity < most_equal(table.curve, stack);
    if (!stack.knot.in_domain)
        more.tooltip = "The knot is outside the domain; knots are inserted only inside.";
    else if (!more.is_enabled)
        more.tooltip = core::sentence("The multiplicity is {multiplicity}, the most allowed here.",
                                      {{"multiplicity", stack.knot.multiplicity}});
    draw_command_button(context, more, editor::RaiseKnot{.index = stack.last});
}

void draw_knot_row(const KnotTable& table, std::size_t row) {
    const PanelContext& context = table.context;
    const Stack stack = stack_at(table, row);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    draw_row_back(table, stack, origin);
    draw_name(table, stack, origin);
    ImGui::SetCursorScreenPos(ImVec2(origin.x + context.px(knot_overhang + knot_name_width),
                                     origin.y + context.px(0.5 * (knot_row_height - 20.0))));
    draw_value(table, stack);
    draw_multiplicity(table, stack, origin);
    draw_steps(table, stack, origin);
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(ImVec2(table.row_width, context.px(knot_row_height)));
}

/// Brings the selected knot into sight once, after the selection changed elsewhere.
void follow_selection(const KnotTable& table) {
    const PanelContext& context = table.context;
    InspectorState& inspector = context.panels.inspector;
    const std::optional<std::size_t> knot = context.state.selection.knot;
    if (inspector.followed_knot == knot) return;
    inspector.followed_knot = knot;
    if (!knot || *knot >= table.curve.knots().stored().size()) return;
    const auto after = std::upper_bound(table.runs.begin(), table.runs.end(), *knot);
    const float top = static_cast<float>(after - table.runs.begin() - 1) * context.px(knot_row_height);
    const float free = ImGui::GetWindowHeight() - context.px(knot_row_height);
    if (top < ImGui::GetScrollY() || top > ImGui::GetScrollY() + free) ImGui::SetScrollY(top - 0.5F * free);
}

/// Enough for the domain and to tell neighboring knots apart.
int decimals_of(const core::Curve& curve, const editor::KnotFacts& facts) {
    const double length = curve.domain().length();
    const double span = length / static_cast<double>(facts.segment_count);
    return std::max(editor::decimals_for(length), editor::decimals_for(span) - 1);
}

void draw_knot_table(const PanelContext& context, const core::Curve& curve) {
    const auto facts = context.state.derived.of(curve.knots());
    KnotTable table{context, curve, facts->runs, decimals_of(curve, *facts)};
    const std::size_t count = table.runs.size();
    const float width = content_width(context) + 2.0F * context.px(knot_overhang);
    table.row_width = width - (count > most_knot_rows ? context.px(6) : 0.0F);
    const float free =
        table.row_width - context.px(2.0 * knot_overhang + knot_name_width + multiplicity_width + steps_width);
    table.value_width = std::clamp(free, context.px(52), context.px(value_width));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - context.px(knot_overhang));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild("knots",
                      ImVec2(width, context.px(knot_row_height) * static_cast<float>(std::min(count, most_knot_rows))),
                      false, count > most_knot_rows ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollbar);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    follow_selection(table);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), context.px(knot_row_height));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_knot_row(table, static_cast<std::size_t>(i));
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

struct MoveChoice {
    core::KnotMove move;
    const char* tooltip;
};

constexpr std::array move_choices{
    MoveChoice{core::KnotMove::stop, "A dragged knot stops before its neighbors and never joins them."},
    MoveChoice{core::KnotMove::push, "A dragged knot takes its neighbors along."},
    MoveChoice{core::KnotMove::snap, "A dragged knot jumps onto a near one and joins its stack."},
};

void draw_move_row(const PanelContext& context) {
    draw_row_label(context, "Dragging");
    const float width = (field_width(context) - 2.0F * context.px(row_gap)) / 3.0F;
    for (const MoveChoice& choice : move_choices) {
        const std::string text = core::name_of(choice.move);
        Button button{fmt::format("knot move {}", text), text, Icon::none, width};
        button.is_active = context.state.view.knot_move == choice.move;
        button.tooltip = choice.tooltip;
        if (draw_button(context, button)) context.queue.run(editor::SetKnotMove{.mode = choice.move});
        if (choice.move != move_choices.back().move) stay_in_row(context);
    }
}

std::string list_text(std::span<const double> values, std::size_t most_characters) {
    std::vector<std::string> texts;
    std::size_t characters = 0;
    for (const double value : values) {
        const bool is_full = characters > most_characters;
        texts.push_back(is_full ? "…" : core::shortest_text(value));
        if (is_full) break;
        characters += texts.back().size() + 2;
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

void draw_vector_row(const PanelContext& context, const core::Curve& curve) {
    FieldState& state = context.panels.field;
    const auto stored = curve.knots().stored();
    TextField field;
    field.name = "knot vector";
    field.shown = editor::reading_text(list_text(stored, shown_characters));
    field.width_px = content_width(context);
    field.font = context.fonts.number;
    field.is_enabled = is_editable(context.state);
    field.tooltip =
        curve.is_periodic() ? "One period of the knots. Click to type all of it." : "All knots. Click to type them.";
    const TextEvents events = draw_text_field(context, field);
    if (events.begins) begin_typing(state, events.id, list_text(stored, std::string::npos));
    if (events.typed) {
        const auto values = editor::parse_expressions(*events.typed);
        if (values) {
            context.queue.run(editor::SetKnots{.knots = *values});
        } else {
            set_problem(state, events.id, values.error());
        }
    }
    draw_problem(context, events.id);
}

}  // namespace

void draw_knots_section(const PanelContext& context) {
    const core::Curve& curve = *context.state.active_curve();
    const std::size_t segments = context.state.derived.of(curve.knots())->segment_count;
    const std::string info = core::sentence({.one = "{knots} · 1 segment", .many = "{knots} · {count} segments"},
                                            segments, {{"knots", curve.knots().stored().size()}});
    if (draw_section_heading(context, {"knots", "Knots", info, false})) {
        draw_insert_row(context, curve);
        draw_knot_table(context, curve);
        add_space(context, 4);
        draw_move_row(context);
        draw_vector_row(context, curve);
    }
    add_space(context, 6);
}

}  // namespace batten::ui
