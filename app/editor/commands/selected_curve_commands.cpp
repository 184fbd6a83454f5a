#include "app/editor/commands/selected_curve_commands.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/map_selected.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"

namespace batten::editor {

namespace {

using Indices = std::vector<std::size_t>;

constexpr const char* which_curves = "which curves, counted from 0";

void select(EditorState& state, SelectedParts parts) {
    state.selection = selection_of(std::move(parts), state.history.present().active);
}

Outcome<void> select_parts(EditorState& state, const SelectParts& command) {
    auto parts = parts_of_text(command.parts, state.history.present());
    if (!parts) return tl::unexpected(parts.error());
    select(state, *std::move(parts));
    return {};
}

SelectedParts wholes_of(const Indices& curves) {
    SelectedParts parts;
    for (const std::size_t i : curves) parts.push_back({i});
    return parts;
}

Indices all_indices(std::size_t count) {
    Indices indices(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
}

Indices all_selectable(const core::Document& document) {
    return selectable(document, all_indices(document.curves.size()));
}

Outcome<void> select_all_curves(EditorState& state, const SelectAllCurves&) {
    const Indices curves = all_selectable(state.history.present());
    if (curves.empty()) return tl::unexpected(Refusal("every curve is hidden or locked"));
    select(state, wholes_of(curves));
    return {};
}

// The points of these curves that are not selected.
SelectedParts with_other_points(const core::Document& document, const SelectedParts& parts) {
    SelectedParts others;
    for (const SelectedPart& part : parts) {
        const Indices all = all_indices(document.curves[part.curve].curve->control_points().size());
        SelectedPart other{part.curve};
        std::ranges::set_difference(all, part.points, std::back_inserter(other.points));
        if (!other.points.empty()) others.push_back(std::move(other));
    }
    return others;
}

Outcome<void> invert_selection(EditorState& state, const InvertSelection&) {
    const core::Document& document = state.history.present();
    SelectedParts parts = selected_parts(state);
    if (std::ranges::none_of(parts, &SelectedPart::is_whole)) {
        if (parts.empty() && can_be_selected(document.curves[document.active])) parts.push_back({document.active, {}});
        select(state, with_other_points(document, parts));
        return {};
    }
    SelectedParts others;
    for (const std::size_t i : all_selectable(document))
        if (part_of(parts, i) == nullptr) others.push_back({i});
    select(state, std::move(others));
    return {};
}

template <class Change>
Edit change_curves(const EditorState& state, const Indices& curves, Change change) {
    Edit edit{state.history.present()};
    for (const std::size_t i : curves) change(edit.document.curves[i]);
    return edit;
}

template <class Command, bool core::DocumentCurve::*member, bool value>
Outcome<Edit> set_flag(const EditorState& state, const Command& command) {
    return change_curves(state, command.curves, [](core::DocumentCurve& curve) { curve.*member = value; });
}

Outcome<Edit> color_curves(const EditorState& state, const ColorCurves& command) {
    return change_curves(state, command.curves, [&](core::DocumentCurve& curve) { curve.color = command.color; });
}

Outcome<Edit> delete_curves(const EditorState& state, const DeleteCurves& command) {
    return without_parts(state, wholes_of(ascending(command.curves)));
}

template <bool core::DocumentCurve::*member, bool value>
std::optional<Indices> curves_with(const EditorState& state) {
    const std::vector<core::DocumentCurve>& curves = state.history.present().curves;
    Indices found;
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (curves[i].*member == value) found.push_back(i);
    if (found.empty()) return std::nullopt;
    return found;
}

std::optional<Refusal> nothing_hidden(const EditorState& state) {
    if (curves_with<&core::DocumentCurve::visible, false>(state)) return std::nullopt;
    return "no curve is hidden";
}

std::optional<Refusal> nothing_locked(const EditorState& state) {
    if (curves_with<&core::DocumentCurve::locked, true>(state)) return std::nullopt;
    return "no curve is locked";
}

bool has_nothing_hidden(const EditorState& state) {
    return nothing_hidden(state).has_value();
}

bool has_nothing_locked(const EditorState& state) {
    return nothing_locked(state).has_value();
}

template <class Command>
Field curves_field() {
    return field::curve_indices<&Command::curves>("curves", which_curves);
}

template <class Command>
Field meant_curves_field() {
    return curves_field<Command>().template suggesting<suggest::curves_meant>();
}

// What the commands have in common.
CommandSpec several_spec(const char* name, const char* title, const char* explanation, std::vector<Field> fields) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .group = CommandGroup::curve,
            .submenu = "Several curves",
            .fields = std::move(fields),
            .refusal = no_curve};
}

}  // namespace

