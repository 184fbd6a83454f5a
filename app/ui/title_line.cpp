#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/view_commands.h"
#include "app/ui/context_popup.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double title_side_margin = 16.0;
constexpr double title_edge_margin = 8.0;
constexpr double text_gap = 14.0;
constexpr double title_cross = 22.0;
constexpr double least_sentence_width = 260.0;  // beside the title
constexpr double title_most_share = 0.4;        // of the canvas

/// Where the texts go, from the upper left corner of the line.
struct TitleLayout {
    ImVec2 sentence_corner{};
    float title_wrap = 0.0F;
    float sentence_wrap = 0.0F;
    float height = 0.0F;
};

/// Of an example: what someone has written into a file is shown as it stands there.
std::string shown_of(const PanelContext& context, const std::string& text) {
    return context.state.path.empty() ? context.notated(text) : text;
}

bool has_title_line(const editor::EditorState& state) {
    const core::Document& document = state.shown();
    return state.view.title_is_open && (!document.title.empty() || !document.description.empty());
}

glm::vec2 wrapped_size(ImFont* font, const std::string& text, float wrap) {
    return text.empty() ? glm::vec2(0.0F) : lines_size(wrapped(text, font, wrap), font);
}

/// The sentence stands beside the title where there is room for it, else below.
TitleLayout lay_out_title(const PanelContext& context, float width) {
    const core::Document& document = context.state.shown();
    const float left = context.px(title_side_margin);
    const float top = context.px(title_edge_margin);
    TitleLayout layout;
    layout.title_wrap = std::max(width - 2.0F * left - context.px(title_cross + text_gap), 1.0F);
    const glm::vec2 title = wrapped_size(context.fonts.bold, shown_of(context, document.title), layout.title_wrap);
    const float beside = title.x > 0.0F ? title.x + context.px(text_gap) : 0.0F;
    const bool is_below = layout.title_wrap - beside < context.px(least_sentence_width);
    layout.sentence_wrap = is_below ? layout.title_wrap : layout.title_wrap - beside;
    layout.sentence_corner = is_below ? ImVec2(left, top + title.y) : ImVec2(left + beside, top);
    const glm::vec2 sentence =
        wrapped_size(context.fonts.text, shown_of(context, document.description), layout.sentence_wrap);
    layout.height = std::max(top + title.y, layout.sentence_corner.y + sentence.y) + top;
    return layout;
}

void draw_wrapped(const PanelContext& context, const char* name, const std::string& text, ImFont* font, ImVec2 corner,
                  float wrap) {
    if (text.empty()) return;
    ImGui::GetWindowDrawList()->AddText(font, font_height(font), corner, imgui_packed(context.theme.text),
                                        wrapped(text, font, wrap).c_str());
    const glm::vec2 size = wrapped_size(font, text, wrap);
    context.widgets.push_back({name, {{corner.x, corner.y}, {size.x, size.y}}, text});
}

void draw_title_texts(const PanelContext& context, const TitleLayout& layout, ImVec2 origin) {
    const core::Document& document = context.state.shown();
    draw_wrapped(context, "title", shown_of(context, document.title), context.fonts.bold,
                 {origin.x + context.px(title_side_margin), origin.y + context.px(title_edge_margin)},
                 layout.title_wrap);
    draw_wrapped(context, "title sentence", shown_of(context, document.description), context.fonts.text,
                 {origin.x + layout.sentence_corner.x, origin.y + layout.sentence_corner.y}, layout.sentence_wrap);
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
    const double height = lay_out_title(context, static_cast<float>(canvas.size_px.x)).height;
    return std::min(height, std::floor(title_most_share * canvas.size_px.y));
}

void draw_title_line(const PanelContext& context, const Rectangle& place) {
    if (place.size_px.y <= 0.0) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    begin_panel("title line", place, ImGuiWindowFlags_NoScrollWithMouse);
    const TitleLayout layout = lay_out_title(context, static_cast<float>(place.size_px.x));
    const glm::vec2 origin(place.origin_px);
    draw_title_texts(context, layout, {origin.x, origin.y});
    const bool is_cut = layout.height > static_cast<float>(place.size_px.y) + 1.0F;
    const core::Document& document = context.state.shown();
    if (is_cut && ImGui::IsWindowHovered())
        draw_tooltip_at(context, shown_of(context, document.description),
                        place.origin_px + glm::dvec2(0.0, place.size_px.y), {0.0, 0.0});
    draw_dismiss_button(context, place);
    if (ImGui::IsWindowHovered() && asks_for_menu()) open_context_menu(context, editor::OnTitleLine{});
    const double bottom = place.origin_px.y + place.size_px.y - 0.5;
    draw_edge(context, {place.origin_px.x, bottom}, {place.origin_px.x + place.size_px.x, bottom});
    end_panel();
    ImGui::PopStyleVar();
}

}  // namespace batten::ui
