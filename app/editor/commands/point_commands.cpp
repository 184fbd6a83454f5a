#include "app/editor/commands/point_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/map_selected.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/point_edit.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr const char* which_point = "the number of a control point, counted from 0";

Outcome<Edit> move_points(const EditorState& state, const MovePoints& command) {
    if (is_made_of_points(state) && are_all_points(state, ascending(command.points)))
        return map_active(state, core::translation(command.offset));
    const auto points = free_points(state, command.points);
    if (!points) return tl::unexpected(points.error());
    return edit_active(state, core::move_control_points(active_curve(state), *points, command.offset));
}

Outcome<Edit> set_point(const EditorState& state, const SetPoint& command) {
    if (const auto points = free_points(state, {command.index}); !points) return tl::unexpected(points.error());
    return edit_active(state, core::set_control_point(active_curve(state), command.index, command.position));
}

Outcome<Edit> soft_move(const EditorState& state, const SoftMove& command) {
    return edit_active(state, core::soft_move(active_curve(state), command.center, command.radius, command.offset,
                                              pinned_points(state)));
}

StepTexts texts_of_place(const EditorState& state, const SetPoint& command) {
    const core::Place point("point", point_text(command.index));
    return {sentence("Move {point}", {point}),
            sentence("Moved {point} from {from} to {to}",
                     {point,
                      {"from", place_words(units_of(state), active_curve(state).control_points()[command.index])},
                      {"to", place_words(units_of(state), command.position)}})};
}

Outcome<Edit> set_weight(const EditorState& state, const SetWeight& command) {
    return edit_active(state, core::set_weight(active_curve(state), command.index, command.weight));
}

StepTexts texts_of_weight(const EditorState& state, const SetWeight& command) {
    const core::Place point("point", point_text(command.index));
    return {sentence("Set weight of {point}", {point}),
            sentence("Set weight of {point} from {from} to {to}",
                     {point,
                      {"from", core::shortest_text(active_curve(state).weights()[command.index])},
                      {"to", core::shortest_text(command.weight)}})};
}

Outcome<Edit> add_point(const EditorState& state, const AddPoint& command) {
    return edit_active(state, core::add_control_point(active_curve(state), command.index, command.position),
                       Selection{{command.index}, {}});
}

Outcome<Edit> delete_points(const EditorState& state, const DeletePoints& command) {
    return without_points(state, ascending(command.points));
}

StepTexts texts_of_delete_points(const EditorState& state, const DeletePoints& command) {
    return texts_of_deleting(state, ascending(command.points));
}

std::optional<Refusal> nothing_to_nudge(const EditorState& state) {
    return state.selection.fit_point ? no_curve_at_hand(state) : nothing_to_map(state);
}

Outcome<Edit> nudged_fit_point(const EditorState& state, std::size_t index, core::Vector offset) {
    const core::FitPoints& fit = *state.history.present().active_curve()->fit;
    return with_fit_point_at(state, index, fit.points[index].place + offset);
}

Outcome<Edit> nudged_points(const EditorState& state, core::Vector offset) {
    if (state.selection.is_over_curves()) return map_selected(state, core::translation(offset));
    const auto points = free_points(state, state.selection.points);
    if (!points) return tl::unexpected(points.error());
    return edit_active(state, core::move_control_points(active_curve(state), *points, offset));
}

Outcome<Edit> nudge_by(const EditorState& state, core::Vector offset, bool continues) {
    Outcome<Edit> edit = state.selection.fit_point ? nudged_fit_point(state, *state.selection.fit_point, offset)
                                                   : nudged_points(state, offset);
    if (edit) edit->burst = burst_after(state, offset, continues);
    return edit;
}

StepTexts texts_of_nudge_by(const EditorState& state, core::Vector offset, bool continues) {
    const core::Vector total = burst_after(state, offset, continues).total;
    if (state.selection.fit_point) {
        const core::Place index("index", *state.selection.fit_point);
        return {sentence("Nudge fit point {index}", {index}),
                sentence("Nudged fit point {index} by {offset}",
                         {index, {"offset", place_words(units_of(state), core::tip_of(total))}})};
    }
    const core::Place points("points", selected_words(state));
    return {sentence("Nudge {points}", {points}),
            sentence("Nudged {points} by {offset}",
                     {points, {"offset", place_words(units_of(state), core::tip_of(total))}})};
}

Outcome<Edit> nudge(const EditorState& state, const Nudge& command) {
    return nudge_by(state, command.offset, false);
}