const CommandSpec& SelectParts::spec() {
    static const CommandSpec spec{
        .name = "select-parts",
        .title = "Select parts of curves",
        .explanation = "Selects curves, and control points of others, and nothing else.",
        .group = CommandGroup::edit,
        .submenu = "Select",
        .fields = {field::text<&SelectParts::parts>(
            "parts", "3 for curve 3, and 0:1,2,5-9 for points of curve 0; several with spaces between")},
        .refusal = no_curve,
        .run = body_of<select_parts>};
    return spec;
}

const CommandSpec& SelectAllCurves::spec() {
    static const CommandSpec spec{.name = "select-all-curves",
                                  .title = "Select all curves",
                                  .explanation = "Selects every curve that is visible and not locked, as a whole.",
                                  .group = CommandGroup::edit,
                                  .submenu = "Select",
                                  .shortcut = {Key::a, with_ctrl_shift},
                                  .refusal = no_curve,
                                  .run = body_of<select_all_curves>};
    return spec;
}

const CommandSpec& InvertSelection::spec() {
    static const CommandSpec spec{
        .name = "invert-selection",
        .title = "Invert selection",
        .explanation = "Selects the other curves where whole curves are selected, else the other control points.",
        .group = CommandGroup::edit,
        .submenu = "Select",
        .shortcut = {Key::i, with_ctrl},
        .refusal = no_curve,
        .run = body_of<invert_selection>};
    return spec;
}

const CommandSpec& HideCurves::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made =
            several_spec("hide-curves", "Hide", "Hides curves: the selected ones, or else the active one.",
                         {meant_curves_field<HideCurves>()});
        made.shortcut = {Key::h, with_ctrl};
        made.run = body_of<set_flag<HideCurves, &core::DocumentCurve::visible, false>>;
        made.step = "Hide {curves}";
        made.done = "Hid {curves}";
        return made;
    }();
    return spec;
}

const CommandSpec& ShowCurves::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made =
            several_spec("show-curves", "Show hidden", "Shows curves: all that are hidden.",
                         {curves_field<ShowCurves>().suggesting<curves_with<&core::DocumentCurve::visible, false>>()});
        made.shortcut = {Key::h, with_ctrl_shift};
        made.refusal = nothing_hidden;
        made.is_idle = has_nothing_hidden;
        made.run = body_of<set_flag<ShowCurves, &core::DocumentCurve::visible, true>>;
        made.step = "Show {curves}";
        made.done = "Showed {curves}";
        return made;
    }();
    return spec;
}

const CommandSpec& LockCurves::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made =
            several_spec("lock-curves", "Lock",
                         "Protects curves from changes of their shape: the selected ones, or else the active one.",
                         {meant_curves_field<LockCurves>()});
        made.synonyms = "protect";
        made.shortcut = {Key::l, with_ctrl};
        made.run = body_of<set_flag<LockCurves, &core::DocumentCurve::locked, true>>;
        made.step = "Lock {curves}";
        made.done = "Locked {curves}";
        return made;
    }();
    return spec;
}

const CommandSpec& UnlockCurves::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made =
            several_spec("unlock-curves", "Unlock", "Allows changes of curves again: of all that are locked.",
                         {curves_field<UnlockCurves>().suggesting<curves_with<&core::DocumentCurve::locked, true>>()});
        made.shortcut = {Key::l, with_ctrl_shift};
        made.refusal = nothing_locked;
        made.is_idle = has_nothing_locked;
        made.run = body_of<set_flag<UnlockCurves, &core::DocumentCurve::locked, false>>;
        made.step = "Unlock {curves}";
        made.done = "Unlocked {curves}";
        return made;
    }();
    return spec;
}

const CommandSpec& ColorCurves::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made =
            several_spec("color-curves", "Color",
                         "Gives curves a color, or the default one: the selected ones, or else the active one.",
                         {field::color<&ColorCurves::color>("color", "of the form #4c7fe0, or none").required(),
                          meant_curves_field<ColorCurves>()});
        made.run = body_of<color_curves>;
        made.step = "Set color of {curves}";
        made.done = "Set color of {curves}";
        return made;
    }();
    return spec;
}

const CommandSpec& DeleteCurves::spec() {
    static const CommandSpec spec = [] {
        CommandSpec made = several_spec("delete-curves", "Delete curves",
                                        "Removes curves from the document: the selected ones, or else the active one.",
                                        {meant_curves_field<DeleteCurves>()});
        made.synonyms = "remove";
        made.run = body_of<delete_curves>;
        made.step = "Delete {curves}";
        made.done = "Deleted {curves}";
        return made;
    }();
    return spec;
}

void add_selected_curve_commands(CommandTable& table) {
    add_all<SelectParts, SelectAllCurves, InvertSelection>(table);
    add_all<HideCurves, ShowCurves, LockCurves, UnlockCurves, ColorCurves, DeleteCurves>(table);
}

}  // namespace batten::editor
