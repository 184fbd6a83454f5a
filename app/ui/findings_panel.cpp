#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/words/reading_text.h"
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
constexpr double detail_pitch = 14.0;
constexpr double number_width = 26.0;
constexpr double scroll_bar = 6.0;
constexpr double clear_height = 24.0;
constexpr double edge_gap = 6.0;  ///< above and below all
constexpr std::size_t least_finding_rows = 2;
constexpr std::size_t most_detail_lines = 3;
constexpr std::size_t telling_rows = 3;  ///< from which the number of lines of all rows is taken
constexpr std::string_view between_details = "   ";
constexpr std::size_t most_finding_rows = 7;
constexpr double most_findings_share = 0.5;  ///< of the inspector's height

std::string tooltip_of(const editor::Findings& findings, const editor::Finding& finding) {
    return core::sentence(finding.parameter ? "{numbers}\nClick to go there; Ctrl+C copies these numbers"
                                            : "{numbers}\nCtrl+C copies these numbers",
                          {{"numbers", editor::full_reading_text(editor::full_text(findings, finding))}});
}

/// What a row shows, besides its number.
struct FindingTexts {
    std::string label;
    std::string parameter;
    std::string details;
};

FindingTexts texts_of(const PanelContext& context, const editor::Finding& finding) {
    const editor::Findings& findings = *context.state.findings;
    FindingTexts texts{context.notated(editor::reading_text(finding.label)),
                       {},
                       context.notated(editor::details_text(findings, finding))};
    if (finding.parameter)
        texts.parameter = fmt::format("u {}", editor::column_text(*finding.parameter, findings.columns.parameter));
    return texts;
}

/// The details, broken between them; the last one of `most` lines takes what is left.
std::vector<std::string> detail_lines(const PanelContext& context, const std::string& details, float width,
                                      std::size_t most) {
    std::vector<std::string> lines{""};
    for (std::size_t begin = 0; begin < details.size();) {
        const std::size_t end = std::min(details.find(between_details, begin), details.size());
        const std::string part = details.substr(begin, end - begin);
        const std::string longer =
            lines.back().empty() ? part : fmt::format("{}{}{}", lines.back(), between_details, part);
        const bool is_full = !lines.back().empty() && text_width(longer, context.fonts.small) > width;
        if (is_full && lines.size() < most)
            lines.push_back(part);
        else
            lines.back() = longer;
        begin = end + between_details.size();
    }
    return lines;
}

/// Of each row in an inspector of this width, where it scrolls.
std::size_t detail_line_count(const PanelContext& context, double inspector_width_px) {
    const editor::Findings& findings = *context.state.findings;
    const float width =
        static_cast<float>(inspector_width_px) - context.px(2.0 * section_margin + number_width + scroll_bar);
    std::size_t count = 1;
    for (std::size_t i = 0; i < std::min(telling_rows, findings.rows.size()); ++i) {
        const std::string details = texts_of(context, findings.rows[i]).details;
        count = std::max(count, detail_lines(context, details, width, most_detail_lines).size());
    }
    return count;
}

/// In design pixels.
double row_height_of(std::size_t line_count) {
    return finding_row_height + detail_pitch * static_cast<double>(line_count - 1);
}

void draw_texts(const PanelContext& context, std::size_t i, const FindingTexts& texts, ImVec2 origin, float width,
                std::size_t line_count) {
    const float left = origin.x + context.px(finding_overhang);
    const float right = origin.x + width - context.px(finding_overhang);
    const float middle = left + context.px(number_width);
    const float y = origin.y + context.px(first_line);
    draw_text(context, {left, y}, {std::to_string(i + 1), context.fonts.number, 0.0, context.theme.accent});
    float room = right - middle;
    if (!texts.parameter.empty()) {
        const TextLine u{texts.parameter, context.fonts.number, 0.0, context.theme.text, render::Anchor::right};
        room -= draw_text(context, {right, y}, u) + context.px(row_gap);
    }
    ImFont* text = context.fonts.text;
    ImFont* small = context.fonts.small;
    draw_text(context, {middle, y}, {elided(texts.label, text, room), text, 0.0, context.theme.text});
    float below = origin.y + context.px(second_line);
    for (const std::string& line : detail_lines(context, texts.details, right - middle, line_count)) {
        draw_text(context, {middle, below}, {elided(line, small, right - middle), small, 0.0, context.theme.dim});
        below += context.px(detail_pitch);
    }
}

