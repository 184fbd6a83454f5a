#include "app/editor/commands/snap_commands.h"

#include <array>
#include <cmath>
#include <utility>

#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

/// What is said of a kind where it is switched.
struct SnapText {
    SnapKind kind;
    const char* command;
    const char* title;
    const char* explanation;
};

constexpr std::array<SnapText, snap_kind_count> snap_texts_of_kinds = [] {
    using enum SnapKind;
    return std::array<SnapText, snap_kind_count>{{
        {grid, "toggle-snap-grid", "Grid", "Puts what is dragged or drawn on the corners of the grid."},
        {guides, "toggle-snap-guides", "Guides", "Snaps to guides and where two of them cross."},
        {points, "toggle-snap-points", "Control points", "Snaps to the control points that are shown."},
        {knots, "toggle-snap-knots", "Knots", "Snaps to the places of knots on curves."},
        {ends, "toggle-snap-ends", "Ends", "Snaps to the ends of curves."},
        {midpoints, "toggle-snap-midpoints", "Midpoints", "Snaps to the middles of the legs of polygons."},
        {curve, "toggle-snap-curve", "Curves", "Snaps to the nearest place of a curve."},
        {perpendicular, "toggle-snap-perpendicular", "Perpendicular",
         "Snaps to where the line from the start of a gesture is perpendicular to a curve."},
        {tangent, "toggle-snap-tangent", "Tangent",
         "Snaps to where the line from the start of a gesture touches a curve."},
        {intersections, "toggle-snap-intersections", "Intersections",
         "Snaps to where curves cross, or one crosses itself."},
        {angles, "toggle-snap-angles", "Angles", "Snaps to steps of the angle from the start of a gesture."},
    }};
}();

template <SnapKind kind>
Outcome<void> toggle(EditorState& state, const ToggleSnap<kind>&) {
    SnapKinds& kinds = state.view.snap.kinds;
    kinds.set(kind, !kinds.has(kind));
    return {};
}

template <SnapKind kind>
bool snaps_to(const EditorState& state) {
    return state.view.snap.kinds.has(kind);
}

template <std::size_t index>
CommandSpec toggling_snap() {
    constexpr SnapText text = snap_texts_of_kinds[index];
    static_assert(text.kind == static_cast<SnapKind>(index));
    return {.name = text.command,
            .title = text.title,
            .explanation = text.explanation,
            .synonyms = "snap osnap magnet",
            .group = CommandGroup::view,
            .submenu = "Snapping",
            .offered = in_the_window,
            .is_checked = snaps_to<text.kind>,
            .run = body_of<toggle<text.kind>>};
}

template <std::size_t... index>
std::array<CommandSpec, snap_kind_count> all_snap_specs(std::index_sequence<index...>) {
    return {toggling_snap<index>()...};
}

Outcome<void> set_snap(EditorState& state, const SetSnap& command) {
    state.view.snap.kinds.set(command.kind, command.on);
    return {};
}

Outcome<void> set_angle_step(EditorState& state, const SetAngleStep& command) {
    state.view.snap.angle_step = command.degrees;
    return {};
}

double angle_step(const EditorState& state) {
    return state.view.snap.angle_step;
}

/// From 0 up to but not 180.
double direction_of_line(double degrees) {
    constexpr double half_turn = 180.0;
    const double angle = std::fmod(degrees, half_turn);
    const double turned = angle < 0.0 ? angle + half_turn : angle;
    return turned < half_turn ? turned + 0.0 : 0.0;
}

Outcome<Edit> add_guide(const EditorState& state, const AddGuide& command) {
    Edit edit{state.history.present()};
    edit.document.guides.push_back({command.position, direction_of_line(command.angle)});
    return edit;
}

Refusal no_such_guide(const EditorState& state) {
    return core::sentence("there is no such guide; the document has {count}",
                          {{"count", state.history.present().guides.size()}});
}

Outcome<Edit> move_guide(const EditorState& state, const MoveGuide& command) {
    Edit edit{state.history.present()};
    if (command.index >= edit.document.guides.size()) return tl::unexpected(no_such_guide(state));
    edit.document.guides[command.index].point = command.position;
    return edit;
}

Outcome<Edit> remove_guide(const EditorState& state, const RemoveGuide& command) {
    Edit edit{state.history.present()};
    auto& guides = edit.document.guides;
    if (command.index >= guides.size()) return tl::unexpected(no_such_guide(state));
    guides.erase(guides.begin() + static_cast<std::ptrdiff_t>(command.index));
    return edit;
}

Outcome<Edit> remove_guides(const EditorState& state, const RemoveGuides&) {
    Edit edit{state.history.present()};
    edit.document.guides.clear();
    return edit;
}

