#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/trace_commands.h"
#include "app/ui/command_entry.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/number_field.h"
#include "app/ui/section.h"

namespace batten::ui {
namespace {

constexpr double picture_icon_width = 26.0;
constexpr std::size_t most_pictures = 12;

void draw_title_row(const PanelContext& context, std::size_t i, const core::Picture& picture) {
    const float icons = 2.0F * context.px(picture_icon_width);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const std::string& problem = context.state.pictures.of(picture.path).problem;
    TextLine title;
    title.text = picture.path.filename().string();
    title.font = context.fonts.text;
    title.color = problem.empty() ? context.theme.text : context.theme.error;
    title.most_px = content_width(context) - icons - context.px(row_gap);
    title.is_typed = true;
    ImGui::Dummy(ImVec2(title.most_px, context.px(heading_height)));
    report_item(context, fmt::format("picture {} name", i), problem.empty() ? title.text : problem);
    show_typed_tooltip(context, problem.empty() ? picture.path.string() : problem);
    draw_text(context, ImVec2(origin.x, origin.y + 0.5F * context.px(heading_height)), title);
    stay_in_row(context);
    Button eye{fmt::format("picture {} visible", i), "", picture.visible ? Icon::eye : Icon::closed_eye,
               context.px(picture_icon_width)};
    eye.has_frame = false;
    eye.tooltip = picture.visible ? "Shown; click to hide" : "Hidden; click to show";
    if (draw_button(context, eye)) context.queue.run(editor::ShowPicture{.picture = i, .visible = !picture.visible});
    stay_in_row(context, 0.0);
    Button lock{fmt::format("picture {} locked", i), "", picture.locked ? Icon::lock : Icon::open_lock,
                context.px(picture_icon_width)};
    lock.has_frame = false;
    lock.tooltip = picture.locked ? "Locked in its place; click to unlock" : "Can be dragged; click to lock";
    if (draw_button(context, lock)) context.queue.run(editor::LockPicture{.picture = i, .locked = !picture.locked});
}

NumberField field_of(const PanelContext& context, std::size_t i, const char* name, double value) {
    NumberField field;
    field.name = fmt::format("picture {} {}", i, name);
    field.value = value;
    field.width_px = field_width(context);
    return field;
}

editor::PlacePicture placed(std::size_t i, const core::Picture& picture) {
    return {i, picture.position, picture.scale * picture.width, picture.rotation};
}

void draw_fields(const PanelContext& context, std::size_t i, const core::Picture& picture) {
    draw_row_label(context, "opacity");
    NumberField opacity = field_of(context, i, "opacity", picture.opacity);
    opacity.lowest = 0.0;
    opacity.highest = 1.0;
    draw_number_field(context, opacity,
                      [i](double value) { return editor::DimPicture{.picture = i, .opacity = value}; });
    const editor::Units& units = context.state.shown().units;
    draw_row_label(context, "width");
    NumberField width = field_of(context, i, "width", editor::in_units(units, picture.scale * picture.width));
    width.length = units;
    width.is_multiplicative = true;
    width.is_enabled = !picture.locked;
    width.tooltip = "How wide the picture is in the plane";
    draw_number_field(context, width, [&](double value) {
        editor::PlacePicture command = placed(i, picture);
        command.width = value * editor::world_per_length(units);
        return command;
    });
    draw_row_label(context, "rotation");
    NumberField rotation = field_of(context, i, "rotation", picture.rotation);
    rotation.speed = 0.25;
    rotation.unit = "°";
    rotation.is_enabled = !picture.locked;
    rotation.tooltip = "About the lower left corner, counterclockwise";
    draw_number_field(context, rotation, [&](double value) {
        editor::PlacePicture command = placed(i, picture);
        command.rotation = value;
        return command;
    });
}

/// Forms begin with the last picture, which is the only one most of the time; the others are one number away.
void draw_picture_buttons(const PanelContext& context, std::size_t i) {
    const float width = (content_width(context) - 2.0F * context.px(row_gap)) / 3.0F;
    draw_command_button(context, {fmt::format("picture {} measure", i), "scale…", Icon::none, width},
                        editor::MeasurePicture{.picture = i});
    stay_in_row(context);
    Button trace{fmt::format("picture {} trace", i), "trace…", Icon::none, width};
    trace.tooltip = editor::TracePicture::spec().explanation;
    if (draw_button(context, trace)) choose_command(context, editor::TracePicture::spec());
    stay_in_row(context);
    draw_command_button(context, {fmt::format("picture {} remove", i), "remove", Icon::none, width},
                        editor::RemovePicture{.picture = i});
}

}  // namespace

void draw_pictures_section(const PanelContext& context) {
    const std::vector<core::Picture>& pictures = context.state.shown().pictures;
    if (pictures.empty()) return;
    if (draw_section_heading(context, {"pictures", "Pictures", std::to_string(pictures.size())})) {
        for (std::size_t i = 0; i < std::min(pictures.size(), most_pictures); ++i) {
            draw_title_row(context, i, pictures[i]);
            draw_fields(context, i, pictures[i]);
            draw_picture_buttons(context, i);
        }
    }
    add_space(context, 6);
}

}  // namespace batten::ui
