#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/lesson_commands.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/example_list.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/lesson_list.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

constexpr double side_width = 232.0;
constexpr double most_dialog_width = 2400.0;  // as much as the window has, else
constexpr double most_dialog_height = 1500.0;
constexpr float lessons_share = 0.65F;  // of the side, beside recent files
constexpr double card_gap = 12.0;
constexpr double card_margin = 10.0;
constexpr double least_card_width = 196.0;
constexpr double least_thumbnail = 80.0;
constexpr double usual_thumbnail = 104.0;
constexpr float thumbnail_aspect = 1.9F;

/// A line of a list of the side.
struct SideEntry {
    std::string name;     ///< for tests
    std::string text;     ///< shown as far as there is room
    std::string tooltip;  ///< the whole of it
};

/// Whether it was clicked.
bool draw_side_entry(const PanelContext& context, const SideEntry& entry) {
    ImGui::PushID(entry.name.c_str());
    const bool is_clicked =
        ImGui::Selectable(elided(entry.text, context.fonts.text, context.px(side_width - 24.0)).c_str());
    ImGui::PopID();
    report_item(context, entry.name, entry.tooltip);
    show_typed_tooltip(context, entry.tooltip);
    return is_clicked;
}

void begin_side_list(const PanelContext& context, const char* title, float height) {
    ImGui::Dummy(ImVec2(1.0F, context.px(10)));
    ImGui::TextDisabled("%s", title);
    ImGui::BeginChild(title, ImVec2(0.0F, height), false, ImGuiWindowFlags_NoNav);
}

void draw_recent(const PanelContext& context) {
    if (context.state.recent_files.empty()) return;
    begin_side_list(context, "Recent files", 0.0F);
    for (std::size_t i = 0; i < context.state.recent_files.size(); ++i) {
        const std::filesystem::path& file = context.state.recent_files[i];
        if (draw_side_entry(context, {fmt::format("recent {}", i), file.filename().string(), file.string()}))
            context.queue.run(editor::Open{.path = file});
    }
    ImGui::EndChild();
}

/// The lessons in the order of a lecture; recent files below get a part of the room.
void draw_offered_lessons(const PanelContext& context) {
    if (lessons_of(context).empty()) return;
    const float share = context.state.recent_files.empty() ? 1.0F : lessons_share;
    begin_side_list(context, "Lessons", std::floor(share * (ImGui::GetContentRegionAvail().y - context.px(40))));
    for (const LessonEntry& lesson : lessons_of(context))
        if (draw_side_entry(context, {fmt::format("welcome lesson {}", lesson.name), lesson.title, lesson.title}))
            context.queue.run(editor::OpenLesson{lesson.name});
    ImGui::EndChild();
}

void draw_side(const PanelContext& context) {
    ImGui::BeginChild("side", ImVec2(context.px(side_width), 0.0F), false, ImGuiWindowFlags_NoNav);
    ImGui::PushFont(context.fonts.large);
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.accent));
    ImGui::TextUnformatted("batten");
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    ImGui::TextWrapped("B-spline and NURBS curves: draw them, and see what knots do.");
    ImGui::PopStyleColor();
    ImGui::Dummy(ImVec2(1.0F, context.px(10)));
    if (draw_label_button(context, "welcome new", "New", ButtonLook::primary)) context.queue.run(editor::NewDocument{});
    ImGui::SameLine();
    if (draw_label_button(context, "welcome open", "Open…")) context.queue.run(editor::Open{});
    if (context.state.message.is_error) {
        ImGui::Dummy(ImVec2(1.0F, context.px(4)));
        draw_dialog_error(context, context.state.message.text);
    }
    draw_offered_lessons(context);
    draw_recent(context);
    ImGui::EndChild();
}

/// How the cards share the room: as many columns of equal width, with equal heights of picture and texts.
struct CardGrid {
    int columns = 1;
    float width = 0.0F;
    float thumbnail = 0.0F;
    float texts = 0.0F;
    float height() const { return thumbnail + texts; }
};

float wrapped_height(ImFont* font, const std::string& text, float wrap) {
    return text.empty() ? 0.0F : lines_size(wrapped(text, font, wrap), font).y;
}

float card_text_width(const PanelContext& context, float card_width_px) {
    return card_width_px - 2.0F * context.px(card_margin);
}

/// What the longest texts need below the picture, so that none is cut.
float texts_height(const PanelContext& context, float card_width_px) {
    const float wrap = card_text_width(context, card_width_px);
    float most = 0.0F;
    for (const Example& example : examples_of(context))
        most = std::max(most, wrapped_height(context.fonts.bold, title_of(example), wrap) +
                                  wrapped_height(context.fonts.small, example.document.description, wrap));
    return most + context.px(3.0 + 2.0 * card_margin);
}

