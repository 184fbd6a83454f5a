#include "app/editor/commands/view_commands.h"

#include <cmath>

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/state/user_scale.h"

namespace batten::editor {

namespace {

constexpr double zoom_factor = 1.25;
constexpr double scale_step = 0.1;

Outcome<void> fit(EditorState& state, const FitView&) {
    fit_view(state);
    return {};
}

Outcome<void> zoom_by(EditorState& state, double factor) {
    render::Camera& camera = state.view.camera;
    camera = render::zoomed(camera, factor, 0.5 * camera.size_px);
    return {};
}

Outcome<void> zoom_in(EditorState& state, const ZoomIn&) {
    return zoom_by(state, zoom_factor);
}

Outcome<void> zoom_out(EditorState& state, const ZoomOut&) {
    return zoom_by(state, 1.0 / zoom_factor);
}

Outcome<void> toggle_theme(EditorState& state, const ToggleTheme&) {
    state.view.theme = state.view.theme == ThemeName::dark ? ThemeName::light : ThemeName::dark;
    return {};
}

// To the next tenth, so that steps up and down meet again.
template <class Command, int direction>
Outcome<void> step_scale(EditorState& state, const Command&) {
    set_user_scale(state.view, std::round(state.view.user_scale / scale_step + direction) * scale_step);
    return {};
}

Outcome<void> reset_scale(EditorState& state, const ResetScale&) {
    set_user_scale(state.view, 1.0);
    return {};
}

// A switch of the view that is a plain bool.
template <class Command, bool View::*member>
Outcome<void> toggle_member(EditorState& state, const Command&) {
    state.view.*member = !(state.view.*member);
    return {};
}

template <bool View::*member>
bool is_on(const EditorState& state) {
    return state.view.*member;
}

// Everything is fitted anew into the canvas that is there then.
Outcome<void> toggle_presenting(EditorState& state, const TogglePresenting&) {
    state.view.is_presenting = !state.view.is_presenting;
    state.view.fits_on_open = true;
    return {};
}

// The plot makes room for the canvas, and a fitted picture is fitted into it.
Outcome<void> toggle_drawing(EditorState& state, const ToggleDrawing&) {
    Overlays& overlays = state.view.overlays;
    overlays.set_drawing(!overlays.is_drawing());
    return {};
}

bool is_drawing(const EditorState& state) {
    return state.view.overlays.is_drawing();
}

std::optional<Refusal> dock_is_hidden(const EditorState& state) {
    if (!is_drawing(state)) return std::nullopt;
    return "the drawing mode hides the plot; end the drawing mode to see it";
}

bool is_dock_shown(const EditorState& state) {
    return shows_dock(state.view);
}

Outcome<void> fit_plot(EditorState& state, const FitPlot&) {
    state.view.plot_range.reset();
    return {};
}

Outcome<void> set_knot_move(EditorState& state, const SetKnotMove& command) {
    state.view.knot_move = command.mode;
    return {};
}

core::KnotMove shown_knot_move(const EditorState& state) {
    return state.view.knot_move;
}

Outcome<void> set_notation(EditorState& state, const SetNotation& command) {
    state.view.notation = {command.points, command.parameter, command.degree, command.triangles, command.numbers};
    state.view.usual_notation = state.view.notation;
    return {};
}

template <auto member>
auto shown_notation(const EditorState& state) {
    return state.view.notation.*member;
}

std::optional<Refusal> no_title(const EditorState& state) {
    const core::Document& document = state.shown();
    if (!document.title.empty() || !document.description.empty()) return std::nullopt;
    return "the document has neither a title nor a description";
}

}  // namespace

const CommandSpec& FitView::spec() {
    static const CommandSpec spec{.name = "fit",
                                  .title = "Fit",
                                  .explanation = "Shows the whole document.",
                                  .synonyms = "zoom all",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::f, {}},
                                  .run = body_of<fit>};
    return spec;
}

const CommandSpec& ZoomIn::spec() {
    static const CommandSpec spec{.name = "zoom-in",
                                  .title = "Zoom in",
                                  .explanation = "Zooms in on the middle of the canvas.",
                                  .synonyms = "enlarge",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::plus, {}},
                                  .run = body_of<zoom_in>};
    return spec;
}

const CommandSpec& ZoomOut::spec() {
    static const CommandSpec spec{.name = "zoom-out",
                                  .title = "Zoom out",
                                  .explanation = "Zooms out from the middle of the canvas.",
                                  .synonyms = "reduce",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::minus, {}},
                                  .run = body_of<zoom_out>};
    return spec;
}

const CommandSpec& ToggleDrawing::spec() {
    static const CommandSpec spec{.name = "drawing-mode",
                                  .title = "Drawing mode",
                                  .explanation =
                                      "Hides hull, construction, labels, knots and plot, and thins control "
                                      "points that are closer than 6 pixels.",
                                  .synonyms = "clean bare focus hide sketch",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::m, {}},
                                  .is_checked = is_drawing,
                                  .run = body_of<toggle_drawing>};
    return spec;
}

const CommandSpec& ToggleTheme::spec() {
    static const CommandSpec spec{.name = "toggle-theme",
                                  .title = "Dark or light theme",
                                  .explanation = "Switches between the dark and the light theme.",
                                  .synonyms = "colors night day",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::t, {}},
                                  .run = body_of<toggle_theme>};
    return spec;
}

const CommandSpec& ScaleUp::spec() {
    static const CommandSpec spec{.name = "scale-up",
                                  .title = "Larger interface",
                                  .explanation = "Makes texts, lines and panels larger.",
                                  .synonyms = "size font zoom",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::plus, with_ctrl},
                                  .run = body_of<step_scale<ScaleUp, 1>>};
    return spec;
}