std::optional<Refusal> no_guides(const EditorState& state) {
    if (!state.history.present().guides.empty()) return std::nullopt;
    return "the document has no guides";
}

constexpr const char* snapping_menu = "Snapping";
constexpr const char* guides_menu = "Guides";

}  // namespace

const CommandSpec& toggle_snap_spec(SnapKind kind) {
    static const std::array<CommandSpec, snap_kind_count> specs =
        all_snap_specs(std::make_index_sequence<snap_kind_count>());
    return specs[static_cast<std::size_t>(kind)];
}

const CommandSpec& SetSnap::spec() {
    static const CommandSpec spec{.name = "set-snap",
                                  .title = "Set snapping",
                                  .explanation = "Switches a kind of things that the pointer snaps to on or off.",
                                  .synonyms = "osnap magnet",
                                  .group = CommandGroup::view,
                                  .submenu = snapping_menu,
                                  .offered = {.menu = false, .scripts = false},
                                  .fields = {field::choice<&SetSnap::kind>("kind", "what to snap to"),
                                             field::flag<&SetSnap::on>("on", "yes to snap to it").usually(true)},
                                  .run = body_of<set_snap>};
    return spec;
}

const CommandSpec& SetAngleStep::spec() {
    static const CommandSpec spec{.name = "set-angle-step",
                                  .title = "Set step of angles",
                                  .explanation = "Sets the step of the angles that the pointer snaps to.",
                                  .synonyms = "snap direction polar",
                                  .group = CommandGroup::view,
                                  .submenu = snapping_menu,
                                  .offered = in_the_window,
                                  .fields = {field::angle<&SetAngleStep::degrees>("degrees", "from 0.1 to 90")
                                                 .beginning_with<angle_step>()
                                                 .at_least(least_angle_step)
                                                 .at_most(greatest_angle_step)},
                                  .run = body_of<set_angle_step>};
    return spec;
}

const CommandSpec& AddGuide::spec() {
    static const CommandSpec spec{
        .name = "add-guide",
        .title = "Add guide",
        .explanation = "Adds an endless line to which the pointer snaps: 0 degrees for a level one, 90 for an upright.",
        .synonyms = "construction line ruler horizontal vertical",
        .group = CommandGroup::edit,
        .submenu = guides_menu,
        .fields = {field::position<&AddGuide::position>({"x", "x of a place on it"}, {"y", "y of a place on it"})
                       .suggesting<suggest::middle_of_view>(),
                   field::angle<&AddGuide::angle>("angle", "its direction in degrees").usually(0.0)},
        .run = body_of<add_guide>,
        .step = "Add guide",
        .done = "Added a guide"};
    return spec;
}

const CommandSpec& MoveGuide::spec() {
    static const CommandSpec spec{
        .name = "move-guide",
        .title = "Move guide",
        .explanation = "Moves a guide so that it passes another place.",
        .group = CommandGroup::edit,
        .submenu = guides_menu,
        .fields = {field::count<&MoveGuide::index>("guide", "which one, counted from 0").usually(0),
                   field::position<&MoveGuide::position>({"x", "x of a place on it"}, {"y", "y of a place on it"})
                       .suggesting<suggest::middle_of_view>()},
        .refusal = no_guides,
        .run = body_of<move_guide>,
        .step = "Move guide",
        .done = "Moved the guide"};
    return spec;
}

const CommandSpec& RemoveGuide::spec() {
    static const CommandSpec spec{
        .name = "remove-guide",
        .title = "Remove guide",
        .explanation = "Removes a guide.",
        .synonyms = "delete",
        .group = CommandGroup::edit,
        .submenu = guides_menu,
        .fields = {field::count<&RemoveGuide::index>("guide", "which one, counted from 0").usually(0)},
        .refusal = no_guides,
        .run = body_of<remove_guide>,
        .step = "Remove guide",
        .done = "Removed the guide"};
    return spec;
}

const CommandSpec& RemoveGuides::spec() {
    static const CommandSpec spec{.name = "remove-guides",
                                  .title = "Remove all guides",
                                  .explanation = "Removes all guides.",
                                  .synonyms = "delete clear",
                                  .group = CommandGroup::edit,
                                  .submenu = guides_menu,
                                  .refusal = no_guides,
                                  .run = body_of<remove_guides>,
                                  .step = "Remove all guides",
                                  .done = "Removed all guides"};
    return spec;
}

void add_snap_commands(CommandTable& table) {
    for (std::size_t i = 0; i < snap_kind_count; ++i) table.emplace_back(toggle_snap_spec(static_cast<SnapKind>(i)));
    add_all<SetSnap, SetAngleStep, AddGuide, MoveGuide, RemoveGuide, RemoveGuides>(table);
}

}  // namespace batten::editor
