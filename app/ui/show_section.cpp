#include <fmt/core.h>
#include <imgui.h>

#include "app/editor/commands/overlay_commands.h"
#include "app/ui/command_entry.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/section.h"

namespace batten::ui {
namespace {

using editor::Overlay;

void draw_switch(const PanelContext& context, Overlay overlay, float width_px) {
    const editor::CommandSpec& spec = editor::toggle_overlay_spec(overlay);
    Button box;
    box.name = fmt::format("show {}", core::name_of(overlay));
    box.text = core::title_of(overlay);
    box.width_px = width_px;
    box.height = 20.0;
    box.has_frame = false;
    box.is_active = context.state.view.overlays.is_shown(overlay);
    box.tooltip = command_tooltip(spec, context.state);
    if (draw_check_box(context, box)) run_command(context, spec);
}

}  // namespace

void draw_show_section(const PanelContext& context) {
    if (draw_section_heading(context, {"show", "Show", ""})) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.px(2)));
        const float half = 0.5F * content_width(context);
        for (std::size_t i = 0; i < editor::basic_overlay_count; ++i) {
            if (i % 2 == 1) stay_in_row(context, 0.0);
            draw_switch(context, static_cast<Overlay>(i), half);
        }
        ImGui::PopStyleVar();
    }
    add_space(context, 10);
}

}  // namespace batten::ui
