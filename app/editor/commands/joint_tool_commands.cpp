#include "app/editor/commands/joint_tool_commands.h"

#include <array>
#include <utility>

#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"

namespace batten::editor {

namespace {

constexpr const char* joint_tool_menu = "Joint tool";

struct OperationText {
    JointOperation operation;
    const char* command;
    const char* title;
    const char* explanation;
};

constexpr std::array<OperationText, joint_operation_count> operation_texts = [] {
    using enum JointOperation;
    return std::array<OperationText, joint_operation_count>{{
        {join, "click-to-join", "Join two ends", "Makes one curve of two; the second end that is clicked moves."},
        {match, "click-to-match", "Match an end",
         "Changes the end that is clicked first so that it meets another curve."},
        {blend, "click-to-blend", "Blend between two ends", "Adds a curve between two ends that are clicked."},
        {fillet, "click-to-fillet", "Fillet", "Puts an arc between two sides of a corner that are clicked."},
        {chamfer, "click-to-chamfer", "Chamfer", "Cuts off the corner between two sides that are clicked."},
        {trim, "click-to-trim", "Trim", "Removes the part that is clicked, up to the next crossings."},
        {extend, "click-to-extend", "Extend to a curve", "Makes the end that is clicked first reach another curve."},
        {split, "click-to-split", "Split at crossings", "Cuts the curve that is clicked where others cross it."},
        {offset, "drag-to-offset", "Offset by dragging", "Drags an offset out of a curve, at a distance that is seen."},
    }};
}();

template <JointOperation operation>
Outcome<void> use_operation(EditorState& state, const UseJointTool<operation>&) {
    // What was picked for another operation is given up.
    if (std::exchange(state.view.joint.operation, operation) != operation) ++state.tool_changes;
    take_tool(state, Tool::joint);
    return {};
}

template <JointOperation operation>
bool is_operation(const EditorState& state) {
    return state.tool == Tool::joint && state.view.joint.operation == operation;
}

template <std::size_t index>
CommandSpec using_operation() {
    constexpr OperationText text = operation_texts[index];
    static_assert(text.operation == static_cast<JointOperation>(index));
    return {.name = text.command,
            .title = text.title,
            .explanation = text.explanation,
            .synonyms = "tool click joint",
            .group = CommandGroup::curve,
            .submenu = joint_tool_menu,
            .offered = in_the_window,
            .is_checked = is_operation<text.operation>,
            .run = body_of<use_operation<text.operation>>};
}

struct ContinuityText {
    const char* command;
    const char* title;
    const char* explanation;
};

constexpr std::array<ContinuityText, joint_continuity_count> continuity_texts{
    {{"joint-g0", "Points agree (G0)", "The joint tool makes the points agree."},
     {"joint-g1", "Directions agree (G1)", "The joint tool makes points and directions agree."},
     {"joint-g2", "Curvatures agree (G2)", "The joint tool makes points, directions and curvatures agree."},
     {"joint-g3", "Changes of curvature agree (G3)",
      "The joint tool makes points, directions, curvatures and their changes agree."}}};

template <core::GeometricContinuity continuity>
Outcome<void> use_continuity(EditorState& state, const UseJointContinuity<continuity>&) {
    state.view.joint.continuity = continuity;
    return {};
}

template <core::GeometricContinuity continuity>
bool is_continuity(const EditorState& state) {
    return state.view.joint.continuity == continuity;
}

template <std::size_t index>
CommandSpec using_continuity() {
    constexpr ContinuityText text = continuity_texts[index];
    constexpr auto continuity = static_cast<core::GeometricContinuity>(index);
    return {.name = text.command,
            .title = text.title,
            .explanation = text.explanation,
            .synonyms = "tool joint smooth",
            .group = CommandGroup::curve,
            .submenu = joint_tool_menu,
            .offered = in_the_window,
            .is_checked = is_continuity<continuity>,
            .run = body_of<use_continuity<continuity>>};
}

Outcome<void> set_continuity(EditorState& state, const SetJointContinuity& command) {
    state.view.joint.continuity = command.continuity;
    return {};
}

core::GeometricContinuity present_continuity(const EditorState& state) {
    return state.view.joint.continuity;
}

Outcome<void> set_radius(EditorState& state, const SetJointRadius& command) {
    state.view.joint.radius = command.radius;
    return {};
}

double present_radius(const EditorState& state) {
    return state.view.joint.radius.value_or(suggest::grid_step(state));
}

Outcome<void> set_offset(EditorState& state, const SetJointOffset& command) {
    state.view.joint.offsets_both_sides = command.both_sides;
    state.view.joint.corners = command.corners;
    state.view.joint.caps = command.caps;
    return {};
}

bool present_sides(const EditorState& state) {
    return state.view.joint.offsets_both_sides;
}

core::OffsetCorners present_corners(const EditorState& state) {
    return state.view.joint.corners;
}

core::OffsetCaps present_caps(const EditorState& state) {
    return state.view.joint.caps;
}

template <std::size_t... index>
std::array<CommandSpec, joint_operation_count> operation_specs(std::index_sequence<index...>) {
    return {using_operation<index>()...};
}

template <std::size_t... index>
std::array<CommandSpec, joint_continuity_count> continuity_specs(std::index_sequence<index...>) {
    return {using_continuity<index>()...};
}

}  // namespace

const CommandSpec& joint_operation_spec(JointOperation operation) {
    static const auto specs = operation_specs(std::make_index_sequence<joint_operation_count>());
    return specs[static_cast<std::size_t>(operation)];
}

const CommandSpec& joint_continuity_spec(core::GeometricContinuity continuity) {
    static const auto specs = continuity_specs(std::make_index_sequence<joint_continuity_count>());
    return specs[static_cast<std::size_t>(continuity)];
}

const CommandSpec& SetJointContinuity::spec() {
    static const CommandSpec spec{
        .name = "set-joint-continuity",
        .title = "Set continuity of the joint tool",
        .explanation = "Sets what the joint tool makes agree.",
        .group = CommandGroup::curve,
        .submenu = joint_tool_menu,
        .offered = {.menu = false, .scripts = false},
        .fields = {field::choice<&SetJointContinuity::continuity>("continuity", "what agrees at a joint")
                       .beginning_with<present_continuity>()},
        .run = body_of<set_continuity>};
    return spec;
}

const CommandSpec& SetJointRadius::spec() {
    static const CommandSpec spec{
        .name = "set-joint-radius",
        .title = "Set radius of the joint tool",
        .explanation = "Sets the radius of the joint tool's fillets and the distances of its chamfers.",
        .group = CommandGroup::curve,
        .submenu = joint_tool_menu,
        .offered = in_the_window,
        .fields =
            {field::length<&SetJointRadius::radius>("radius", "above 0").beginning_with<present_radius>().above(0.0)},
        .run = body_of<set_radius>};
    return spec;
}

const CommandSpec& SetJointOffset::spec() {
    static const CommandSpec spec{
        .name = "set-joint-offset",
        .title = "Set offsets of the joint tool",
        .explanation = "Sets on which sides the joint tool's offsets are, and what they have at corners and ends.",
        .group = CommandGroup::curve,
        .submenu = joint_tool_menu,
        .offered = in_the_window,
        .fields = {field::flag<&SetJointOffset::both_sides>("both sides", "yes for an offset on both sides")
                       .beginning_with<present_sides>(),
                   field::choice<&SetJointOffset::corners>("corners", "what goes around corners")
                       .beginning_with<present_corners>(),
                   field::choice<&SetJointOffset::caps>("caps",
                                                        "how both sides of an open curve are joined at its ends")
                       .beginning_with<present_caps>()},
        .run = body_of<set_offset>};
    return spec;
}

void add_joint_tool_commands(CommandTable& table) {
    for (std::size_t i = 0; i < joint_operation_count; ++i)
        table.emplace_back(joint_operation_spec(static_cast<JointOperation>(i)));
    for (std::size_t i = 0; i < joint_continuity_count; ++i)
        table.emplace_back(joint_continuity_spec(static_cast<core::GeometricContinuity>(i)));
    add_all<SetJointContinuity, SetJointRadius, SetJointOffset>(table);
}

}  // namespace batten::editor