const CommandSpec& ScaleDown::spec() {
    static const CommandSpec spec{.name = "scale-down",
                                  .title = "Smaller interface",
                                  .explanation = "Makes texts, lines and panels smaller.",
                                  .synonyms = "size font zoom",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::minus, with_ctrl},
                                  .run = body_of<step_scale<ScaleDown, -1>>};
    return spec;
}

const CommandSpec& ResetScale::spec() {
    static const CommandSpec spec{.name = "scale-reset",
                                  .title = "Default size of interface",
                                  .explanation = "Gives texts, lines and panels their default size.",
                                  .synonyms = "font zoom default",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::digit_0, with_ctrl},
                                  .run = body_of<reset_scale>};
    return spec;
}

const CommandSpec& ToggleInspector::spec() {
    static const CommandSpec spec{.name = "toggle-inspector",
                                  .title = "Inspector",
                                  .explanation = "Folds the inspector away, or unfolds it.",
                                  .synonyms = "panel sidebar",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::f3, {}},
                                  .is_checked = is_on<&View::inspector_is_open>,
                                  .run = body_of<toggle_member<ToggleInspector, &View::inspector_is_open>>};
    return spec;
}

const CommandSpec& ToggleDock::spec() {
    static const CommandSpec spec{.name = "toggle-dock",
                                  .title = "Basis plot",
                                  .explanation = "Folds the basis plot away, or unfolds it.",
                                  .synonyms = "panel functions",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::f4, {}},
                                  .refusal = dock_is_hidden,
                                  .is_checked = is_dock_shown,
                                  .run = body_of<toggle_member<ToggleDock, &View::dock_is_open>>};
    return spec;
}

const CommandSpec& ToggleTitle::spec() {
    static const CommandSpec spec{.name = "toggle-title",
                                  .title = "Title line",
                                  .explanation = "Shows or hides the document's title and sentence above the canvas.",
                                  .synonyms = "example description",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .refusal = no_title,
                                  .is_checked = is_on<&View::title_is_open>,
                                  .run = body_of<toggle_member<ToggleTitle, &View::title_is_open>>};
    return spec;
}

const CommandSpec& TogglePresenting::spec() {
    static const CommandSpec spec{
        .name = "present",
        .title = "Present",
        .explanation = "Shows canvas, cards and basis plot on the whole screen, larger, for a projector.",
        .synonyms = "projector full screen",
        .group = CommandGroup::view,
        .offered = in_the_window,
        .shortcut = {Key::f11, {}},
        .is_checked = is_on<&View::is_presenting>,
        .run = body_of<toggle_presenting>};
    return spec;
}

const CommandSpec& FitPlot::spec() {
    static const CommandSpec spec{.name = "fit-plot",
                                  .title = "Fit plot",
                                  .explanation = "Shows all knots in the basis plot.",
                                  .synonyms = "zoom",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .run = body_of<fit_plot>};
    return spec;
}

const CommandSpec& ToggleKeys::spec() {
    static const CommandSpec spec{.name = "toggle-keys",
                                  .title = "Pressed keys",
                                  .explanation = "Shows the keys that are pressed, while presenting.",
                                  .synonyms = "projector shortcut",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::f2, {}},
                                  .is_checked = is_on<&View::keys_are_shown>,
                                  .run = body_of<toggle_member<ToggleKeys, &View::keys_are_shown>>};
    return spec;
}

const CommandSpec& SetNotation::spec() {
    static const CommandSpec spec{
        .name = "set-notation",
        .title = "Notation",
        .explanation = "Chooses the letters of points and parameter, degree or order, and fractions or decimals.",
        .synonyms = "letters symbols order fractions lecture",
        .group = CommandGroup::view,
        .offered = in_the_window,
        .fields = {field::choice<&SetNotation::points>("points", "the letter of control points")
                       .beginning_with<shown_notation<&Notation::points>>(),
                   field::choice<&SetNotation::parameter>("parameter", "the letter of the parameter")
                       .beginning_with<shown_notation<&Notation::parameter>>(),
                   field::choice<&SetNotation::degree>("degree", "whether the order stands beside the degree")
                       .beginning_with<shown_notation<&Notation::degree>>(),
                   field::choice<&SetNotation::triangles>("triangles", "which parent gives a point its number")
                       .beginning_with<shown_notation<&Notation::triangles>>(),
                   field::choice<&SetNotation::numbers>("numbers", "how exact numbers are written")
                       .beginning_with<shown_notation<&Notation::numbers>>()},
        .run = body_of<set_notation>};
    return spec;
}

const CommandSpec& SetKnotMove::spec() {
    static const CommandSpec spec{
        .name = "set-knot-move",
        .title = "Set how knots move",
        .explanation = "Lets a dragged knot stop at its neighbors, push them along, or snap onto them.",
        .synonyms = "drag mode",
        .group = CommandGroup::view,
        .offered = in_the_window,
        .fields = {field::choice<&SetKnotMove::mode>("mode", "what a dragged knot does at its neighbors")
                       .beginning_with<shown_knot_move>()},
        .run = body_of<set_knot_move>};
    return spec;
}

void add_view_commands(CommandTable& table) {
    add_all<FitView, ZoomIn, ZoomOut>(table);
    add_overlay_commands(table);
    add_all<ToggleDrawing, ToggleTheme, ScaleUp, ScaleDown, ResetScale, ToggleInspector, ToggleDock, ToggleTitle,
            TogglePresenting, ToggleKeys>(table);
    add_all<SetNotation, FitPlot, SetKnotMove>(table);
}

}  // namespace batten::editor
