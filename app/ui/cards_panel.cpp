#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "app/editor/cards/cards.h"
#include "app/editor/cards/floating_cards.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/ui/card_view.h"
#include "app/ui/context_popup.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double card_cross_size = 20.0;
constexpr double gap_below_card = 14.0;
constexpr double first_card_margin = 10.0;
constexpr double least_floating_width = 200.0;
constexpr double least_floating_height = 100.0;

std::string card_name(editor::Overlay overlay) {
    return fmt::format("card {}", core::name_of(overlay));
}

bool is_card_open(const PanelContext& context, const std::string& name) {
    const auto& cards = context.panels.cards.open_cards;
    const auto found = cards.find(name);
    return found == cards.end() || found->second;
}

/// The heading folds the card; its cross hides the view. Returns whether the card is open.
bool draw_card_heading(const PanelContext& context, const editor::CardSource& source, const std::string& name,
                       float width_px) {
    const float cross = context.px(card_cross_size);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    bool open = is_card_open(context, name);
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

void draw_whole_card(const PanelContext& context, const editor::CardSource& source, float width_px) {
    const std::string name = card_name(source.overlay);
    if (draw_card_heading(context, source, name, width_px))
        draw_card_blocks(context, source.make(context.state), name, width_px);
    add_space(context, gap_below_card);
}

/// A card that is out of sight keeps its place, but is not made.
void draw_one_card(const PanelContext& context, const editor::CardSource& source, float width_px) {
    CardsState& cards = context.panels.cards;
    if (cards.wanted == source.overlay)
        ImGui::SetScrollFromPosY(ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y, 0.0F);
    const auto height = cards.heights_px.find(source.overlay);
    if (height != cards.heights_px.end() && !ImGui::IsRectVisible(ImVec2(width_px, height->second))) {
        ImGui::Dummy(ImVec2(width_px, height->second - ImGui::GetStyle().ItemSpacing.y));
        return;
    }
    const float top = ImGui::GetCursorPosY();
    draw_whole_card(context, source, width_px);
    cards.heights_px[source.overlay] = ImGui::GetCursorPosY() - top;
}

/// A card that was just turned on is unfolded and brought into view; one that a projector adds is neither.
void follow_cards(const PanelContext& context, const std::vector<editor::CardSource>& shown) {
    CardsState& cards = context.panels.cards;
    std::vector<editor::Overlay> overlays;
    for (const editor::CardSource& source : shown) overlays.push_back(source.overlay);
    cards.wanted.reset();
    for (const editor::Overlay overlay : overlays)
        if (context.state.view.overlays.is_shown(overlay) &&
            std::ranges::find(cards.shown, overlay) == cards.shown.end()) {
            if (!cards.wanted) cards.wanted = overlay;
            cards.open_cards.erase(card_name(overlay));
        }
    cards.shown = std::move(overlays);
}

void draw_cards(const PanelContext& context, const std::vector<editor::CardSource>& shown) {
    follow_cards(context, shown);
    ImGui::Indent(context.px(section_margin - window_padding));
    add_space(context, first_card_margin);
    const float width = content_width(context);
    if (std::exchange(context.panels.cards.width_px, width) != width) context.panels.cards.heights_px.clear();
    for (const editor::CardSource& source : shown) draw_one_card(context, source, width);
    const bool is_inside = ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    note_panel_hover(context, is_inside);
    if (is_inside && asks_for_menu()) open_context_menu(context, editor::OnPanel{});
}

void push_card_metrics(const PanelContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(window_padding), 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, context.px(8));
}

/// Moved, and where that is not enough shrunk, so that all of it is on the canvas; at whole pixels, as windows are.
Rectangle kept_on(const Rectangle& canvas, Rectangle place) {
    place.size_px = glm::floor(glm::clamp(place.size_px, glm::dvec2(1.0), glm::max(canvas.size_px, glm::dvec2(1.0))));
    const glm::dvec2 last = canvas.origin_px + canvas.size_px - place.size_px;
    place.origin_px = glm::floor(glm::max(glm::min(place.origin_px, last), canvas.origin_px));
    return place;
}

Rectangle window_place() {
    const ImVec2 origin = ImGui::GetWindowPos();
    return {{origin.x, origin.y}, {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()}};
}

}  // namespace

void draw_cards_panel(const PanelContext& context, const Rectangle& place) {
    if (place.size_px.x <= 0.0) return;
    push_card_metrics(context);
    ImGui::SetNextWindowPos(imgui_pair(place.origin_px));
    ImGui::SetNextWindowSize(imgui_pair(place.size_px));
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
    const auto box = editor::floating_cards_box(context.state);
    if (!box) return;
    push_card_metrics(context);
    CardsState& cards = context.panels.cards;
    const Rectangle usual{canvas.origin_px + box->lower_px, box->upper_px - box->lower_px};
    const Rectangle place = kept_on(canvas, cards.placed.value_or(usual));
    // While the button is down the window may be moved and resized; released, it comes back to the canvas.
    const bool is_held = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const ImGuiCond when = is_held ? ImGuiCond_Once : ImGuiCond_Always;
    ImGui::SetNextWindowPos(imgui_pair(place.origin_px), when);
    ImGui::SetNextWindowSize(imgui_pair(place.size_px), when);
    const glm::dvec2 least = context.scale * glm::dvec2(least_floating_width, least_floating_height);
    ImGui::SetNextWindowSizeConstraints(imgui_pair(glm::min(least, canvas.size_px)), imgui_pair(canvas.size_px));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0F, context.px(1)));
    ImGui::Begin("floating cards", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    draw_cards(context, editor::shown_cards(context.state));
    const Rectangle now = window_place();
    if (is_held && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
        (now.origin_px != place.origin_px || now.size_px != place.size_px))
        cards.placed = now;
    context.widgets.push_back({"floating cards", now, {}});
    ImGui::End();
    ImGui::PopStyleVar(4);
}

}  // namespace batten::ui