StepTexts texts_of_nudge(const EditorState& state, const Nudge& command) {
    return texts_of_nudge_by(state, command.offset, false);
}

template <class Command, int x, int y>
core::Vector offset_of(const Command& command) {
    return {x * command.distance, y * command.distance};
}

template <class Command, int x, int y>
Outcome<Edit> nudge_toward(const EditorState& state, const Command& command) {
    return nudge_by(state, offset_of<Command, x, y>(command), command.continues);
}

bool has_no_points_selected(const EditorState& state) {
    return !no_curve_at_hand(state) && state.selection.points.empty() && !state.selection.is_over_curves() &&
           !state.selection.fit_point;
}

template <class Command, int x, int y>
StepTexts texts_of_arrow(const EditorState& state, const Command& command) {
    return texts_of_nudge_by(state, offset_of<Command, x, y>(command), command.continues);
}

// What the arrow keys do. The distance is a field, so that a replay does not depend on the camera; so is what belongs
// to the step before, so that it does not depend on the clock.
template <class Command, int x, int y>
CommandSpec arrow(const char* name, const char* title, Shortcut shortcut) {
    const bool is_far = shortcut.modifiers.shift;
    Field distance = field::length<&Command::distance>("distance", "how far");
    return {.name = name,
            .title = title,
            .explanation = is_far ? "Moves what is selected by a step of the grid."
                                  : "Moves what is selected by a tenth of a step of the grid.",
            .group = CommandGroup::edit,
            .offered = {.menu = false, .scripts = false, .key_sheet = false},
            .effect = ShapeEffect::changes,
            .shortcut = shortcut,
            .fields = {(is_far ? std::move(distance).template suggesting<suggest::grid_step>()
                               : std::move(distance).template suggesting<suggest::tenth_of_grid_step>())
                           .unasked(),
                       field::flag<&Command::continues>("continues", "yes if it belongs to the step before")
                           .template suggesting<continues_burst>()
                           .unasked()},
            .refusal = nothing_to_nudge,
            .is_idle = has_no_points_selected,
            .run = body_of<nudge_toward<Command, x, y>>,
            .texts = texts_of<texts_of_arrow<Command, x, y>>};
}

std::optional<double> quarter_of_size(const EditorState& state) {
    return suggest::share_of_size(state, 0.25);
}

constexpr Modifiers shift{false, true, false};

}  // namespace

const CommandSpec& MovePoints::spec() {
    static const CommandSpec spec{
        .name = "move-points",
        .title = "Move points",
        .explanation = "Moves control points by an offset.",
        .synonyms = "shift translate",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::point_indices<&MovePoints::points>("indices", "which control points, counted from 0")
                       .beginning_with<suggest::selected_points>(),
                   field::vector<&MovePoints::offset>({"dx", "to the right"}, {"dy", "upwards"})},
        .refusal = no_editable_curve,
        .run = body_of<move_points>,
        .step = "Move {indices}",
        .done = "Moved {indices} by ({dx}, {dy})"};
    return spec;
}

const CommandSpec& SoftMove::spec() {
    static const CommandSpec spec{
        .name = "soft-move",
        .title = "Move points softly",
        .explanation = "Moves the control points around a place, the less the farther they are from it.",
        .synonyms = "proportional brush falloff",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::position<&SoftMove::center>({"x", "x of the place"}, {"y", "y of the place"}),
                   field::vector<&SoftMove::offset>({"dx", "to the right"}, {"dy", "upwards"}),
                   field::length<&SoftMove::radius>("radius", "from where on points stay, above 0")
                       .suggesting<quarter_of_size>()},
        .refusal = no_editable_curve,
        .run = body_of<soft_move>,
        .done = "Moved points around ({x}, {y}) by up to ({dx}, {dy})"};
    return spec;
}

const CommandSpec& SetPoint::spec() {
    static const CommandSpec spec{
        .name = "set-point",
        .title = "Set point",
        .explanation = "Moves a control point to a place.",
        .synonyms = "move",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields =
            {field::point_index<&SetPoint::index>("index", which_point).beginning_with<suggest::first_selected_point>(),
             field::position<&SetPoint::position>({"x", "its new x"}, {"y", "its new y"})},
        .refusal = no_editable_curve,
        .run = body_of<set_point>,
        .texts = texts_of<texts_of_place>};
    return spec;
}

