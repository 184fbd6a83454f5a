#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/derived/blend_lines.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/section.h"
#include "app/ui/style.h"
#include "app/ui/triangle_view.h"
#include "core/base/sentence.h"

namespace batten::ui {
namespace {

constexpr double label_width = 42.0;
constexpr double line_pitch = 20.0;
constexpr int formula_lines = 4;
constexpr int rational_formula_lines = 7;
constexpr std::size_t most_buttons = 5;  // of the row of steps; a higher degree gets - and +

/// What the section shows.
struct Construction {
    const PanelContext& context;
    const core::Curve& curve;
    core::DeBoorTriangle triangle;

    editor::NamedTriangle named() const { return {curve, triangle, context.state.view.notation}; }

    std::size_t degree() const { return triangle.levels.size() - 1; }

    /// The last level drawn.
    std::size_t level() const { return editor::shown_level(context.state.view, curve.degree()); }

    std::string point_text(core::Point point) const {
        return editor::place_text(context.state.shown().units, context.state.derived.of(curve)->size, point);
    }
};

std::string title_text(const Construction& shown) {
    const bool is_bezier = shown.context.state.derived.of(shown.curve.knots())->is_bezier;
    return core::sentence(is_bezier ? "De Casteljau at u = {u}" : "De Boor at u = {u}",
                          {{"u", editor::parameter_text(shown.curve, shown.triangle.u)}});
}

/// "span [0.25, 0.5)"; the last span holds its end too.
std::string span_text(const Construction& shown) {
    const core::KnotVector& knots = shown.curve.knots();
    const std::size_t s = shown.triangle.span;
    const bool is_last = knots[s + 1] == shown.curve.domain().upper && !shown.curve.is_periodic();
    return core::sentence(is_last ? "span [{begin}, {end}]" : "span [{begin}, {end})",
                          {{"begin", editor::number_text(knots[s], 6)}, {"end", editor::number_text(knots[s + 1], 6)}});
}

/// A line of the formula box.
struct FormulaLine {
    std::string text;
    render::Color color;
    bool is_prose = false;
};

FormulaLine point_line(const Construction& shown, core::CellPlace place) {
    const core::DeBoorCell& cell = shown.named().cell(place);
    const std::string point = fmt::format("{} = {}", shown.named().point(place), shown.point_text(cell.point));
    if (!shown.curve.is_rational()) return {point, shown.context.theme.text};
    return {fmt::format("{}  w {}", point, editor::number_text(cell.weight, 6)), shown.context.theme.text};
}

/// The weight, and the point in homogeneous form.
void add_rational_lines(std::vector<FormulaLine>& lines, const Construction& shown,
                        const editor::BlendedCell& blended) {
    const editor::WeightFormula weight = editor::weight_formula(blended);
    lines.push_back({weight.symbols, shown.context.theme.text});
    lines.push_back({weight.numbers, shown.context.theme.text});
    lines.push_back({editor::homogeneous_line(blended), shown.context.theme.text});
}

std::vector<FormulaLine> lines_of_cell(const Construction& shown, core::CellPlace place) {
    const editor::Theme& theme = shown.context.theme;
    const FormulaLine point = point_line(shown, place);
    if (place.level == 0) return {{"a control point", theme.dim, true}, point};
    const editor::AlphaFormula formula = editor::alpha_formula(shown.named(), place);
    const editor::BlendedCell blended{shown.named(), place};
    const render::Color color = theme.level(place.level);
    std::vector<FormulaLine> lines{{formula.symbols, color}, {formula.numbers, theme.text}};
    if (shown.curve.is_rational()) add_rational_lines(lines, shown, blended);
    lines.push_back({editor::blend_line(blended), color});
    lines.push_back(point);
    return lines;
}

std::vector<FormulaLine> formula_of(const Construction& shown) {
    if (const auto cell = editor::hovered_cell(shown.context.state, shown.triangle)) return lines_of_cell(shown, *cell);
    const editor::Theme& theme = shown.context.theme;
    FormulaLine result = point_line(shown, {shown.degree(), 0});
    result.color = theme.parameter;
    return {result, {"Point at a cell to see how it is made.", theme.dim, true}};
}

/// As high without a formula as with one, so that nothing jumps.
void draw_formula_box(const Construction& shown) {
    const PanelContext& context = shown.context;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const int line_count = shown.curve.is_rational() ? rational_formula_lines : formula_lines;
    const ImVec2 size(content_width(context), context.px(line_count * line_pitch + 16.0));
    ImGui::Dummy(size);
    ImGui::GetWindowDrawList()->AddRectFilled(origin, ImVec2(origin.x + size.x, origin.y + size.y),
                                              imgui_packed(context.theme.field), context.px(8));
    std::string value;
    double y = 8.0 + 0.5 * line_pitch;
    for (const FormulaLine& line : formula_of(shown)) {
        const std::string text = editor::notated(line.text, context.state.view.notation);
        draw_text(context, ImVec2(origin.x + context.px(12), origin.y + context.px(y)),
                  {text, line.is_prose ? context.fonts.text : context.fonts.number, 0.0, line.color,
                   render::Anchor::left, size.x - context.px(24)});
        value.append(value.empty() ? "" : " | ").append(editor::plain_text(text));
        y += line_pitch;
    }
    report_item(context, "formula", value);
}

void draw_label(const PanelContext& context, const char* text) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    draw_text(context, ImVec2(origin.x, origin.y + context.px(12)), {text, context.fonts.text, 0.0, context.theme.dim});
    ImGui::SetCursorScreenPos(ImVec2(origin.x + context.px(label_width), origin.y));
}

std::string step_text(std::size_t r, std::size_t degree) {
    if (r == 0) return "P";
    return r == degree ? "C(u)" : core::sentence("level {level}", {{"level", r}});
}

/// Shows the levels up to r. All of them are asked for as such, so that they stay all when the degree grows.
editor::SetLevel level_command(std::size_t r, std::size_t degree) {
    return {.level = r == degree ? std::nullopt : std::optional(static_cast<int>(r))};
}

void draw_step(const Construction& shown, std::size_t r, float width_px) {
    const std::size_t degree = shown.degree();
    const bool has_words = width_px >= shown.context.px(54) || r == 0 || r == degree;
    Button button{fmt::format("step {}", r), has_words ? step_text(r, degree) : std::to_string(r), Icon::none,
                  width_px};
    button.is_active = shown.level() == r;
    button.tooltip = r == 0 ? "Only the control points of the span" : "The construction up to here";
    if (draw_button(shown.context, button)) shown.context.queue.run(level_command(r, degree));
}

void draw_all_steps(const Construction& shown, float width_px) {
    const PanelContext& context = shown.context;
    const float gap = context.px(8);
    const auto count = static_cast<float>(shown.degree() + 1);
    const float width = std::floor((width_px - (count - 1.0F) * gap) / count);
    for (std::size_t r = 0; r <= shown.degree(); ++r) {
        if (r > 0) stay_in_row(context, 8);
        draw_step(shown, r, width);
    }
}

void draw_step_by(const Construction& shown, const char* name, Icon icon, int by) {
    const int level = static_cast<int>(shown.level()) + by;
    Button button{name, "", icon, shown.context.px(28)};
    button.is_enabled = level >= 0 && level <= static_cast<int>(shown.degree());
    if (draw_button(shown.context, button))
        shown.context.queue.run(level_command(static_cast<std::size_t>(level), shown.degree()));
}

/// P, C(u), and the level between as a number with - and +.
void draw_few_steps(const Construction& shown, float width_px) {
    const PanelContext& context = shown.context;
    const float end_width = context.px(46);
    draw_step(shown, 0, end_width);
    stay_in_row(context, 8);
    draw_step_by(shown, "step back", Icon::minus, -1);
    stay_in_row(context, 0);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = width_px - 2.0F * (end_width + context.px(28 + 8));
    ImGui::Dummy(ImVec2(width, context.px(24)));
    const std::string text =
        core::sentence("level {level} of {last}", {{"level", shown.level()}, {"last", shown.degree()}});
    report_item(context, "level", text);
    draw_text(context, ImVec2(origin.x + 0.5F * width, origin.y + context.px(12)),
              {text, context.fonts.text, 0.0, context.theme.text, render::Anchor::center, width});
    stay_in_row(context, 0);
    draw_step_by(shown, "step next", Icon::plus, 1);
    stay_in_row(context, 8);
    draw_step(shown, shown.degree(), end_width);
}

void draw_step_row(const Construction& shown) {
    draw_label(shown.context, "Step");
    const float width = content_width(shown.context) - shown.context.px(label_width);
    if (shown.degree() + 1 <= most_buttons)
        draw_all_steps(shown, width);
    else
        draw_few_steps(shown, width);
}

void draw_parameter_field(const Construction& shown, float width_px) {
    const core::Interval domain = shown.curve.domain();
    NumberField field;
    field.name = "parameter";
    field.value = shown.triangle.u;
    field.decimals = editor::decimals_for(domain.length());
    field.speed = domain.length() / 500.0;
    field.width_px = width_px;
    field.lowest = domain.lower;
    field.highest = domain.upper;
    field.is_live = true;
    draw_number_field(shown.context, field, [](double u) { return editor::SetParameter{.u = u}; });
}

void draw_speed_field(const PanelContext& context, float width_px) {
    NumberField field;
    field.name = "speed";
    field.value = context.state.view.playback.speed;
    field.is_multiplicative = true;
    field.width_px = width_px;
    field.lowest = 0.01;
    field.highest = 100.0;
    field.is_live = true;
    field.unit = "×";
    field.tooltip = "Speed; 1 crosses the domain in five seconds";
    draw_number_field(context, field, [](double speed) { return editor::SetSpeed{.speed = speed}; });
}

void draw_parameter_row(const Construction& shown) {
    const PanelContext& context = shown.context;
    const editor::Playback& playback = context.state.view.playback;
    draw_label(context, "u");
    const float icon_width = context.px(34);
    const float speed_width = context.px(62);
    const float rest =
        content_width(context) - context.px(label_width) - 2.0F * icon_width - speed_width - 3.0F * context.px(8);
    draw_parameter_field(shown, rest);
    stay_in_row(context, 8);
    Button play{"play", "", playback.is_playing ? Icon::pause : Icon::play, icon_width};
    play.is_active = playback.is_playing;
    draw_command_button(context, play, editor::TogglePlay{});
    stay_in_row(context, 8);
    draw_speed_field(context, speed_width);
    stay_in_row(context, 8);
    Button turn{"ping-pong", "", playback.ping_pong ? Icon::ping_pong : Icon::jump_back, icon_width};
    draw_command_button(context, turn, editor::TogglePingPong{});
}

}  // namespace

void draw_construction_section(const PanelContext& context) {
    const core::Curve& curve = *context.state.active_curve();
    const Construction shown{context, curve, core::de_boor_triangle(curve, context.state.parameter())};
    if (draw_section_heading(context, {"construction", title_text(shown), span_text(shown)})) {
        add_space(context, 4);
        draw_triangle(context, curve, shown.triangle, shown.level(), content_width(context));
        add_space(context, 6);
        draw_formula_box(shown);
        add_space(context, 4);
        draw_step_row(shown);
        draw_parameter_row(shown);
    }
    add_space(context, 6);
}

}  // namespace batten::ui
