#include "app/editor/commands/brush_commands.h"

#include <utility>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/fairing_commands.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/edit/fair.h"

namespace batten::editor {

namespace {

template <BrushKind kind>
Outcome<void> use_brush(EditorState& state, const UseBrush<kind>&) {
    // What is held with another brush is given up.
    if (std::exchange(state.view.brush.kind, kind) != kind) ++state.tool_changes;
    take_tool(state, Tool::brush);
    return {};
}

template <BrushKind kind>
bool is_brush(const EditorState& state) {
    return state.tool == Tool::brush && state.view.brush.kind == kind;
}

template <BrushKind kind>
CommandSpec using_brush(const char* name, const char* title, const char* explanation) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = "tool brush sculpt proportional",
            .group = CommandGroup::curve,
            .submenu = "Brush",
            .offered = in_the_window,
            .is_checked = is_brush<kind>,
            .run = body_of<use_brush<kind>>};
}

Outcome<void> set_brush_size(EditorState& state, const SetBrushSize& command) {
    state.view.brush.radius = command.radius;
    return {};
}

double present_radius_of_brush(const EditorState& state) {
    return state.view.brush.radius;
}

std::optional<double> distance_of_last(const EditorState& state) {
    return no_faired_part(state) ? std::nullopt : std::optional(state.faired->distance);
}

Outcome<Edit> refair_part(const EditorState& state, const RefairPart& command) {
    const FairedPart& faired = *state.faired;
    const core::DocumentCurve& before = state.history.previous().curves[faired.curve];
    auto found = core::fair_part(*before.curve, faired.part, command.distance, state.progress, held_points(before));
    if (!found) return refused(state, found.error());
    Edit edit{.document = state.history.present(), .error = found->error, .faired = faired, .extends = true};
    replace_curve(edit.document.curves[faired.curve], std::make_shared<const core::Curve>(std::move(found->curve)));
    edit.faired->distance = command.distance;
    return edit;
}

StepTexts texts_of_refairing(const EditorState& state, const RefairPart& command) {
    return {state.history.undo_label(),
            core::sentence("Faired the part within {distance}",
                           {{"distance", length_words(units_of(state), command.distance)}})};
}

}  // namespace

double brush_distance(const EditorState& state) {
    if (state.view.brush.distance) return *state.view.brush.distance;
    return suggest::hundredth_of_size(state).value_or(1.0);
}

std::optional<Refusal> no_faired_part(const EditorState& state) {
    const bool is_last_step = state.faired && state.history.can_undo() &&
                              state.faired->step == state.history.undo_count() &&
                              state.faired->curve < state.history.present().curves.size();
    if (is_last_step) return std::nullopt;
    return "the last step faired no part; paint over one with the fairing brush first";
}

template <>
const CommandSpec& UseBrush<BrushKind::soft_move>::spec() {
    static const CommandSpec spec = using_brush<BrushKind::soft_move>(
        "brush-soft-move", "Soft move", "Moves the control points within the brush, the less the farther they are.");
    return spec;
}

template <>
const CommandSpec& UseBrush<BrushKind::fair>::spec() {
    static const CommandSpec spec = using_brush<BrushKind::fair>(
        "brush-fair", "Fairing brush", "Makes the curvature vary less in the part that is painted over.");
    return spec;
}

const CommandSpec& SetBrushSize::spec() {
    static const CommandSpec spec{.name = "set-brush-size",
                                  .title = "Set size of the brush",
                                  .explanation = "Sets the radius of the brush.",
                                  .group = CommandGroup::curve,
                                  .submenu = "Brush",
                                  .offered = in_the_window,
                                  .fields = {field::number<&SetBrushSize::radius>("radius", "in pixels, 4 to 2000")
                                                 .beginning_with<present_radius_of_brush>()
                                                 .at_least(brush_radii.lower)
                                                 .at_most(brush_radii.upper)},
                                  .run = body_of<set_brush_size>};
    return spec;
}

const CommandSpec& RefairPart::spec() {
    static const CommandSpec spec{
        .name = "refair-part",
        .title = "Fair part again",
        .explanation = "Fairs the part of the last step by another distance, as the same step.",
        .synonyms = "smooth brush",
        .group = CommandGroup::curve,
        .submenu = "Brush",
        .offered = in_the_window,
        .effect = ShapeEffect::changes,
        .fields = {field::length<&RefairPart::distance>("distance", "how far the curve may move, above 0")
                       .beginning_with<distance_of_last>()},
        .refusal = no_faired_part,
        .run = body_of<refair_part>,
        .texts = texts_of<texts_of_refairing>,
        .tells_smoothness = true};
    return spec;
}

const CommandSpec& use_brush_spec(BrushKind kind) {
    return kind == BrushKind::soft_move ? UseBrush<BrushKind::soft_move>::spec() : UseBrush<BrushKind::fair>::spec();
}

void add_brush_commands(CommandTable& table) {
    add_all<UseBrush<BrushKind::soft_move>, UseBrush<BrushKind::fair>, SetBrushSize, RefairPart>(table);
}

}  // namespace batten::editor
