#include "app/editor/commands/group_commands.h"

#include <algorithm>
#include <set>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/selected_parts.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;
using Indices = std::vector<std::size_t>;

Refusal group_needs_name() {
    return "a group needs a name; the one given is empty";
}

Outcome<Edit> group_curves(const EditorState& state, const GroupCurves& command) {
    if (command.name.empty()) return tl::unexpected(group_needs_name());
    Edit edit{state.history.present()};
    for (const std::size_t i : command.curves) edit.document.curves[i].group = command.name;
    return edit;
}

Outcome<Edit> ungroup_curves(const EditorState& state, const UngroupCurves& command) {
    Edit edit{state.history.present()};
    for (const std::size_t i : command.curves) edit.document.curves[i].group.clear();
    return edit;
}

Outcome<Indices> curves_of_known_group(const core::Document& document, const std::string& group) {
    Indices curves = curves_of_group(document, group);
    if (curves.empty()) return tl::unexpected(sentence("there is no group '{group}'", {{"group", group}}));
    return curves;
}

Outcome<Edit> rename_group(const EditorState& state, const RenameGroup& command) {
    if (command.name.empty()) return tl::unexpected(group_needs_name());
    const core::Document& document = state.history.present();
    const auto curves = curves_of_known_group(document, command.group);
    if (!curves) return tl::unexpected(curves.error());
    if (command.name != command.group && !curves_of_group(document, command.name).empty())
        return tl::unexpected(
            sentence("there is a group '{name}' already; names must differ", {{"name", command.name}}));
    Edit edit{document};
    for (const std::size_t i : *curves) edit.document.curves[i].group = command.name;
    return edit;
}

// With what is selected, where curve i of the document goes to `places[i]` and the active one to `active`.
Selection moved_selection(const EditorState& state, const Indices& places, std::size_t active) {
    SelectedParts parts = selected_parts(state);
    for (SelectedPart& part : parts) part.curve = places[part.curve];
    std::ranges::sort(parts, {}, &SelectedPart::curve);
    Selection selection = selection_of(std::move(parts), active);
    selection.knot = state.selection.knot;
    selection.fit_point = state.selection.fit_point;
    selection.handlebar = state.selection.handlebar;
    return selection;
}

// The curves in the order of these indices, which are all there are.
Edit reordered(const EditorState& state, const Indices& order) {
    const core::Document& before = state.history.present();
    Edit edit{before};
    Indices places(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        edit.document.curves[k] = before.curves[order[k]];
        places[order[k]] = k;
    }
    edit.document.active = places[before.active];
    edit.selection = moved_selection(state, places, edit.document.active);
    return edit;
}

Outcome<Edit> move_curve(const EditorState& state, const MoveCurve& command) {
    Indices order;
    for (std::size_t i = 0; i < state.history.present().curves.size(); ++i)
        if (i != command.from) order.push_back(i);
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(command.to), command.from);
    Edit edit = reordered(state, order);
    if (command.group) edit.document.curves[command.to].group = *command.group;
    return edit;
}

// The curves of the group come to stand together.
Outcome<Edit> move_group(const EditorState& state, const MoveGroup& command) {
    const core::Document& document = state.history.present();
    const auto members = curves_of_known_group(document, command.group);
    if (!members) return tl::unexpected(members.error());
    const std::size_t count = document.curves.size();
    const std::size_t before = command.before.value_or(count);
    Indices order;
    for (std::size_t i = 0; i <= count; ++i) {
        if (i == before) order.insert(order.end(), members->begin(), members->end());
        if (i < count && document.curves[i].group != command.group) order.push_back(i);
    }
    return reordered(state, order);
}

// What is meant, with all of their groups, as far as they are in one.
std::optional<Indices> grouped_curves_meant(const EditorState& state) {
    const auto meant = suggest::curves_meant(state);
    if (!meant) return std::nullopt;
    const core::Document& document = state.history.present();
    Indices found;
    for (const std::size_t i : with_groups(document, *meant))
        if (!document.curves[i].group.empty()) found.push_back(i);
    if (found.empty()) return std::nullopt;
    return found;
}

std::optional<Refusal> no_group(const EditorState& state) {
    for (const core::DocumentCurve& curve : state.history.present().curves)
        if (!curve.group.empty()) return std::nullopt;
    return "there is no group";
}

bool has_no_group(const EditorState& state) {
    return no_group(state).has_value();
}

std::string free_group_name(const EditorState& state) {
    std::set<std::string> used;
    for (const core::DocumentCurve& curve : state.history.present().curves) used.insert(curve.group);
    if (!used.contains("group")) return "group";
    for (std::size_t k = 2;; ++k) {
        std::string name = sentence("group {number}", {{"number", k}});
        if (!used.contains(name)) return name;
    }
}

