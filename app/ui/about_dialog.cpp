#include <imgui.h>

#include "app/editor/commands/help_commands.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/panels.h"
#include "app/ui/style.h"
#include "core/base/version.h"

namespace batten::ui {

void draw_about_dialog(const PanelContext& context, const Rectangle& window) {
    if (context.state.dialog != editor::Dialog::about) return;
    DialogFrame frame;
    frame.title = "About";
    frame.size = {440.0, 230.0};
    const bool is_left = begin_dialog(context, window, frame);
    ImGui::PushFont(context.fonts.large);
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.accent));
    ImGui::TextUnformatted("batten");
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::TextDisabled("version %s", core::version_text);
    ImGui::Dummy(ImVec2(1.0F, context.px(6)));
    ImGui::TextWrapped(
        "An editor for B-spline and NURBS curves: for teaching them, for drawing with them exactly, and for "
        "seeing what knots do.");
    ImGui::Dummy(ImVec2(1.0F, context.px(4)));
    ImGui::TextWrapped("Named after the thin strip of wood that shipwrights bent to draw fair curves.");
    end_dialog();
    if (is_left) context.queue.run(editor::CloseDialog{});
}

}  // namespace batten::ui
