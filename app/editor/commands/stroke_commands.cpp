#include "app/editor/commands/stroke_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/refusal.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/redraw.h"
#include "core/make/fit_stroke.h"

namespace batten::editor {

namespace {

// Of a stroke that draws a part anew, how far the part may be from it.
constexpr double tolerance_in_pixels = 0.5;

core::Result<core::Curve> shape_of(const std::vector<core::Point>& points, double pixel, int smoothness,
                                   bool may_close) {
    return core::fit_stroke(points, {.pixel = pixel, .smoothness = smoothness, .may_close = may_close});
}

core::Result<core::Approximation> redrawn(const core::Curve& curve, const std::vector<core::Point>& points,
                                          double pixel, int smoothness) {
    return shape_of(points, pixel, smoothness, false).and_then([&](const core::Curve& shape) {
        return core::redraw(curve, shape, tolerance_in_pixels * pixel);
    });
}

template <class Command>
DrawnStroke stroke_of(const Command& command) {
    return {.points = std::make_shared<const std::vector<core::Point>>(command.points),
            .pixel = command.pixel,
            .smoothness = command.smoothness};
}

Outcome<Edit> fit_stroke(const EditorState& state, const FitStroke& command) {
    auto curve = shape_of(command.points, command.pixel, command.smoothness, true);
    if (!curve) return refused(state, curve.error());
    Edit edit = with_curve(state, "stroke", *std::move(curve));
    edit.stroke = stroke_of(command);
    edit.stroke->curve = edit.document.active;
    return edit;
}

Outcome<Edit> redraw(const EditorState& state, const Redraw& command) {
    const auto found = redrawn(active_curve(state), command.points, command.pixel, command.smoothness);
    if (!found) return refused(state, found.error());
    Outcome<Edit> edit = edit_active(state, found->curve, Selection{});
    if (!edit) return edit;
    edit->stroke = stroke_of(command);
    edit->stroke->redraws = true;
    edit->stroke->curve = edit->document.active;
    return edit;
}

Outcome<Edit> refit_stroke(const EditorState& state, const RefitStroke& command) {
    const DrawnStroke& stroke = *state.stroke;
    core::Result<core::Curve> curve = stroke.redraws
                                          ? redrawn(*state.history.previous().curves[stroke.curve].curve,
                                                    *stroke.points, stroke.pixel, command.smoothness)
                                                .map([](const core::Approximation& found) { return found.curve; })
                                          : shape_of(*stroke.points, stroke.pixel, command.smoothness, true);
    if (!curve) return refused(state, curve.error());
    Edit edit{.document = state.history.present(), .selection = Selection{}};
    replace_curve(edit.document.curves[stroke.curve], std::make_shared<const core::Curve>(*std::move(curve)));
    edit.document.active = stroke.curve;
    edit.stroke = stroke;
    edit.stroke->smoothness = command.smoothness;
    edit.extends = true;
    return edit;
}

StepTexts texts_of_fit(const EditorState&, const FitStroke&, const core::Curve& curve) {
    const std::size_t count = curve.control_points().size();
    return {"Draw stroke", curve.is_periodic()
                               ? core::sentence("Drew a closed curve with {count} control points", {{"count", count}})
                               : core::sentence("Drew a curve with {count} control points", {{"count", count}})};
}

StepTexts texts_of_refit(const EditorState& state, const RefitStroke& command, const core::Curve& curve) {
    return {state.history.undo_label(),
            core::sentence(
                "Fitted the stroke with smoothness {smoothness}: {count} control points",
                {{"smoothness", core::shortest_text(command.smoothness)}, {"count", curve.control_points().size()}})};
}

int smoothness_of_next(const EditorState& state) {
    return state.view.smoothness;
}

std::optional<int> smoothness_of_last(const EditorState& state) {
    return no_stroke(state) ? std::nullopt : std::optional(state.stroke->smoothness);
}

template <class Command>
Field smoothness_field() {
    return field::count<&Command::smoothness>("smoothness", "from 0, truest to the hand, to 10, smoothest")
        .at_most(core::most_smoothness);
}

template <class Command>
std::vector<Field> stroke_fields() {
    return {field::positions<&Command::points>("coordinates", "x and y of each sample of the pen"),
            smoothness_field<Command>().template suggesting<smoothness_of_next>(),
            field::length<&Command::pixel>("pixel", "how large a pixel is, about which a hand errs").usually(1.0)};
}

}  // namespace

std::optional<Refusal> no_stroke(const EditorState& state) {
    const bool is_last_step = state.stroke && state.history.can_undo() &&
                              state.stroke->step == state.history.undo_count() &&
                              state.stroke->curve < state.history.present().curves.size();
    if (is_last_step) return std::nullopt;
    return "the last step is no stroke; draw one with the pencil first";
}

const CommandSpec& FitStroke::spec() {
    static const CommandSpec spec{
        .name = "fit-stroke",
        .title = "Fit curve to stroke",
        .explanation = "Adds the smooth curve that a hand meant with a stroke, without the noise of the hand.",
        .synonyms = "pencil freehand smooth approximate sketch",
        .group = CommandGroup::make,
        .submenu = "Near points",
        .fields = stroke_fields<FitStroke>(),
        .run = body_of<fit_stroke>,
        .at_work = "Fitting a curve to a stroke",
        .texts = texts_of<texts_of_fit>};
    return spec;
}

const CommandSpec& RefitStroke::spec() {
    static const CommandSpec spec{
        .name = "refit-stroke",
        .title = "Fit stroke again",
        .explanation = "Makes the curve of the last stroke smoother or truer to the hand, as the same step.",
        .synonyms = "pencil freehand smooth",
        .group = CommandGroup::make,
        .submenu = "Near points",
        .offered = in_the_window,
        .fields = {smoothness_field<RefitStroke>().beginning_with<smoothness_of_last>()},
        .refusal = no_stroke,
        .run = body_of<refit_stroke>,
        .texts = texts_of<texts_of_refit>};
    return spec;
}

const CommandSpec& Redraw::spec() {
    static const CommandSpec spec{
        .name = "redraw",
        .title = "Redraw part",
        .explanation =
            "Replaces the part of the curve between the ends of a stroke by it, joined smoothly to the rest.",
        .synonyms = "pencil freehand stroke",
        .group = CommandGroup::curve,
        .submenu = "Shape",
        .effect = ShapeEffect::changes,
        .fields = stroke_fields<Redraw>(),
        .refusal = no_editable_curve,
        .run = body_of<redraw>,
        .at_work = "Redrawing a part of the curve",
        .step = "Redraw part",
        .done = "Redrew a part"};
    return spec;
}

void add_stroke_commands(CommandTable& table) {
    add_all<FitStroke, RefitStroke, Redraw>(table);
}

}  // namespace batten::editor
