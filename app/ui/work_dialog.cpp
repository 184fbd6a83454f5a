#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/dialog_frame.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

std::string words_of(const editor::AtWork& work) {
    if (work.is_canceled) return "It will stop as soon as it can.";
    if (!work.share) return "The document stays as it is until this is done.";
    return core::sentence("{percent} % done; the document stays as it is until all is.",
                          {{"percent", static_cast<int>(std::floor(100.0 * *work.share))}});
}

void draw_bar(const PanelContext& context, double share) {
    constexpr double height = 8.0;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, std::round(context.px(height)));
    const float rounding = 0.5F * size.y;
    const float filled = std::max(size.y, size.x * static_cast<float>(std::clamp(share, 0.0, 1.0)));
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, imgui_packed(context.theme.field), rounding);
    list->AddRect(corner, {corner.x + size.x, corner.y + size.y}, imgui_packed(context.theme.line), rounding);
    if (share > 0.0)
        list->AddRectFilled(corner, {corner.x + filled, corner.y + size.y}, imgui_packed(context.theme.accent),
                            rounding);
    ImGui::Dummy(size);
}

}  // namespace

void draw_work_dialog(const PanelContext& context, const Rectangle& window, const Rectangle& canvas) {
    const std::optional<editor::AtWork>& work = context.state.at_work;
    if (context.state.dialog != editor::Dialog::at_work || !work) return;
    constexpr double width = 440.0;
    constexpr double room_of_title = width - 80.0;  // beside the cross
    DialogFrame frame;
    frame.title = elided(work->text, context.fonts.bold, context.px(room_of_title));
    frame.size = {width, 148.0};
    frame.beside = canvas;
    frame.closes_on_outside = false;
    const bool is_left = begin_dialog(context, window, frame);
    draw_bar(context, work->share.value_or(0.0));
    report_item(context, "work", words_of(*work));
    ImGui::Dummy({0.0F, context.px(2)});
    ImGui::TextDisabled("%s", words_of(*work).c_str());
    const float button = label_button_width(context, "Cancel");
    ImGui::SetCursorPos({ImGui::GetWindowWidth() - button - context.px(18), ImGui::GetWindowHeight() - context.px(46)});
    const bool is_pressed = draw_label_button(context, "dialog cancel", "Cancel");
    if ((is_pressed || is_left) && !work->is_canceled) context.queue.cancel_work();
    end_dialog();
}

}  // namespace batten::ui
