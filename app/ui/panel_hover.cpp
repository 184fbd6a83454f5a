#include "app/ui/panel_hover.h"

#include <imgui.h>

#include "app/editor/pointer/hover_request.h"

namespace batten::ui {

void begin_panel_hover(const PanelContext& context) {
    context.panels.hover.wish.reset();
    context.panels.hover.is_inside = false;
}

void wish_hover(const PanelContext& context, const editor::Hover& hover) {
    context.panels.hover.wish = hover;
}

void note_panel_hover(const PanelContext& context, bool is_inside) {
    context.panels.hover.is_inside |= is_inside;
}

void settle_panel_hover(const PanelContext& context) {
    PanelHover& hover = context.panels.hover;
    const bool has_left = hover.is_owner && context.panels.pointer.hovered == Picture::none;
    // A field that is dragged or typed keeps what was lit.
    const bool is_busy = ImGui::IsAnyItemActive() || hover.was_busy;
    hover.was_busy = ImGui::IsAnyItemActive();
    if (is_busy) return;
    const editor::Hover wish = hover.wish.value_or(editor::HoveredNothing{});
    if (hover.is_inside || has_left)
        editor::request_hover(hover.is_inside ? wish : editor::HoveredNothing{}, context.state, context.queue);
    hover.is_owner = hover.is_inside;
}

}  // namespace batten::ui