std::optional<std::string> group_meant(const EditorState& state) {
    const auto curves = grouped_curves_meant(state);
    if (!curves) return std::nullopt;
    return state.history.present().curves[curves->front()].group;
}

}  // namespace

std::vector<std::size_t> curves_of_group(const core::Document& document, const std::string& group) {
    Indices found;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (!group.empty() && document.curves[i].group == group) found.push_back(i);
    return found;
}

const CommandSpec& GroupCurves::spec() {
    static const CommandSpec spec{
        .name = "group",
        .title = "Group",
        .explanation = "Puts curves into a group by its name: the selected ones, or else the active one.",
        .synonyms = "layer together",
        .group = CommandGroup::curve,
        .submenu = "Several curves",
        .shortcut = {Key::g, {true, false, false}},
        .fields = {field::text<&GroupCurves::name>("name", "of the group").suggesting<free_group_name>(),
                   field::curve_indices<&GroupCurves::curves>("curves", "which curves, counted from 0")
                       .suggesting<suggest::curves_meant>()},
        .refusal = no_curve,
        .run = body_of<group_curves>,
        .step = "Group '{name}'",
        .done = "Put {curves} into the group '{name}'"};
    return spec;
}

const CommandSpec& UngroupCurves::spec() {
    static const CommandSpec spec{
        .name = "ungroup",
        .title = "Ungroup",
        .explanation = "Takes curves out of their groups: all curves of the groups that are selected.",
        .group = CommandGroup::curve,
        .submenu = "Several curves",
        .shortcut = {Key::g, {true, true, false}},
        .fields = {field::curve_indices<&UngroupCurves::curves>("curves", "which curves, counted from 0")
                       .suggesting<grouped_curves_meant>()},
        .refusal = no_group,
        .is_idle = has_no_group,
        .run = body_of<ungroup_curves>,
        .step = "Ungroup {curves}",
        .done = "Took {curves} out of their groups"};
    return spec;
}

const CommandSpec& RenameGroup::spec() {
    static const CommandSpec spec{
        .name = "rename-group",
        .title = "Rename group",
        .explanation = "Gives a group another name.",
        .group = CommandGroup::curve,
        .submenu = "Several curves",
        .fields = {field::text<&RenameGroup::group>("group", "its present name").beginning_with<group_meant>(),
                   field::text<&RenameGroup::name>("name", "its new name")},
        .refusal = no_group,
        .run = body_of<rename_group>,
        .step = "Rename group '{group}'",
        .done = "Renamed group '{group}' to '{name}'"};
    return spec;
}

const CommandSpec& MoveCurve::spec() {
    static const CommandSpec spec{
        .name = "move-curve",
        .title = "Move curve in the list",
        .explanation = "Gives a curve another place among the curves; later ones are drawn above earlier ones.",
        .synonyms = "order arrange raise lower front back",
        .group = CommandGroup::curve,
        .submenu = "Several curves",
        .fields = {field::curve_index<&MoveCurve::from>("from", "which curve, counted from 0")
                       .beginning_with<suggest::active_curve>(),
                   field::curve_index<&MoveCurve::to>("to", "its new place, counted from 0"),
                   field::text<&MoveCurve::group>("group", "that it then is in; its own where this is left out")},
        .refusal = no_curve,
        .run = body_of<move_curve>,
        .step = "Move {from} in the list",
        .done = "Moved {from} in the list"};
    return spec;
}

const CommandSpec& MoveGroup::spec() {
    static const CommandSpec spec{
        .name = "move-group",
        .title = "Move group in the list",
        .explanation =
            "Gives all curves of a group another place among the curves, where they stand together; later "
            "curves are drawn above earlier ones.",
        .synonyms = "order arrange raise lower front back",
        .group = CommandGroup::curve,
        .submenu = "Several curves",
        .fields = {field::text<&MoveGroup::group>("group", "its name").beginning_with<group_meant>(),
                   field::curve_index<&MoveGroup::before>(
                       "before", "which curve then stands next, counted from 0; none where this is left out")},
        .refusal = no_group,
        .run = body_of<move_group>,
        .step = "Move group '{group}' in the list",
        .done = "Moved the group '{group}' in the list"};
    return spec;
}

void add_group_commands(CommandTable& table) {
    add_all<GroupCurves, UngroupCurves, RenameGroup, MoveCurve, MoveGroup>(table);
}

}  // namespace batten::editor
