#include <fmt/core.h>
#include <imgui.h>

#include <functional>
#include <string_view>

#include "app/editor/command_table.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/lesson_commands.h"
#include "app/ui/context_popup.h"
#include "app/ui/example_list.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/lesson_list.h"
#include "app/ui/menu_entry.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

using editor::CommandGroup;
using editor::CommandSpec;

const char* const program_name = "batten";
const char* const rest_title = "»";
constexpr double widest_gap = 20.0;
constexpr double least_gap = 5.0;  // on either side of a menu

/// The commands of a menu, or of one of its submenus, that stand together in one column.
struct Column {
    CommandGroup group;
    const char* submenu = nullptr;

    bool holds(const CommandSpec& spec) const {
        return spec.offered.menu && spec.group == group &&
               std::string_view(spec.submenu == nullptr ? "" : spec.submenu) ==
                   std::string_view(submenu == nullptr ? "" : submenu);
    }
};

Columns columns_of(const PanelContext& context, const Column& column) {
    Columns columns;
    for (const CommandSpec& spec : editor::command_table())
        if (column.holds(spec)) make_room(context, columns, {&spec});
    return columns;
}

void draw_recent_files(const PanelContext& context) {
    const auto& files = context.state.recent_files;
    if (!ImGui::BeginMenu("Open Recent", !files.empty())) return;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string path = files[i].string();
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(elided(path, context.fonts.text, context.px(460)).c_str())) {
            context.queue.run(editor::Open{.path = path});
        }
        ImGui::PopID();
        if (ImGui::IsItemHovered()) draw_side_tooltip(context, path);
        report_item(context, fmt::format("menu-item recent {}", i), path);
        if (ImGui::IsItemHovered()) draw_side_tooltip(context, path);
    }
    ImGui::EndMenu();
}

void draw_examples(const PanelContext& context) {
    if (!ImGui::BeginMenu("Examples")) return;
    for (const Example& example : examples_of(context)) {
        ImGui::PushID(example.name.c_str());
        if (ImGui::Selectable(title_of(example).c_str())) context.queue.run(editor::OpenExample{.name = example.name});
        ImGui::PopID();
        report_item(context, fmt::format("menu-item example {}", example.name));
    }
    ImGui::EndMenu();
}

void draw_lessons(const PanelContext& context) {
    if (!ImGui::BeginMenu("Open lesson")) return;
    for (const LessonEntry& lesson : lessons_of(context)) {
        ImGui::PushID(lesson.name.c_str());
        if (ImGui::Selectable(lesson.title.c_str())) context.queue.run(editor::OpenLesson{lesson.name});
        ImGui::PopID();
        report_item(context, fmt::format("menu-item lesson {}", lesson.name));
    }
    ImGui::EndMenu();
}

/// A submenu, whose place is reported before Dear ImGui turns to what is in it.
void draw_submenu(const PanelContext& context, const std::string& place_name,
                  const std::function<void(const PanelContext&)>& draw) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    context.widgets.push_back(
        {place_name, {{corner.x, corner.y}, {context.px(120), font_height(context.fonts.text)}}, {}});
    draw(context);
}

void draw_column(const PanelContext& context, const Column& column);

void draw_submenu_of_commands(const PanelContext& context, const CommandSpec& first) {
    const auto draw = [&first](const PanelContext& inner) {
        if (!ImGui::BeginMenu(first.submenu)) return;
        draw_column(inner, {first.group, first.submenu});
        ImGui::EndMenu();
    };
    draw_submenu(context, fmt::format("menu-item {}", first.submenu), draw);
}

/// The submenus of a menu stand where their first commands do.
bool is_first_of_submenu(const CommandSpec& spec) {
    for (const CommandSpec& other : editor::command_table())
        if (Column{spec.group, spec.submenu}.holds(other)) return &other == &spec;
    return false;
}

void draw_column(const PanelContext& context, const Column& column) {
    const Columns columns = columns_of(context, column);
    for (const CommandSpec& spec : editor::command_table()) {
        const bool opens_submenu = column.submenu == nullptr && spec.group == column.group && spec.submenu != nullptr;
        if (opens_submenu && is_first_of_submenu(spec)) draw_submenu_of_commands(context, spec);
        if (!column.holds(spec)) continue;
        if (&spec == &editor::OpenExample::spec())
            draw_submenu(context, "menu-item examples", draw_examples);
        else if (&spec == &editor::OpenLesson::spec())
            draw_submenu(context, "menu-item open-lesson", draw_lessons);
        else
            draw_menu_entry(context, {&spec}, columns);
        if (&spec == &editor::Open::spec()) draw_submenu(context, "menu-item open-recent", draw_recent_files);
    }
    if (columns.sign > 0.0F) draw_menu_legend(context);
}

void draw_menu(const PanelContext& context, const core::Named<CommandGroup>& menu, const Rectangle& bar) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    context.widgets.push_back(
        {fmt::format("menu {}", menu.name),
         {{ImGui::GetCursorScreenPos().x, bar.origin_px.y}, {menu_text_width(menu.title) + gap, bar.size_px.y}},
         {}});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(14), context.px(11)));
    if (ImGui::BeginMenu(menu.title)) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(16), context.px(9)));
        draw_column(context, {menu.value});
        ImGui::PopStyleVar();
        ImGui::EndMenu();
    }
    ImGui::PopStyleVar();
}

