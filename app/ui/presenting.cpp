#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/command_table.h"
#include "app/editor/words/reading_text.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

// Design pixels.
constexpr double halo_radius = 20.0;
constexpr double caption_margin = 14.0;
constexpr double caption_padding = 10.0;
constexpr double caption_bottom = 30.0;  // above the numbers of the grid

/// Around the pointer, so that it is seen from the last row.
void draw_halo(const PanelContext& context) {
    const ImVec2 mouse = ImGui::GetMousePos();
    if (!ImGui::IsMousePosValid(&mouse)) return;
    ImDrawList* list = ImGui::GetForegroundDrawList();
    list->AddCircleFilled(mouse, context.px(halo_radius), imgui_packed(render::faded(context.theme.parameter, 0.18)),
                          48);
    list->AddCircle(mouse, context.px(halo_radius), imgui_packed(render::faded(context.theme.parameter, 0.8)), 48,
                    context.px(2));
}

/// A line on a ground, whose lower left corner is given. Returns its height.
float draw_caption(const PanelContext& context, const char* name, const std::string& text, ImVec2 lower_left,
                   float room) {
    ImFont* font = context.fonts.bold;
    const std::string lines = wrapped(text, font, room - 2.0F * context.px(caption_padding));
    const glm::vec2 size = lines_size(lines, font) + 2.0F * context.px(caption_padding);
    const ImVec2 upper(lower_left.x, std::floor(lower_left.y - size.y));
    const ImVec2 end(lower_left.x + size.x, lower_left.y);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled(upper, end, imgui_packed(render::faded(context.theme.panel, 0.92)), context.px(8));
    list->AddRect(upper, end, imgui_packed(context.theme.line), context.px(8), 0, context.px(1));
    list->AddText(font, font_height(font),
                  ImVec2(upper.x + context.px(caption_padding), upper.y + context.px(caption_padding)),
                  imgui_packed(context.theme.text), lines.c_str());
    context.widgets.push_back({name, {{upper.x, upper.y}, {size.x, size.y}}, text});
    return size.y;
}

/// What the last action did, with the degree of the curve that it is about.
std::string caption_of(const PanelContext& context) {
    const editor::Message& message = context.state.message;
    if (message.text.empty() || message.is_error) return "";
    const std::string text = editor::reading_text(message.text);
    const core::Curve* curve = context.state.active_curve();
    return context.notated(
        curve == nullptr ? text
                         : core::sentence("p = {degree}: {message}", {{"degree", curve->degree()}, {"message", text}}));
}

/// Follows the keys that are pressed: they stay until others are.
std::string keys_of(const PanelContext& context) {
    std::string& shown = context.panels.shown_keys;
    for (const KeyPress& press : context.input.key_presses) {
        const editor::CommandSpec* spec = editor::find_command(press.shortcut);
        const std::string keys = editor::text_of(press.shortcut);
        if (keys.empty()) continue;
        shown = spec == nullptr
                    ? keys
                    : core::sentence("{keys}: {title}", {{"keys", keys}, {"title", context.notated(spec->title)}});
    }
    return context.state.view.keys_are_shown ? shown : "";
}

}  // namespace

void draw_presenting(const PanelContext& context, const Rectangle& canvas) {
    const glm::vec2 corner(canvas.origin_px);
    const glm::vec2 size(canvas.size_px);
    const float room = 0.5F * size.x;
    ImVec2 place(corner.x + context.px(caption_margin), corner.y + size.y - context.px(caption_bottom));
    const std::string keys = keys_of(context);
    if (!keys.empty()) place.y -= draw_caption(context, "presented keys", keys, place, room) + context.px(6);
    const std::string caption = caption_of(context);
    if (!caption.empty()) draw_caption(context, "presented message", caption, place, room);
    draw_halo(context);
}

}  // namespace batten::ui
