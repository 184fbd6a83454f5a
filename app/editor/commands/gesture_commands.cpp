#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/hover_names.h"
#include "app/editor/fit_view.h"
#include "app/editor/upkeep.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr double least_picture_px = 1.0;
constexpr core::Interval interface_scales{0.1, 20.0};

Outcome<void> hover(EditorState& state, const Arguments& arguments) {
    Outcome<Hover> named = hover_named(arguments.text(0), arguments.numbers(1));
    if (!named) return tl::unexpected(named.error());
    if (!is_in(*named, state.shown())) return tl::unexpected("there is no such " + arguments.text(0));
    state.hover = *std::move(named);
    return {};
}

Outcome<void> pan_camera(EditorState& state, const Arguments& arguments) {
    state.view.camera = render::panned(state.view.camera, {arguments.number(0), arguments.number(1)});
    return {};
}

Outcome<void> zoom_camera(EditorState& state, const Arguments& arguments) {
    if (!(arguments.number(0) > 0.0)) return tl::unexpected(Refusal("the factor of a zoom must be above 0"));
    state.view.camera =
        render::zoomed(state.view.camera, arguments.number(0), {arguments.number(1), arguments.number(2)});
    return {};
}

Outcome<void> resize_canvas(EditorState& state, const Arguments& arguments) {
    state.view.camera.size_px = {std::max(arguments.number(0), least_picture_px),
                                 std::max(arguments.number(1), least_picture_px)};
    if (std::exchange(state.view.fits_on_open, false)) fit_view(state);
    return {};
}

Outcome<void> set_interface_scale(EditorState& state, const Arguments& arguments) {
    state.view.interface_scale = interface_scales.clamp(arguments.number(0));
    return {};
}

Outcome<void> set_inspector_width(EditorState& state, const Arguments& arguments) {
    state.view.inspector_width = inspector_widths.clamp(arguments.number(0));
    return {};
}

Outcome<void> set_dock_height(EditorState& state, const Arguments& arguments) {
    state.view.dock_height = dock_heights.clamp(arguments.number(0));
    return {};
}

std::optional<Argument> no_values(const EditorState&) {
    return std::vector<double>{};
}

void add_camera(std::vector<CommandSpec>& table) {
    table.push_back({.name = "pan-camera",
                     .title = "Pan",
                     .explanation = "Shifts the picture of the canvas.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"dx", Kind::number, "pixels to the right"}, {"dy", Kind::number, "pixels down"}},
                     .act = pan_camera,
                     .is_logged = false});
    table.push_back({.name = "zoom-camera",
                     .title = "Zoom",
                     .explanation = "Enlarges the picture of the canvas around a pixel.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"factor", Kind::number, "how much larger"},
                                    {"x", Kind::number, "pixels from the left"},
                                    {"y", Kind::number, "pixels from the top"}},
                     .act = zoom_camera,
                     .is_logged = false});
    table.push_back(
        {.name = "resize-canvas",
         .title = "Resize canvas",
         .explanation = "Tells how large the canvas is.",
         .group = CommandGroup::gesture,
         .parameters = {{"w", Kind::number, "its width in pixels"}, {"h", Kind::number, "its height in pixels"}},
         .act = resize_canvas,
         .is_logged = false});
}

void add_sizes(std::vector<CommandSpec>& table) {
    table.push_back({.name = "set-interface-scale",
                     .title = "Set scale of interface",
                     .explanation = "Tells how many pixels of the window make a design pixel.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"scale", Kind::number, "pixels for a design pixel"}},
                     .act = set_interface_scale,
                     .is_logged = false});
    table.push_back({.name = "set-inspector-width",
                     .title = "Set width of inspector",
                     .explanation = "Makes the inspector wider or narrower.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"width", Kind::number, "design pixels"}},
                     .act = set_inspector_width,
                     .is_logged = false});
    table.push_back({.name = "set-dock-height",
                     .title = "Set height of basis plot",
                     .explanation = "Makes the basis plot higher or lower.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"height", Kind::number, "design pixels"}},
                     .act = set_dock_height,
                     .is_logged = false});
}

}  // namespace

void add_gesture_commands(std::vector<CommandSpec>& table) {
    table.push_back({.name = "hover",
                     .title = "Hover",
                     .explanation = "Tells what is under the pointer.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"kind", Kind::text,
                                     "point, ring, knot, span, cell, parameter, curve, leg, other, basis or none"},
                                    {"values", Kind::numbers, "which of them", no_values}},
                     .act = hover,
                     .is_logged = false});
    add_camera(table);
    add_sizes(table);
}

}  // namespace batten::editor
