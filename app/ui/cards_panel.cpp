#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "app/editor/cards/cards.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/ui/card_view.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/shell_widgets.h"

namespace batten::ui {

namespace {

constexpr double cross_size = 20.0;
constexpr double card_gap = 14.0;
constexpr double top_margin = 10.0;
constexpr double floating_margin = 14.0;

bool is_open(const PanelContext& context, const std::string& name) {
    const auto& cards = context.panels.cards.open_cards;
    const auto found = cards.find(name);
    return found == cards.end() || found->second;
}

/// The heading folds the card; its cross hides the view. Returns whether the card is open.
bool draw_card_heading(const PanelContext& context, const editor::CardSource& source, const std::string& name,
                       float width_px) {
    const float cross = context.px(cross_size);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    bool open = is_open(context, name);
    if (ImGui::InvisibleButton(name.c_str(), ImVec2(width_px - cross, context.px(heading_height))))
        context.panels.cards.open_cards[name] = open = !open;
    const std::string title =
        editor::notated(editor::toggle_overlay_spec(source.overlay).title, context.state.view.notation);
    report_item(context, name, title);
    const float middle = origin.y + 0.5F * context.px(heading_height);
    draw_text(context, ImVec2(origin.x, middle), {title, context.fonts.bold, 0.0, context.theme.text});
    ImGui::SetCursorScreenPos(ImVec2(origin.x + width_px - cross, middle - 0.5F * cross));
    if (draw_cross_button(context, fmt::format("{} dismiss", name), cross))
        context.queue.run(editor::Command(editor::toggle_overlay_spec(source.overlay),
                                          editor::toggle_overlay_spec(source.overlay).run.make()));
    ImGui::SetCursorScreenPos(ImVec2(origin.x, origin.y + context.px(heading_height)));
    draw_edge(context, {origin.x, origin.y + context.px(heading_height) - 0.5},
              {origin.x + width_px, origin.y + context.px(heading_height) - 0.5});
    return open;
}

void draw_one_card(const PanelContext& context, const editor::CardSource& source, float width_px) {
    const std::string name = fmt::format("card {}", core::name_of(source.overlay));
    if (draw_card_heading(context, source, name, width_px))
        draw_card_blocks(context, source.make(context.state), name, width_px);
    add_space(context, card_gap);
}

/// Other cards than before begin at their top.
void follow_cards(const PanelContext& context, const std::vector<editor::CardSource>& shown) {
    std::vector<editor::Overlay> overlays;
    for (const editor::CardSource& source : shown) overlays.push_back(source.overlay);
    if (overlays != context.panels.cards.shown) ImGui::SetScrollY(0.0F);
    context.panels.cards.shown = std::move(overlays);
}

void draw_cards(const PanelContext& context, const std::vector<editor::CardSource>& shown) {
    follow_cards(context, shown);
    ImGui::Indent(context.px(section_margin - window_padding));
    add_space(context, top_margin);
    for (const editor::CardSource& source : shown) draw_one_card(context, source, content_width(context));
    const bool is_inside = ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    note_panel_hover(context, is_inside);
    if (is_inside && asks_for_menu()) open_context_menu(context, editor::OnPanel{});
}

void push_metrics(const PanelContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(window_padding), 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, context.px(8));
}

}  // namespace

void draw_cards_panel(const PanelContext& context, const Rectangle& place) {
    if (place.size_px.x <= 0.0) return;
    push_metrics(context);
    ImGui::SetNextWindowPos(ImVec2(static_cast<float>(place.origin_px.x), static_cast<float>(place.origin_px.y)));
    ImGui::SetNextWindowSize(ImVec2(static_cast<float>(place.size_px.x), static_cast<float>(place.size_px.y)));
    ImGui::Begin("cards", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_cards(context, editor::shown_cards(context.state));
    draw_edge(context, place.origin_px + glm::dvec2(0.5, 0.0), place.origin_px + glm::dvec2(0.5, place.size_px.y));
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void draw_floating_cards(const PanelContext& context, const Rectangle& canvas) {
    const std::vector<editor::CardSource> shown = editor::shown_cards(context.state);
    if (shown.empty()) return;
    push_metrics(context);
    const float margin = context.px(floating_margin);
    const glm::vec2 corner(canvas.origin_px);
    const glm::vec2 size(canvas.size_px);
    const float width = std::min(context.px(context.state.view.cards_width), 0.5F * size.x);
    // Where the screen is another one, they begin anew at its edge.
    const bool is_new = context.panels.cards.canvas_px != canvas.size_px;
    context.panels.cards.canvas_px = canvas.size_px;
    const ImGuiCond when = is_new ? ImGuiCond_Always : ImGuiCond_Once;
    ImGui::SetNextWindowPos(ImVec2(corner.x + size.x - width - margin, corner.y + margin), when);
    ImGui::SetNextWindowSize(ImVec2(width, std::max(size.y - 2.0F * margin, margin)), when);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0F, context.px(1)));
    ImGui::Begin("floating cards", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    draw_cards(context, shown);
    const ImVec2 position = ImGui::GetWindowPos();
    context.widgets.push_back(
        {"floating cards", {{position.x, position.y}, {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()}}, {}});
    ImGui::End();
    ImGui::PopStyleVar(4);
}

}  // namespace batten::ui