void draw_finding_row(const PanelContext& context, std::size_t i, float width, std::size_t line_count) {
    const float height = context.px(row_height_of(line_count));
    const editor::Finding& finding = context.state.findings->rows[i];
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(i));
    const bool is_clicked = ImGui::InvisibleButton("finding", ImVec2(width, height));
    ImGui::PopID();
    const FindingTexts texts = texts_of(context, finding);
    report_item(context, fmt::format("finding {}", i),
                fmt::format("{} | {} | {}", texts.label, texts.parameter, texts.details));
    if (ImGui::IsItemHovered()) {
        const ImVec2 end(origin.x + width, origin.y + height);
        const render::Color color = render::blended(context.theme.accent, 0.08, context.theme.panel);
        ImGui::GetWindowDrawList()->AddRectFilled(origin, end, imgui_packed(color), context.px(5));
    }
    const std::string full = context.notated(editor::full_text(*context.state.findings, finding));
    show_tooltip(context, tooltip_of(*context.state.findings, finding));
    offer_copy(context, full);
    if (ImGui::IsItemHovered() && asks_for_menu()) open_context_menu(context, editor::OnFinding{i, full});
    draw_texts(context, i, texts, origin, width, line_count);
    if (is_clicked && finding.parameter) context.queue.run(editor::SetParameter{.u = *finding.parameter});
}

/// The height in window pixels of all but the rows.
float frame_height(const PanelContext& context) {
    return context.px(heading_height + clear_height + 2.0 * (row_gap + edge_gap));
}

/// As many as find room in an inspector of this height; the others scroll.
std::size_t rows_shown(const PanelContext& context, double inspector_height_px, double row_height) {
    const double room = most_findings_share * inspector_height_px - frame_height(context);
    const auto fitting = static_cast<std::size_t>(std::max(0.0, room / context.px(row_height)));
    const std::size_t least = row_height > finding_row_height ? 1 : least_finding_rows;
    return std::min(std::clamp(fitting, least, most_finding_rows), context.state.findings->rows.size());
}

void draw_finding_rows(const PanelContext& context, double height_px, std::size_t line_count) {
    const editor::Findings& findings = *context.state.findings;
    const double row_height = row_height_of(line_count);
    const auto shown = static_cast<std::size_t>(height_px / context.px(row_height));
    const RowList list{"findings", findings.rows.size(), shown, row_height, finding_overhang};
    const auto draw_row = [line_count](const PanelContext& drawn, std::size_t i, float width) {
        draw_finding_row(drawn, i, width, line_count);
    };
    if (list.count > 0) return draw_row_list(context, list, draw_row);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + content_width(context));
    ImGui::TextUnformatted(context.notated(editor::reading_text(findings.summary)).c_str());
    ImGui::PopTextWrapPos();
    const ImVec2 corner(ImGui::GetWindowPos().x - context.px(6), ImGui::GetItemRectMin().y);
    offer_full_message(context, findings.summary, {corner.x, corner.y}, {1.0, 0.0});
}

}  // namespace

double findings_height(const PanelContext& context, const Rectangle& place) {
    if (!context.state.findings) return 0.0;
    const editor::Findings& findings = *context.state.findings;
    const double row_height = row_height_of(detail_line_count(context, place.size_px.x));
    const std::size_t rows = rows_shown(context, place.size_px.y, row_height);
    const float width = static_cast<float>(place.size_px.x) - 2.0F * context.px(section_margin);
    const float content = rows > 0
                              ? static_cast<float>(rows) * context.px(row_height)
                              : ImGui::CalcTextSize(context.notated(editor::reading_text(findings.summary)).c_str(),
                                                    nullptr, false, width)
                                    .y;
    return std::ceil(frame_height(context) + content);
}

void draw_findings_panel(const PanelContext& context, const Rectangle& place) {
    if (place.size_px.y <= 0.0) return;
    const editor::Findings& findings = *context.state.findings;
    const std::size_t count = findings.rows.size();
    begin_panel("findings panel", place);
    ImGui::Indent(context.px(section_margin - window_padding));
    add_space(context, edge_gap);
    draw_heading(context, {"findings", findings.title, count == 0 ? "none" : std::to_string(count)});
    draw_finding_rows(context, place.size_px.y - frame_height(context), detail_line_count(context, place.size_px.x));
    Button clear{"clear findings", "clear", Icon::none, content_width(context), clear_height};
    clear.tooltip = "Forgets these results and their marks on the canvas (Escape)";
    if (draw_button(context, clear)) context.queue.run(editor::ClearFindings{});
    const glm::dvec2 corner = place.origin_px + 0.5;
    draw_edge(context, corner, corner + glm::dvec2(0.0, place.size_px.y));
    draw_edge(context, corner, corner + glm::dvec2(place.size_px.x, 0.0));
    end_panel();
}

}  // namespace batten::ui