const CommandSpec& SetWeight::spec() {
    static const CommandSpec spec{
        .name = "set-weight",
        .title = "Set weight",
        .explanation = "Sets the weight of a control point; a larger one pulls the curve toward the point.",
        .synonyms = "rational NURBS",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::point_index<&SetWeight::index>("index", which_point)
                       .beginning_with<suggest::first_selected_point>(),
                   field::number<&SetWeight::weight>("w", "its new weight, above 0")},
        .refusal = no_editable_curve,
        .run = body_of<set_weight>,
        .texts = texts_of<texts_of_weight>};
    return spec;
}

const CommandSpec& AddPoint::spec() {
    static const CommandSpec spec{
        .name = "add-point",
        .title = "Add point",
        .explanation = "Adds a control point, and with it a knot, before another one or at the end.",
        .synonyms = "insert",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::point_index<&AddPoint::index>("index", "the number that the new control point will have")
                       .or_one_more(),
                   field::position<&AddPoint::position>({"x", "its x"}, {"y", "its y"})},
        .refusal = no_editable_curve,
        .run = body_of<add_point>,
        .step = "Add {index}",
        .done = "Added {index} at ({x}, {y})"};
    return spec;
}

const CommandSpec& DeletePoints::spec() {
    static const CommandSpec spec{
        .name = "delete-points",
        .title = "Delete points",
        .explanation =
            "Deletes control points, and with each of them a knot; the curve where they are all of its points.",
        .synonyms = "remove",
        .group = CommandGroup::edit,
        .submenu = "Points",
        .effect = ShapeEffect::changes,
        .fields = {field::point_indices<&DeletePoints::points>("indices", "which control points, counted from 0")
                       .suggesting<suggest::selected_points>()},
        .refusal = no_editable_curve,
        .run = body_of<delete_points>,
        .texts = texts_of<texts_of_delete_points>};
    return spec;
}

const CommandSpec& Nudge::spec() {
    static const CommandSpec spec{.name = "nudge",
                                  .title = "Nudge",
                                  .explanation = "Moves what is selected, or the selected fit point, by an offset.",
                                  .synonyms = "move shift",
                                  .group = CommandGroup::edit,
                                  .offered = {.menu = false},
                                  .effect = ShapeEffect::changes,
                                  .fields = {field::vector<&Nudge::offset>({"dx", "to the right"}, {"dy", "upwards"})},
                                  .refusal = nothing_to_nudge,
                                  .is_idle = has_no_points_selected,
                                  .run = body_of<nudge>,
                                  .texts = texts_of<texts_of_nudge>};
    return spec;
}

const CommandSpec& NudgeLeft::spec() {
    static const CommandSpec spec = arrow<NudgeLeft, -1, 0>("nudge-left", "Nudge left", {Key::left, {}});
    return spec;
}

const CommandSpec& NudgeRight::spec() {
    static const CommandSpec spec = arrow<NudgeRight, 1, 0>("nudge-right", "Nudge right", {Key::right, {}});
    return spec;
}

const CommandSpec& NudgeUp::spec() {
    static const CommandSpec spec = arrow<NudgeUp, 0, 1>("nudge-up", "Nudge up", {Key::up, {}});
    return spec;
}

const CommandSpec& NudgeDown::spec() {
    static const CommandSpec spec = arrow<NudgeDown, 0, -1>("nudge-down", "Nudge down", {Key::down, {}});
    return spec;
}

const CommandSpec& NudgeLeftFar::spec() {
    static const CommandSpec spec =
        arrow<NudgeLeftFar, -1, 0>("nudge-left-far", "Nudge left by a grid step", {Key::left, shift});
    return spec;
}

const CommandSpec& NudgeRightFar::spec() {
    static const CommandSpec spec =
        arrow<NudgeRightFar, 1, 0>("nudge-right-far", "Nudge right by a grid step", {Key::right, shift});
    return spec;
}

const CommandSpec& NudgeUpFar::spec() {
    static const CommandSpec spec =
        arrow<NudgeUpFar, 0, 1>("nudge-up-far", "Nudge up by a grid step", {Key::up, shift});
    return spec;
}

const CommandSpec& NudgeDownFar::spec() {
    static const CommandSpec spec =
        arrow<NudgeDownFar, 0, -1>("nudge-down-far", "Nudge down by a grid step", {Key::down, shift});
    return spec;
}

void add_point_commands(CommandTable& table) {
    add_all<MovePoints, SoftMove, SetPoint, SetWeight, AddPoint, DeletePoints, Nudge>(table);
    add_all<NudgeLeft, NudgeRight, NudgeUp, NudgeDown, NudgeLeftFar, NudgeRightFar, NudgeUpFar, NudgeDownFar>(table);
}

}  // namespace batten::editor
