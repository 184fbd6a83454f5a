#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/words/reading_text.h"
#include "app/ui/command_entry.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

// Design pixels.
constexpr double halo_radius = 20.0;
constexpr double caption_margin = 14.0;

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

/// A text of the line at the foot of the window.
struct Caption {
    const char* name;
    const std::string& text;
    render::Color color;
    float room_px;
    render::Anchor anchor = render::Anchor::left;
};

struct PresentedReadout {
    const char* name;
    std::string text;
};

/// Returns its width.
float draw_caption(const PanelContext& context, const Rectangle& place, const Caption& caption) {
    const glm::vec2 corner(place.origin_px);
    const glm::vec2 size(place.size_px);
    const float margin = context.px(caption_margin);
    const bool is_left = caption.anchor == render::Anchor::left;
    const ImVec2 start(corner.x + (is_left ? margin : size.x - margin), corner.y + 0.5F * size.y);
    const float width = draw_text(
        context, start, {caption.text, context.fonts.bold, 0.0, caption.color, caption.anchor, caption.room_px});
    const double left = is_left ? start.x : start.x - width;
    context.widgets.push_back({caption.name, {{left, corner.y}, {width, size.y}}, caption.text});
    return width;
}

/// What the last action did.
std::string message_of(const PanelContext& context) {
    const editor::Message& message = context.state.message;
    if (message.text.empty() || message.is_error) return "";
    return context.notated(editor::brief_reading_text(message.text));
}

/// "p = 3", with the order beside it where it is asked for.
std::string degree_of(const PanelContext& context) {
    const core::Curve* curve = context.state.active_curve();
    if (curve == nullptr) return "";
    return context.notated(core::sentence("p = {degree}", {{"degree", curve->degree()}}));
}

/// The keys that were pressed last, with what they do.
std::string pressed_keys(const PanelContext& context) {
    std::string& shown = context.panels.presenting.keys;
    for (const KeyPress& press : context.input.key_presses) {
        const editor::CommandSpec* spec = command_of(context.state, press);
        const std::string keys = editor::text_of(press.shortcut);
        if (keys.empty()) continue;
        shown = spec == nullptr
                    ? keys
                    : core::sentence("{keys}: {title}", {{"keys", keys}, {"title", context.notated(spec->title)}});
    }
    return context.state.view.keys_are_shown ? shown : "";
}

/// How to get at what is hidden: told at first, until something is done.
std::string hint_of(const PanelContext& context) {
    PresentingState& presenting = context.panels.presenting;
    const bool acts = !context.input.key_presses.empty() || ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    presenting.has_hint = !std::exchange(presenting.was_on, true) || (presenting.has_hint && !acts);
    if (!presenting.has_hint) return {};
    const auto key = [](const editor::CommandSpec& spec) { return editor::text_of(spec.shortcut); };
    return core::sentence(
        "{present} leaves · {dock} folds the plot · {palette} finds commands · {keys} shows keys · {help} lists them",
        {{"present", key(editor::TogglePresenting::spec())},
         {"dock", key(editor::ToggleDock::spec())},
         {"palette", key(editor::TogglePalette::spec())},
         {"keys", key(editor::ToggleKeys::spec())},
         {"help", key(editor::ToggleKeySheet::spec())}});
}

}  // namespace

void draw_presenting(const PanelContext& context, const Rectangle& place) {
    if (!context.state.view.is_presenting) {
        context.panels.presenting = {};
        return;
    }
    const std::string hint = hint_of(context);
    begin_panel("presented line", place);
    draw_edge(context, place.origin_px + glm::dvec2(0.0, 0.5), place.origin_px + glm::dvec2(place.size_px.x, 0.5));
    const float margin = context.px(caption_margin);
    Rectangle room = place;
    for (const auto& [name, text] : {PresentedReadout{"presented degree", degree_of(context)},
                                     PresentedReadout{"presented keys", pressed_keys(context)}}) {
        if (text.empty()) continue;
        const float room_px = static_cast<float>(room.size_px.x) - 2.0F * margin;
        room.size_px.x -=
            margin + draw_caption(context, room, {name, text, context.theme.accent, room_px, render::Anchor::right});
    }
    const float room_px = static_cast<float>(room.size_px.x) - 2.0F * margin;
    const std::string message = message_of(context);
    if (!hint.empty())
        draw_caption(context, room, {"presented hint", hint, context.theme.dim, room_px});
    else if (!message.empty())
        draw_caption(context, room, {"presented message", message, context.theme.text, room_px});
    end_panel();
    draw_halo(context);
}

}  // namespace batten::ui