void draw_file_name(const PanelContext& context, const Rectangle& place) {
    const std::string mark = context.state.is_modified() ? " •" : "";
    const float right = static_cast<float>(place.origin_px.x + place.size_px.x) - context.px(16);
    const float room = right - ImGui::GetCursorScreenPos().x - context.px(16);
    const std::string text =
        elided(context.state.file_name(), context.fonts.text, room - menu_text_width(mark)).append(mark);
    const float line = font_height(context.fonts.text);
    const ImVec2 corner(right - menu_text_width(text),
                        static_cast<float>(place.origin_px.y) + 0.5F * (static_cast<float>(place.size_px.y) - line));
    if (room <= menu_text_width("…")) return;
    ImGui::GetWindowDrawList()->AddText(corner, imgui_packed(context.theme.dim), text.c_str());
    show_cut_text(context, context.state.path.empty() ? context.state.file_name() : context.state.path.string(), corner,
                  {right, corner.y + line});
    context.widgets.push_back({"file name", {{corner.x, corner.y}, {menu_text_width(text), line}}, text});
}

/// How the bar is filled: gaps shrink first, then the name of the program goes, then the last menus fold into one.
struct BarLayout {
    float gap = 0.0F;
    bool has_name = true;
    std::size_t shown = 0;  ///< menus on the bar itself
};

std::vector<core::Named<CommandGroup>> menus() {
    std::vector<core::Named<CommandGroup>> found;
    for (const auto& menu : core::Names<CommandGroup>::table)
        if (menu.value != CommandGroup::gesture) found.push_back(menu);
    return found;
}

BarLayout layout_of(const PanelContext& context, float room_px) {
    const float least = context.px(least_gap);
    BarLayout layout;
    float needed = text_width(program_name, context.fonts.bold) + least;
    for (const auto& menu : menus()) needed += menu_text_width(menu.title) + 2.0F * least;
    layout.has_name = needed <= room_px;
    if (!layout.has_name) needed -= text_width(program_name, context.fonts.bold) + least;
    layout.shown = menus().size();
    if (needed > room_px) needed += menu_text_width(rest_title) + 2.0F * least;
    while (needed > room_px && layout.shown > 1)
        needed -= menu_text_width(menus()[--layout.shown].title) + 2.0F * least;
    const auto gaps = static_cast<float>(2 * layout.shown + (layout.has_name ? 1U : 0U));
    layout.gap = std::floor(std::clamp(least + (room_px - needed) / gaps, least, context.px(widest_gap)));
    return layout;
}

void draw_document_name(const PanelContext& context) {
    ImGui::PushFont(context.fonts.bold);
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.accent));
    ImGui::TextUnformatted(program_name);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

/// The menus that have no room on the bar, as submenus of one.
void draw_rest_of_menus(const PanelContext& context, std::size_t first, const Rectangle& bar) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    context.widgets.push_back({"menu more", {{corner.x, bar.origin_px.y}, {context.px(20), bar.size_px.y}}, {}});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(14), context.px(11)));
    if (ImGui::BeginMenu(rest_title)) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(16), context.px(9)));
        for (std::size_t i = first; i < menus().size(); ++i) {
            const ImVec2 place = ImGui::GetCursorScreenPos();
            draw_menu(context, menus()[i], {{place.x, place.y}, {0.0, font_height(context.fonts.text)}});
        }
        ImGui::PopStyleVar();
        ImGui::EndMenu();
    }
    ImGui::PopStyleVar();
}

}  // namespace

void draw_menu_bar(const PanelContext& context, const Rectangle& place) {
    const float line = font_height(context.fonts.text);
    const auto height = static_cast<float>(place.size_px.y);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(16), 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(8), 0.5F * (height - line)));
    begin_panel("menu bar", place, ImGuiWindowFlags_MenuBar);
    const BarLayout layout = layout_of(context, static_cast<float>(place.size_px.x) - 2.0F * context.px(16));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(layout.gap, context.px(4)));
    if (ImGui::BeginMenuBar()) {
        if (layout.has_name) draw_document_name(context);
        for (std::size_t i = 0; i < layout.shown; ++i) draw_menu(context, menus()[i], place);
        if (layout.shown < menus().size()) draw_rest_of_menus(context, layout.shown, place);
        draw_file_name(context, place);
        ImGui::EndMenuBar();
    }
    if (ImGui::IsWindowHovered() && asks_for_menu()) open_context_menu(context, editor::OnPanel{});
    const double bottom = place.origin_px.y + place.size_px.y - 0.5;
    draw_edge(context, {place.origin_px.x, bottom}, {place.origin_px.x + place.size_px.x, bottom});
    ImGui::PopStyleVar();
    end_panel();
    ImGui::PopStyleVar(2);
}

}  // namespace batten::ui
