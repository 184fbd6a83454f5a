#include "app/editor/commands/axis_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"
#include "core/document/symmetry.h"

namespace batten::editor {

namespace {

constexpr const char* axis_prompt = "Click two points of the axis · Escape gives up";
constexpr const char* center_prompt = "Click the center · Escape gives up";
constexpr std::size_t usual_count = 5;

Outcome<void> pick(EditorState& state, const AxisPick& wanted) {
    take_tool(state, Tool::select);
    state.axis_pick = wanted;
    state.message = {needs_axis(wanted.use) ? axis_prompt : center_prompt, false};
    return {};
}

Outcome<void> pick_mirror(EditorState& state, const PickMirror&) {
    return pick(state, {.use = AxisUse::mirror});
}

Outcome<void> pick_link_mirror(EditorState& state, const PickLinkMirror& command) {
    return pick(state, {.use = AxisUse::link_mirror, .is_smooth = command.is_smooth});
}

Outcome<void> pick_link_rotation(EditorState& state, const PickLinkRotation& command) {
    return pick(state, {.use = AxisUse::link_rotation, .count = command.count});
}

Outcome<void> pick_array_polar(EditorState& state, const PickArrayPolar& command) {
    return pick(state, {.use = AxisUse::array_polar, .count = command.count});
}

template <auto member>
Field count_field() {
    return field::count<member>("count", "how many there shall be, with the curve itself")
        .usually(usual_count)
        .at_least(2.0)
        .at_most(static_cast<double>(core::Symmetry::most_turns));
}

}  // namespace

const CommandSpec& PickMirror::spec() {
    static const CommandSpec spec{.name = "pick-mirror",
                                  .title = "Mirror in a line that is clicked",
                                  .explanation =
                                      "Mirrors selected points, or the curve, in the line through two "
                                      "places that are clicked.",
                                  .synonyms = "reflect flip axis transform",
                                  .group = CommandGroup::curve,
                                  .submenu = "Transform",
                                  .offered = in_the_window,
                                  .refusal = Mirror::spec().refusal,
                                  .run = body_of<pick_mirror>};
    return spec;
}

const CommandSpec& PickLinkMirror::spec() {
    static const CommandSpec spec{
        .name = "pick-link-mirror",
        .title = "Link to a mirror image by clicks",
        .explanation =
            "Adds the mirror image of the active curve in the line through two "
            "places that are clicked, linked to it.",
        .synonyms = "symmetry reflect live half axis",
        .group = CommandGroup::edit,
        .submenu = "Symmetry",
        .offered = in_the_window,
        .fields = {field::flag<&PickLinkMirror::is_smooth>("smooth", smooth_seam_meaning).usually(true)},
        .refusal = LinkMirror::spec().refusal,
        .run = body_of<pick_link_mirror>};
    return spec;
}

const CommandSpec& PickLinkRotation::spec() {
    static const CommandSpec spec{.name = "pick-link-rotation",
                                  .title = "Link to rotated images by a click",
                                  .explanation =
                                      "Adds images of the active curve around a center that is clicked, "
                                      "linked to it.",
                                  .synonyms = "symmetry rosette live radial center",
                                  .group = CommandGroup::edit,
                                  .submenu = "Symmetry",
                                  .offered = in_the_window,
                                  .fields = {count_field<&PickLinkRotation::count>()},
                                  .refusal = LinkRotation::spec().refusal,
                                  .run = body_of<pick_link_rotation>};
    return spec;
}

const CommandSpec& PickArrayPolar::spec() {
    static const CommandSpec spec{
        .name = "pick-array-polar",
        .title = "Array around a point that is clicked",
        .explanation =
            "Adds copies of the active curve, or of all that are selected, evenly around a center that is "
            "clicked.",
        .synonyms = "copies repeat pattern ring rotate center",
        .group = CommandGroup::edit,
        .submenu = "Arrange",
        .offered = in_the_window,
        .fields = {count_field<&PickArrayPolar::count>()},
        .refusal = no_curve,
        .run = body_of<pick_array_polar>};
    return spec;
}

void add_axis_commands(CommandTable& table) {
    add_all<PickMirror, PickLinkMirror, PickLinkRotation, PickArrayPolar>(table);
}

}  // namespace batten::editor