/// The grid of so many columns that fills `room`; its thumbnails may come out too low.
CardGrid grid_of(const PanelContext& context, ImVec2 room, int columns) {
    const float gap = context.px(card_gap);
    const auto count = static_cast<int>(examples_of(context).size());
    const auto rows = static_cast<float>((count + columns - 1) / columns);
    CardGrid grid;
    grid.columns = columns;
    grid.width = std::floor((room.x - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    grid.texts = texts_height(context, grid.width);
    grid.thumbnail = std::floor((room.y - gap * (rows - 1.0F)) / rows - grid.texts);
    return grid;
}

/// How large a thumbnail looks.
float shown_size(const CardGrid& grid) {
    return std::min(grid.width, thumbnail_aspect * grid.thumbnail);
}

/// The grid with the largest thumbnails that fits into `room`; where none does it has as many columns as there is width
/// for, and scrolls.
CardGrid best_grid(const PanelContext& context, ImVec2 room) {
    const float gap = context.px(card_gap);
    const int most = std::max(1, static_cast<int>((room.x + gap) / (context.px(least_card_width) + gap)));
    CardGrid best = grid_of(context, room, most);
    for (int columns = most - 1; columns > 0; --columns) {
        const CardGrid grid = grid_of(context, room, columns);
        if (shown_size(grid) > shown_size(best)) best = grid;
    }
    if (best.thumbnail >= context.px(least_thumbnail)) return best;
    best = grid_of(context, room, most);
    best.thumbnail = context.px(usual_thumbnail);
    return best;
}

void draw_card_back(const PanelContext& context, const Rectangle& place, float thumbnail_px, bool is_hovered) {
    const glm::vec2 low(place.origin_px);
    const glm::vec2 high(place.origin_px + place.size_px);
    const float picture_bottom = low.y + thumbnail_px;
    const float rounding = context.px(8);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({low.x, low.y}, {high.x, high.y}, imgui_packed(context.theme.field), rounding);
    list->AddRectFilled({low.x, low.y}, {high.x, picture_bottom}, imgui_packed(context.theme.canvas), rounding,
                        ImDrawFlags_RoundCornersTop);
    const render::Color edge = is_hovered ? context.theme.accent : context.theme.line;
    list->AddRect({low.x, low.y}, {high.x, high.y}, imgui_packed(edge), rounding, 0,
                  is_hovered ? context.px(1.5) : std::max(1.0F, context.px(1)));
}

void draw_card_texts(const PanelContext& context, const Example& example, const Rectangle& place, float top) {
    const float left = static_cast<float>(place.origin_px.x) + context.px(card_margin);
    const float wrap = card_text_width(context, static_cast<float>(place.size_px.x));
    const std::string title = title_of(example);
    const std::string& sentence = example.document.description;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddText(context.fonts.bold, font_height(context.fonts.bold), {left, top}, imgui_packed(context.theme.text),
                  wrapped(title, context.fonts.bold, wrap).c_str());
    const float below = top + wrapped_height(context.fonts.bold, title, wrap) + context.px(3);
    list->AddText(context.fonts.small, font_height(context.fonts.small), {left, below}, imgui_packed(context.theme.dim),
                  wrapped(sentence, context.fonts.small, wrap).c_str());
    const float height = wrapped_height(context.fonts.small, sentence, wrap);
    context.widgets.push_back(
        {fmt::format("example {} sentence", example.name), {{left, below}, {wrap, height}}, sentence});
}

void draw_card(const PanelContext& context, const Example& example, const CardGrid& grid) {
    ImGui::PushID(example.name.c_str());
    const bool is_clicked = ImGui::InvisibleButton("##card", ImVec2(grid.width, grid.height()));
    ImGui::PopID();
    report_item(context, fmt::format("example {}", example.name), title_of(example));
    const Rectangle place = last_item_place();
    draw_card_back(context, place, grid.thumbnail, ImGui::IsItemHovered());
    const double inset = 14.0 * context.scale;
    draw_thumbnail(context, example,
                   {place.origin_px + inset, {place.size_px.x - 2.0 * inset, grid.thumbnail - 2.0 * inset}});
    draw_card_texts(context, example, place,
                    static_cast<float>(place.origin_px.y) + grid.thumbnail + context.px(card_margin));
    if (is_clicked) context.queue.run(editor::OpenExample{.name = example.name});
}

void draw_grid(const PanelContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(card_gap), context.px(card_gap)));
    ImGui::BeginChild("examples", ImVec2(0.0F, 0.0F), false, ImGuiWindowFlags_NoNav);
    // Room for the scroll bar, whether it is there or not, so that cards do not jump.
    const ImVec2 room(ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize - context.px(4),
                      ImGui::GetWindowHeight());
    const CardGrid grid = best_grid(context, room);
    int index = 0;
    for (const Example& example : examples_of(context)) {
        if (index % grid.columns != 0) ImGui::SameLine();
        draw_card(context, example, grid);
        ++index;
    }
    if (index == 0) ImGui::TextDisabled("The folder of examples is missing.");
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_welcome_screen(const PanelContext& context, const Rectangle& window) {
    if (context.state.dialog != editor::Dialog::welcome) return;
    DialogFrame frame;
    frame.title = "Welcome";
    frame.size = {most_dialog_width, most_dialog_height};
    const bool is_left = begin_dialog(context, window, frame);
    draw_side(context);
    ImGui::SameLine(0.0F, context.px(16));
    draw_grid(context);
    end_dialog();
    if (is_left) context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
