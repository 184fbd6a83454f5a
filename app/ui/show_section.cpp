#include <imgui.h>

#include <array>

#include "app/editor/command_table.h"
#include "app/ui/command_entry.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/section.h"

namespace batten::ui {
namespace {

using editor::Overlay;

struct Switch {
    Overlay overlay;
    const char* text;
    const char* command;
};

/// In the order of rows, two in each.
constexpr std::array switches{
    Switch{Overlay::polygon, "polygon", "toggle-polygon"},
    Switch{Overlay::hull, "hull", "toggle-hull"},
    Switch{Overlay::bezier_pieces, "Bézier pieces", "toggle-pieces"},
    Switch{Overlay::curvature_comb, "curvature comb", "toggle-comb"},
    Switch{Overlay::knots, "knots", "toggle-knots"},
    Switch{Overlay::hodograph, "hodograph", "toggle-hodograph"},
    Switch{Overlay::labels, "labels", "toggle-labels"},
    Switch{Overlay::grid, "grid", "toggle-grid"},
    Switch{Overlay::construction, "construction", "toggle-construction"},
};

void draw_switch(const PanelContext& context, const Switch& item, float width_px) {
    const editor::CommandSpec* spec = editor::find_command(item.command);
    Button box;
    box.name = std::string("show ") + core::name_of(item.overlay);
    box.text = item.text;
    box.width_px = width_px;
    box.height = 20.0;
    box.has_frame = false;
    box.is_active = context.state.view.overlays.is_shown(item.overlay);
    if (spec != nullptr) box.tooltip = command_tooltip(*spec, context.state);
    if (draw_check_box(context, box)) context.queue.run(item.command);
}

}  // namespace

void draw_show_section(const PanelContext& context) {
    if (draw_section_heading(context, {"show", "Show", ""})) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, context.px(2)));
        const float half = 0.5F * content_width(context);
        for (std::size_t i = 0; i < switches.size(); ++i) {
            if (i % 2 == 1) stay_in_row(context, 0.0);
            draw_switch(context, switches[i], half);
        }
        ImGui::PopStyleVar();
    }
    add_space(context, 10);
}

}  // namespace batten::ui
