#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/editor/command_table.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/fuzzy_match.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

using editor::CommandGroup;

struct Entry {
    std::string keys;
    std::string meaning;
};

/// A heading with what stands below it; blocks are never torn apart.
struct Block {
    std::string title;
    std::vector<Entry> entries;
};

Block mouse_block() {
    return {"Mouse",
            {{"Wheel", "zoom at the pointer"},
             {"Shift + wheel, sideways wheel", "pan to the side"},
             {"Middle drag, Space + drag", "pan"},
             {"Escape", "leave the tool"},
             {"Click, Shift + click", "select points"},
             {"Drag on nothing", "select by a box"},
             {"Ctrl + drag on nothing", "select of all curves"},
             {"Shift + click a curve", "select it, too"},
             {"Drag a point", "move the selection"},
             {"Ctrl while dragging", "snap to the grid"},
             {"Shift while dragging", "keep to one axis"},
             {"Alt + drag a point", "change its weight"},
             {"Drag a ring", "change the weight"},
             {"Drag C(u)", "change u"},
             {"Drag the curve", "move that point of it ≠"},
             {"Drag out of a ruler", "add a guide"},
             {"Double-click the curve", "insert a knot ≅"},
             {"Double-click the polygon", "add a point ≠"},
             {"Double-click a knot", "raise its multiplicity ≅"}}};
}

Block transform_block() {
    return {"Transform box",
            {{"Drag a square", "scale, with Shift alike ≠"},
             {"Drag a disc", "turn, with Ctrl by steps"},
             {"Drag a side", "shear ≠"},
             {"Drag or click the pivot", "choose what stays"}}};
}

Block strip_block() {
    return {"Knot strip and basis plot",
            {{"Drag a knot", "move it ≠"},
             {"Drag a knot off a stack", "lower its multiplicity ≠"},
             {"Double-click the strip", "insert a knot ≅"},
             {"Drag in the plot", "change u"},
             {"Wheel, middle drag", "zoom and move the axis"}}};
}

std::string keys_of(const editor::CommandSpec& spec) {
    std::string keys = editor::text_of(spec.shortcut);
    const std::string second = editor::text_of(spec.second_shortcut);
    return second.empty() ? keys : fmt::format("{}, {}", keys, second);
}

Block command_block(CommandGroup group) {
    Block block{core::title_of(group), {}};
    for (const editor::CommandSpec& spec : editor::command_table())
        if (spec.group == group && spec.offered.key_sheet && !keys_of(spec).empty())
            block.entries.push_back({keys_of(spec), spec.title});
    return block;
}

Block edit_block() {
    Block block = command_block(CommandGroup::edit);
    block.entries.push_back({"Arrows", "Nudge points by a tenth"});
    block.entries.push_back({"Shift + arrows", "Nudge points by a grid step"});
    return block;
}

Block help_block() {
    Block block = command_block(CommandGroup::help);
    block.entries.push_back({"Page Down, Page Up", "Next and previous step of a lesson"});
    return block;
}

Block tool_block() {
    Block block{"Tools", {}};
    for (const editor::Tool tool : editor::all_tools) {
        const editor::CommandSpec& spec = editor::take_tool_spec(tool);
        block.entries.push_back({keys_of(spec), spec.title});
    }
    return block;
}

Block filtered(const Block& block, const std::string& filter) {
    Block result{block.title, {}};
    for (const Entry& entry : block.entries) {
        const bool fits = fuzzy_score(filter, entry.meaning) || fuzzy_score(filter, entry.keys);
        if (fits) result.entries.push_back(entry);
    }
    return result;
}

std::vector<Block> blocks_of(const std::string& filter) {
    const std::array all{mouse_block(),
                         transform_block(),
                         command_block(CommandGroup::view),
                         edit_block(),
                         tool_block(),
                         strip_block(),
                         command_block(CommandGroup::file),
                         command_block(CommandGroup::construct),
                         command_block(CommandGroup::make),
                         command_block(CommandGroup::curve),
                         command_block(CommandGroup::analyze),
                         help_block()};
    std::vector<Block> blocks;
    for (const Block& block : all) {
        Block rest = filtered(block, filter);
        if (!rest.entries.empty()) blocks.push_back(std::move(rest));
    }
    return blocks;
}

void draw_block(const PanelContext& context, const Block& block, ImVec2 corner, float width_px) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float pitch = font_height(context.fonts.text) + context.px(5);
    list->AddText(context.fonts.bold, font_height(context.fonts.bold), corner, imgui_packed(context.theme.text),
                  block.title.c_str());
    float y = corner.y + pitch;
    for (const Entry& entry : block.entries) {
        const float keys_width = text_width(entry.keys, context.fonts.text);
        const std::string whole = context.notated(entry.meaning);
        const std::string meaning = elided(whole, context.fonts.text, width_px - keys_width - context.px(10));
        list->AddText({corner.x, y}, imgui_packed(context.theme.dim), meaning.c_str());
        if (meaning != whole)
            show_cut_text(context, whole, {corner.x, y}, {corner.x + width_px - keys_width, y + pitch});
        list->AddText({corner.x + width_px - keys_width, y}, imgui_packed(context.theme.text), entry.keys.c_str());
        y += pitch;
    }
}

/// Every block goes below the shortest column so far.
void draw_blocks(const PanelContext& context, const std::vector<Block>& blocks) {
    const float gap = context.px(28);
    const float room = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<std::size_t>(std::clamp((room + gap) / (context.px(270) + gap), 1.0F, 3.0F));
    const float width = (room - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
    const float pitch = font_height(context.fonts.text) + context.px(5);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    std::vector<float> heights(count, 0.0F);
    for (const Block& block : blocks) {
        const auto column = std::min_element(heights.begin(), heights.end());
        const float x = corner.x + static_cast<float>(column - heights.begin()) * (width + gap);
        draw_block(context, block, {x, corner.y + *column}, width);
        *column += pitch * static_cast<float>(block.entries.size() + 1) + context.px(12);
    }
    ImGui::Dummy(ImVec2(room, *std::max_element(heights.begin(), heights.end())));
}

}  // namespace

void draw_key_sheet(const PanelContext& context, const Rectangle& window) {
    if (context.state.dialog != editor::Dialog::key_sheet) return;
    DialogFrame frame;
    frame.title = "Keys and gestures";
    frame.size = {980.0, 700.0};
    const bool is_left = begin_dialog(context, window, frame) || was_pressed(context, editor::Key::f1);
    ImGui::SetNextItemWidth(context.px(260));
    ImGui::InputTextWithHint("##filter", "Find a key or what it does", &context.panels.key_sheet_filter);
    report_item(context, "key-sheet filter", context.panels.key_sheet_filter);
    // Beside the filter, or below it in a narrow window.
    const char* const signs = "≅ keeps the shape   ≠ changes it";
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < text_width(signs, context.fonts.text)) ImGui::NewLine();
    ImGui::TextDisabled("%s", signs);
    report_item(context, "key-sheet signs");
    ImGui::Dummy(ImVec2(1.0F, context.px(4)));
    ImGui::BeginChild("keys", ImVec2(0.0F, 0.0F), false, ImGuiWindowFlags_NoNav);
    draw_blocks(context, blocks_of(context.panels.key_sheet_filter));
    ImGui::EndChild();
    end_dialog();
    if (!is_left) return;
    context.panels.key_sheet_filter.clear();
    context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
