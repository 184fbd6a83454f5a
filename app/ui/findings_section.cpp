#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/reading_text.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/section.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {
namespace {

constexpr double finding_row_height = 40.0;
constexpr double finding_overhang = 6.0;
constexpr double first_line = 12.0;  ///< design pixels from the top of a row to the middle of its lines
constexpr double second_line = 28.0;
constexpr double number_width = 26.0;
constexpr std::size_t most_finding_rows = 7;

std::string tooltip_of(const editor::Findings& findings, const editor::Finding& finding) {
    return core::sentence(finding.parameter ? "{numbers}\nClick to go there; Ctrl+C copies these numbers"
                                            : "{numbers}\nCtrl+C copies these numbers",
                          {{"numbers", editor::full_reading_text(editor::full_text(findings, finding))}});
}

void draw_texts(const PanelContext& context, std::size_t i, ImVec2 origin, float width) {
    const editor::Findings& findings = *context.state.findings;
    const editor::Finding& finding = findings.rows[i];
    const float left = origin.x + context.px(finding_overhang);
    const float right = origin.x + width - context.px(finding_overhang);
    const float middle = left + context.px(number_width);
    const float y = origin.y + context.px(first_line);
    draw_text(context, {left, y}, {std::to_string(i + 1), context.fonts.number, 0.0, context.theme.accent});
    float room = right - middle;
    if (finding.parameter) {
        const TextLine u{fmt::format("u {}", editor::column_text(*finding.parameter, findings.columns.parameter)),
                         context.fonts.number, 0.0, context.theme.text, render::Anchor::right};
        room -= draw_text(context, {right, y}, u) + context.px(row_gap);
    }
    ImFont* text = context.fonts.text;
    ImFont* small = context.fonts.small;
    draw_text(context, {middle, y},
              {elided(editor::reading_text(finding.label), text, room), text, 0.0, context.theme.text});
    draw_text(context, {middle, origin.y + context.px(second_line)},
              {elided(editor::details_text(findings, finding), small, right - middle), small, 0.0, context.theme.dim});
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
    const std::string full = editor::full_text(*context.state.findings, finding);
    show_tooltip(context, tooltip_of(*context.state.findings, finding));
    offer_copy(context, full);
    if (ImGui::IsItemHovered() && asks_for_menu()) open_context_menu(context, editor::OnFinding{i, full});
    draw_texts(context, i, origin, width);
    if (is_clicked && finding.parameter) context.queue.run(editor::SetParameter{.u = *finding.parameter});
}

}  // namespace

void draw_findings_section(const PanelContext& context) {
    const editor::Findings& findings = *context.state.findings;
    const std::size_t count = findings.rows.size();
    if (draw_section_heading(context, {"findings", findings.title, count == 0 ? "none" : std::to_string(count)})) {
        if (count == 0) ImGui::TextWrapped("%s", editor::reading_text(findings.summary).c_str());
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
