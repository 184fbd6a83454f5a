#include "app/editor/commands/selection_commands.h"

#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/selected_parts.h"
#include "app/editor/upkeep.h"

namespace batten::editor {

namespace {

Outcome<void> select_all(EditorState& state, const SelectAll&) {
    if (state.selection.is_over_curves()) {
        SelectedParts parts = selected_parts(state);
        for (SelectedPart& part : parts) part.points.clear();
        state.selection = selection_of(std::move(parts), state.history.present().active);
        return {};
    }
    std::vector<std::size_t> points(active_curve(state).control_points().size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    state.selection = {std::move(points), {}};
    return {};
}

Outcome<void> select_none(EditorState& state, const SelectNone&) {
    state.selection = {};
    return {};
}

Outcome<void> select_points(EditorState& state, const SelectPoints& command) {
    state.selection = {ascending(command.points), {}};
    return {};
}

Outcome<void> select_knot(EditorState& state, const SelectKnot& command) {
    if (command.index)
        state.selection = {{}, command.index};
    else
        state.selection.knot.reset();
    return {};
}

Outcome<void> show_handlebar(EditorState& state, const ShowHandlebar& command) {
    state.selection = {.points = {}, .knot = {}, .handlebar = active_curve(state).knots().into_domain(command.u)};
    if (state.tool != Tool::select) take_tool(state, Tool::select);
    return {};
}

std::optional<Refusal> no_handlebar(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (is_made_of_points(state)) return "the curve is made of fit points; drag these, or make it an ordinary curve";
    return std::nullopt;
}

Outcome<void> activate_curve(EditorState& state, const ActivateCurve& command) {
    const core::Document before = state.history.present();
    core::Document document = before;
    document.active = command.index;
    state.history.amend(std::move(document));
    follow_document(state, before);
    return {};
}

}  // namespace

const CommandSpec& SelectAll::spec() {
    static const CommandSpec spec{.name = "select-all",
                                  .title = "Select all points",
                                  .explanation =
                                      "Selects all control points of the active curve, or all of the curves of which "
                                      "anything is selected.",
                                  .group = CommandGroup::edit,
                                  .shortcut = {Key::a, {true, false, false}},
                                  .refusal = no_curve,
                                  .run = body_of<select_all>};
    return spec;
}

const CommandSpec& SelectNone::spec() {
    static const CommandSpec spec{.name = "select-none",
                                  .title = "Select nothing",
                                  .explanation = "Selects no control point and no knot.",
                                  .synonyms = "deselect clear",
                                  .group = CommandGroup::edit,
                                  .run = body_of<select_none>};
    return spec;
}

const CommandSpec& SelectPoints::spec() {
    static const CommandSpec spec{
        .name = "select-points",
        .title = "Select points",
        .explanation = "Selects these control points and no others.",
        .group = CommandGroup::edit,
        .submenu = "Select",
        .fields = {field::point_indices<&SelectPoints::points>("points", "which control points, counted from 0")},
        .refusal = no_curve,
        .run = body_of<select_points>};
    return spec;
}

const CommandSpec& SelectKnot::spec() {
    static const CommandSpec spec{
        .name = "select-knot",
        .title = "Select knot",
        .explanation = "Selects a knot, or none.",
        .group = CommandGroup::edit,
        .submenu = "Select",
        .fields = {field::knot_index<&SelectKnot::index>("n", "the number of a knot, counted from 0, or none")
                       .absent_as("-1")
                       .required()},
        .refusal = no_curve,
        .run = body_of<select_knot>};
    return spec;
}

const CommandSpec& ShowHandlebar::spec() {
    static const CommandSpec spec{
        .name = "show-handlebar",
        .title = "Show handlebar",
        .explanation = "Holds the curve at u: the point there and both ends of its tangent can be dragged.",
        .synonyms = "tangent handle node drag",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .offered = in_the_window,
        .fields =
            {field::parameter<&ShowHandlebar::u>("u", "where, in the domain").suggesting<suggest::current_parameter>()},
        .refusal = no_handlebar,
        .run = body_of<show_handlebar>};
    return spec;
}

const CommandSpec& ActivateCurve::spec() {
    static const CommandSpec spec{
        .name = "activate-curve",
        .title = "Activate curve",
        .explanation = "Makes a curve the active one, which edits change.",
        .synonyms = "select switch",
        .group = CommandGroup::edit,
        .submenu = "Select",
        .fields = {field::curve_index<&ActivateCurve::index>("n", "which curve, counted from 0")},
        .refusal = no_curve,
        .run = body_of<activate_curve>};
    return spec;
}

void add_selection_commands(CommandTable& table) {
    add_all<SelectAll, SelectNone, SelectPoints, SelectKnot, ShowHandlebar, ActivateCurve>(table);
}

}  // namespace batten::editor
