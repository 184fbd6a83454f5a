#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/upkeep.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

Outcome<void> select_all(EditorState& state, const Arguments&) {
    std::vector<std::size_t> points(active_curve(state).control_points().size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    state.selection = {std::move(points), {}};
    return {};
}

Outcome<void> select_none(EditorState& state, const Arguments&) {
    state.selection = {};
    return {};
}

Refusal missing(const char* what, std::size_t index, std::size_t count) {
    return std::string("there is no ") + what + " " + std::to_string(index) + "; the last one is " +
           std::to_string(count - 1);
}

Outcome<void> select_points(EditorState& state, const Arguments& arguments) {
    Outcome<std::vector<std::size_t>> points = indices_of(arguments.numbers(0), "a control point");
    if (!points) return tl::unexpected(points.error());
    const std::size_t count = active_curve(state).control_points().size();
    if (!points->empty() && points->back() >= count)
        return tl::unexpected(missing("control point", points->back(), count));
    state.selection = {*std::move(points), {}};
    return {};
}

Outcome<void> select_knot(EditorState& state, const Arguments& arguments) {
    if (arguments.number(0) == -1.0) {
        state.selection.knot.reset();
        return {};
    }
    const Outcome<std::size_t> knot = index_of(arguments.number(0), "n");
    if (!knot) return tl::unexpected(knot.error());
    const std::size_t count = active_curve(state).knots().stored().size();
    if (*knot >= count) return tl::unexpected(missing("knot", *knot, count));
    state.selection = {{}, *knot};
    return {};
}

Outcome<void> activate_curve(EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = index_of(arguments.number(0), "n");
    if (!index) return tl::unexpected(index.error());
    const core::Document before = state.history.present();
    if (*index >= before.curves.size()) return tl::unexpected(missing("curve", *index, before.curves.size()));
    core::Document document = before;
    document.active = *index;
    state.history.amend(std::move(document));
    follow_document(state, before);
    return {};
}

}  // namespace

void add_selection_commands(std::vector<CommandSpec>& table) {
    table.push_back({.name = "select-all",
                     .title = "Select all points",
                     .explanation = "Selects all control points of the active curve.",
                     .group = CommandGroup::edit,
                     .shortcut = {Key::a, {true, false, false}},
                     .refusal = no_curve,
                     .act = select_all});
    table.push_back({.name = "select-none",
                     .title = "Select nothing",
                     .explanation = "Selects no control point and no knot.",
                     .group = CommandGroup::edit,
                     .act = select_none});
    table.push_back({.name = "select-points",
                     .title = "Select points",
                     .explanation = "Selects these control points and no other.",
                     .group = CommandGroup::edit,
                     .parameters = {{"points", Kind::numbers, "which control points, counted from 0"}},
                     .refusal = no_curve,
                     .act = select_points});
    table.push_back({.name = "select-knot",
                     .title = "Select knot",
                     .explanation = "Selects a knot, or none.",
                     .group = CommandGroup::edit,
                     .parameters = {{"n", Kind::number, "the number of a knot, counted from 0, or -1 for none"}},
                     .refusal = no_curve,
                     .act = select_knot});
    table.push_back({.name = "activate-curve",
                     .title = "Activate curve",
                     .explanation = "Makes a curve the one that edits go to.",
                     .group = CommandGroup::edit,
                     .parameters = {{"n", Kind::number, "the number of a curve, counted from 0"}},
                     .refusal = no_curve,
                     .act = activate_curve});
}

}  // namespace batten::editor
