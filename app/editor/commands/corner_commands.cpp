#include "app/editor/commands/corner_commands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/other_curve.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/nearest.h"
#include "core/refine/corner_bridge.h"

namespace batten::editor {

namespace {

// The two sides that were pointed at.
struct CornerSides {
    std::optional<std::size_t> other;  // none: both on the active curve
    core::PickedPlace first;
    core::PickedPlace second;
};

// The corner of the curve that is nearest by the parameter, over the seam of a closed one; `u` where it has none.
double nearest_corner(const core::Curve& curve, double u) {
    const double around = core::is_closed(curve) ? curve.domain().length() : std::numeric_limits<double>::infinity();
    const auto away = [&](double corner) { return std::min(std::abs(corner - u), around - std::abs(corner - u)); };
    std::optional<double> nearest;
    for (const core::JointContinuity& joint : core::joint_continuity(curve))
        if (joint.geometric < 1 && (!nearest || away(joint.u) < away(*nearest))) nearest = joint.u;
    return nearest.value_or(u);
}

CornerSides sides_of_active(const core::Curve& curve, double u, std::optional<double> other_u) {
    if (other_u) {
        const bool is_in_order = u <= *other_u || core::is_closed(curve);
        return {std::nullopt, {curve, is_in_order ? u : *other_u}, {curve, is_in_order ? *other_u : u}};
    }
    const double corner = nearest_corner(curve, u);
    return {std::nullopt, {curve, corner}, {curve, corner}};
}

template <class Command>
Outcome<CornerSides> sides_of(const EditorState& state, const Command& command) {
    const core::Curve& curve = active_curve(state);
    const double u = curve.knots().into_domain(command.u);
    const core::Document& document = state.history.present();
    if (!command.other || core::curve_meant_by(document, *command.other) == document.active) {
        const std::optional<double> other_u =
            command.other_u ? std::optional(curve.knots().into_domain(*command.other_u)) : std::nullopt;
        return sides_of_active(curve, u, other_u);
    }
    const Outcome<std::size_t> other = editable_other_curve(state, *command.other);
    if (!other) return tl::unexpected(other.error());
    const core::Curve& second = *document.curves[*other].curve;
    const double other_u = command.other_u ? second.knots().into_domain(*command.other_u)
                                           : core::nearest_point(second, core::point_at(curve, u)).u;
    return CornerSides{*other, {curve, u}, {second, other_u}};
}

void replace_by(core::DocumentCurve& entry, core::Curve curve) {
    replace_curve(entry, std::make_shared<const core::Curve>(std::move(curve)));
}

// Both curves cut back, with the bridge as a curve of its own.
Outcome<Edit> bridged_apart(const EditorState& state, const CornerSides& sides, const core::CornerBridge& bridge,
                            const char* name) {
    auto before = core::kept_part(sides.first.curve, bridge.kept_of_first, bridge.u);
    auto behind = core::kept_part(sides.second.curve, bridge.kept_of_second, bridge.v);
    if (!before || !behind) return refused(state, !before ? before.error() : behind.error());
    Edit edit = with_curve(state, name, bridge.bridge);
    replace_by(edit.document.curves[state.history.present().active], *std::move(before));
    replace_by(edit.document.curves[*sides.other], *std::move(behind));
    return edit;
}

Outcome<Edit> bridged(const EditorState& state, const CornerSides& sides,
                      const core::Result<core::CornerBridge>& bridge, bool is_joined, const char* name) {
    if (!bridge) return refused(state, bridge.error());
    if (!sides.other) return edit_active(state, core::with_corner_bridged(sides.first.curve, *bridge));
    if (!is_joined) return bridged_apart(state, sides, *bridge, name);
    const core::Document& document = state.history.present();
    auto joined = core::joined_by_bridge(sides.first.curve, sides.second.curve, *bridge);
    if (!joined)
        return tl::unexpected(
            refusal_of_ends(document.units, *document.active_curve(), document.curves[*sides.other], joined.error()));
    return with_one_for_several(state, *std::move(joined), {*sides.other});
}

Outcome<Edit> round_corner(const EditorState& state, const Fillet& command) {
    const Outcome<CornerSides> sides = sides_of(state, command);
    if (!sides) return tl::unexpected(sides.error());
    return bridged(state, *sides, core::fillet(sides->first, sides->second, command.radius), command.joined, "fillet");
}

Outcome<Edit> cut_corner(const EditorState& state, const Chamfer& command) {
    const Outcome<CornerSides> sides = sides_of(state, command);
    if (!sides) return tl::unexpected(sides.error());
    return bridged(state, *sides, core::chamfer(sides->first, sides->second, command.distance, command.other_distance),
                   command.joined, "chamfer");
}

template <class Command>
std::vector<Field> corner_fields(std::vector<Field> fields) {
    fields.push_back(field::parameter<&Command::u>("u", "where on the active curve, near the corner")
                         .template suggesting<suggest::current_parameter>());
    fields.push_back(field::curve_name<&Command::other>("other",
                                                        "name of the other curve; none for a corner of the "
                                                        "active one"));
    fields.push_back(field::number<&Command::other_u>("other u",
                                                      "where on the other side, the nearest place where it "
                                                      "is left out"));
    fields.push_back(field::flag<&Command::joined>("joined", "yes to make one curve of all").usually(true));
    return fields;
}

}  // namespace

const CommandSpec& Fillet::spec() {
    static const CommandSpec spec{
        .name = "fillet",
        .title = "Fillet",
        .explanation = "Rounds a corner of the active curve, or that between it and another one, by an exact arc.",
        .synonyms = "round corner arc radius",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .fields = corner_fields<Fillet>({field::length<&Fillet::radius>("radius", "of the arc, above 0")
                                             .above(0.0)
                                             .suggesting<suggest::grid_step>()}),
        .refusal = no_editable_curve,
        .run = body_of<round_corner>,
        .step = "Fillet of radius {radius}",
        .done = "Rounded a corner with radius {radius}"};
    return spec;
}

const CommandSpec& Chamfer::spec() {
    static const CommandSpec spec{
        .name = "chamfer",
        .title = "Chamfer",
        .explanation = "Cuts a corner off by a straight line, at distances along both sides.",
        .synonyms = "bevel corner",
        .group = CommandGroup::curve,
        .submenu = "Joints",
        .fields = corner_fields<Chamfer>(
            {field::length<&Chamfer::distance>("first", "distance from the corner, along the active curve")
                 .above(0.0)
                 .suggesting<suggest::grid_step>(),
             field::length<&Chamfer::other_distance>("second", "and along the other side")
                 .above(0.0)
                 .suggesting<suggest::grid_step>()}),
        .refusal = no_editable_curve,
        .run = body_of<cut_corner>,
        .step = "Chamfer {first} by {second}",
        .done = "Cut a corner off, {first} by {second}"};
    return spec;
}

void add_corner_commands(CommandTable& table) {
    add_all<Fillet, Chamfer>(table);
}

}  // namespace batten::editor
