#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/formula.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/section.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

constexpr double finding_row_height = 40.0;
constexpr double finding_overhang = 6.0;
constexpr double first_line = 12.0;  ///< design pixels from the top of a row to the middle of its lines
constexpr double second_line = 28.0;
constexpr double number_width = 26.0;
constexpr std::size_t most_finding_rows = 7;
constexpr int digits = 5;

/// "C⁰ by its knots   (1, 2)   curvature 0.25"
std::string details_of(const editor::Finding& finding) {
    std::vector<std::string> parts;
    if (!finding.note.empty()) parts.push_back(finding.note);
    if (finding.point) parts.push_back(editor::position_text(*finding.point, digits));
    for (const editor::FoundNumber& number : finding.numbers)
        parts.push_back(fmt::format("{} {}", number.name, editor::number_text(number.value, digits)));
    return fmt::format("{}", fmt::join(parts, "   "));
}

/// All that is known of it, a line for each fact.
std::string facts_of(const editor::Finding& finding) {
    std::vector<std::string> lines{finding.label};
    const auto add = [&lines](const std::string& name, double value) {
        lines.push_back(fmt::format("{} = {}", name, editor::number_text(value, 17)));
    };
    if (finding.parameter) add("u", *finding.parameter);
    if (finding.point) add("x", finding.point->x);
    if (finding.point) add("y", finding.point->y);
    for (const editor::FoundNumber& number : finding.numbers) add(number.name, number.value);
    if (!finding.note.empty()) lines.push_back(finding.note);
    return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string tooltip_of(const editor::Finding& finding) {
    const std::string facts = facts_of(finding);
    return finding.parameter ? fmt::format("{}\nClick to go there", facts) : facts;
}

void draw_texts(const PanelContext& context, const editor::Finding& finding, std::size_t i, ImVec2 origin,
                float width) {
    const float left = origin.x + context.px(finding_overhang);
    const float right = origin.x + width - context.px(finding_overhang);
    const float middle = left + context.px(number_width);
    const float y = origin.y + context.px(first_line);
    draw_text(context, {left, y}, {std::to_string(i + 1), context.fonts.number, 0.0, context.theme.accent});
    float room = right - middle;
    if (finding.parameter) {
        const TextLine u{fmt::format("u {}", editor::number_text(*finding.parameter, digits)), context.fonts.number,
                         0.0, context.theme.text, render::Anchor::right};
        room -= draw_text(context, {right, y}, u) + context.px(row_gap);
    }
    ImFont* text = context.fonts.text;
    ImFont* small = context.fonts.small;
    draw_text(context, {middle, y}, {elided(finding.label, text, room), text, 0.0, context.theme.text});
    draw_text(context, {middle, origin.y + context.px(second_line)},
              {elided(details_of(finding), small, right - middle), small, 0.0, context.theme.dim});
}

void draw_finding_row(const PanelContext& context, std::size_t i, float width) {
    const editor::Finding& finding = context.state.findings->rows[i];
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(i));
    const bool is_clicked = ImGui::InvisibleButton("finding", ImVec2(width, context.px(finding_row_height)));
    ImGui::PopID();
    report_item(context, fmt::format("finding {}", i), finding.label);
    if (ImGui::IsItemHovered()) {
        const ImVec2 end(origin.x + width, origin.y + context.px(finding_row_height));
        const render::Color color = render::blended(context.theme.accent, 0.08, context.theme.panel);
        ImGui::GetWindowDrawList()->AddRectFilled(origin, end, imgui_packed(color), context.px(5));
    }
    show_tooltip(context, tooltip_of(finding));
    if (ImGui::IsItemHovered() && asks_for_menu()) open_context_menu(context, editor::OnFinding{i, facts_of(finding)});
    draw_texts(context, finding, i, origin, width);
    if (is_clicked && finding.parameter) context.queue.run(editor::SetParameter{.u = *finding.parameter});
}

}  // namespace

void draw_findings_section(const PanelContext& context) {
    const editor::Findings& findings = *context.state.findings;
    const std::size_t count = findings.rows.size();
    if (draw_section_heading(context, {"findings", findings.title, count == 0 ? "none" : std::to_string(count)})) {
        if (count == 0) ImGui::TextWrapped("%s", findings.summary.c_str());
        if (count > 0)
            draw_row_list(context, {"findings", count, most_finding_rows, finding_row_height, finding_overhang},
                          draw_finding_row);
        Button clear{"clear findings", "clear", Icon::none, content_width(context)};
        clear.tooltip = "Forgets these results and their marks on the canvas (Escape)";
        if (draw_button(context, clear)) context.queue.run(editor::ClearFindings{});
    }
    add_space(context, 6);
}

}  // namespace batten::ui
