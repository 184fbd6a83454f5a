#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/view_commands.h"
#include "app/ui/context_popup.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "app/ui/text_lines.h"

namespace batten::ui {

namespace {

constexpr double title_side_margin = 16.0;
constexpr double title_edge_margin = 8.0;
constexpr double text_gap = 14.0;
constexpr double title_cross = 22.0;
constexpr double least_sentence_width = 260.0;  // beside the title
constexpr double title_most_share = 0.4;        // of the canvas

/// What the line says, and where, from its upper left corner.
struct TitleLayout {
    std::string title;     ///< in lines
    std::string sentence;  ///< in lines, as many as there is room for
    ImVec2 sentence_corner{};
    float height = 0.0F;
    bool is_whole = true;  ///< nothing of the sentence is left out
};

/// Of an example: what someone has written into a file is shown as it stands there.
std::string shown_of(const PanelContext& context, const std::string& text) {
    return context.state.path.empty() ? context.notated(text) : text;
}

bool has_title_line(const editor::EditorState& state) {
    const core::Document& document = state.shown();
    return state.view.title_is_open && (!document.title.empty() || !document.description.empty());
}

/// What the line may take of a canvas of this height.
float most_title_height(double canvas_height_px) {
    return static_cast<float>(std::floor(title_most_share * canvas_height_px));
}

/// The sentence stands beside the title where there is room for it, else below. It is ended early where the line would
/// be higher than `most_height`, but not before its first line.
TitleLayout lay_out_title(const PanelContext& context, float width, float most_height) {
    const core::Document& document = context.state.shown();
    const float left = context.px(title_side_margin);
    const float top = context.px(title_edge_margin);
    const float room = std::max(width - 2.0F * left - context.px(title_cross + text_gap), 1.0F);
    TitleLayout layout;
    layout.title = wrapped(shown_of(context, document.title), context.fonts.bold, room);
    const glm::vec2 title = layout.title.empty() ? glm::vec2(0.0F) : lines_size(layout.title, context.fonts.bold);
    const float beside = title.x > 0.0F ? title.x + context.px(text_gap) : 0.0F;
    const bool is_below = room - beside < context.px(least_sentence_width);
    layout.sentence_corner = is_below ? ImVec2(left, top + title.y) : ImVec2(left + beside, top);
    const float line = font_height(context.fonts.text);
    const float most_lines = std::max((most_height - top - layout.sentence_corner.y + 0.5F) / line, 1.0F);
    const TextLines sentence = broken_into_lines(shown_of(context, document.description), context.fonts.text,
                                                 is_below ? room : room - beside, static_cast<std::size_t>(most_lines));
    layout.sentence = fmt::format("{}", fmt::join(sentence.lines, "\n"));
    layout.is_whole = sentence.is_whole;
    const float bottom = layout.sentence_corner.y + line * static_cast<float>(sentence.lines.size());
    layout.height = std::max(top + title.y, bottom) + top;
    return layout;
}

void draw_lines(const PanelContext& context, const char* name, const std::string& text, const std::string& lines,
                ImFont* font, ImVec2 corner) {
    if (lines.empty()) return;
    ImGui::GetWindowDrawList()->AddText(font, font_height(font), corner, imgui_packed(context.theme.text),
                                        lines.c_str());
    const glm::vec2 size = lines_size(lines, font);
    context.widgets.push_back({name, {{corner.x, corner.y}, {size.x, size.y}}, text});
}

void draw_title_texts(const PanelContext& context, const TitleLayout& layout, ImVec2 origin) {
    const core::Document& document = context.state.shown();
    draw_lines(context, "title", shown_of(context, document.title), layout.title, context.fonts.bold,
               {origin.x + context.px(title_side_margin), origin.y + context.px(title_edge_margin)});
    draw_lines(context, "title sentence", shown_of(context, document.description), layout.sentence, context.fonts.text,
               {origin.x + layout.sentence_corner.x, origin.y + layout.sentence_corner.y});
}

void draw_dismiss_button(const PanelContext& context, const Rectangle& place) {
    const float size = context.px(title_cross);
    const float right = static_cast<float>(place.origin_px.x + place.size_px.x) - context.px(0.5 * title_side_margin);
    const float top = static_cast<float>(place.origin_px.y) + context.px(title_edge_margin) +
                      0.5F * (font_height(context.fonts.text) - size);
    ImGui::SetCursorScreenPos({right - size, std::floor(top)});
    if (draw_cross_button(context, "title dismiss", size)) context.queue.run(editor::ToggleTitle{});
}

}  // namespace

double title_line_height(const PanelContext& context, const Rectangle& canvas) {
    if (!has_title_line(context.state)) return 0.0;
    const float most = most_title_height(canvas.size_px.y);
    return lay_out_title(context, static_cast<float>(canvas.size_px.x), most).height;
}

void draw_title_line(const PanelContext& context, const Rectangle& place) {
    if (place.size_px.y <= 0.0) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    begin_panel("title line", place, ImGuiWindowFlags_NoScrollWithMouse);
    const glm::vec2 size(place.size_px);
    const TitleLayout layout = lay_out_title(context, size.x, size.y);
    const glm::vec2 origin(place.origin_px);
    draw_title_texts(context, layout, {origin.x, origin.y});
    if (!layout.is_whole && ImGui::IsWindowHovered())
        draw_tooltip_at(context, shown_of(context, context.state.shown().description),
                        place.origin_px + glm::dvec2(0.0, place.size_px.y), {0.0, 0.0});
    draw_dismiss_button(context, place);
    if (ImGui::IsWindowHovered() && asks_for_menu()) open_context_menu(context, editor::OnTitleLine{});
    const double bottom = place.origin_px.y + place.size_px.y - 0.5;
    draw_edge(context, {place.origin_px.x, bottom}, {place.origin_px.x + place.size_px.x, bottom});
    end_panel();
    ImGui::PopStyleVar();
}

}  // namespace batten::ui
