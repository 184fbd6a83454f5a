#include "app/editor/commands/view_commands.h"

#include <cmath>

#include "app/editor/commands/groups.h"
#include "app/editor/field_kinds.h"
#include "app/editor/fit_view.h"
#include "app/editor/user_scale.h"

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

template <Overlay overlay>
Outcome<void> toggle(EditorState& state, const ToggleOverlay<overlay>&) {
    state.view.overlays.show(overlay, !state.view.overlays.is_shown(overlay));
    return {};
}

template <Overlay overlay>
bool is_shown(const EditorState& state) {
    return state.view.overlays.is_shown(overlay);
}

template <Overlay overlay>
CommandSpec toggling(const char* name, const char* title, const char* explanation, const char* synonyms,
                     Key key = Key::none) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = synonyms,
            .group = CommandGroup::view,
            .offered = in_the_window,
            .shortcut = {key, {}},
            .is_checked = is_shown<overlay>,
            .run = body_of<toggle<overlay>>};
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

template <>
const CommandSpec& ToggleOverlay<Overlay::polygon>::spec() {
    static const CommandSpec spec = toggling<Overlay::polygon>(
        "toggle-polygon", "Polygon", "Shows the control polygon and points.", "overlay control points legs", Key::tab);
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::hull>::spec() {
    static const CommandSpec spec = toggling<Overlay::hull>(
        "toggle-hull", "Hull", "Shows the convex hull of the active span.", "overlay convex", Key::h);
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::bezier_pieces>::spec() {
    static const CommandSpec spec = toggling<Overlay::bezier_pieces>(
        "toggle-pieces", "Bézier pieces", "Shows the Bézier polygon of each span.", "overlay segments", Key::b);
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::curvature_comb>::spec() {
    static const CommandSpec spec = toggling<Overlay::curvature_comb>(
        "toggle-comb", "Curvature comb", "Shows the curvature along the curve.", "overlay porcupine", Key::c);
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::knots>::spec() {
    static const CommandSpec spec =
        toggling<Overlay::knots>("toggle-knots", "Knots", "Shows the knots on the curve.", "overlay diamonds");
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::hodograph>::spec() {
    static const CommandSpec spec = toggling<Overlay::hodograph>(
        "toggle-hodograph", "Hodograph", "Shows the derivative as a curve.", "overlay velocity");
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::labels>::spec() {
    static const CommandSpec spec =
        toggling<Overlay::labels>("toggle-labels", "Labels", "Shows the names of points.", "overlay text", Key::l);
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::grid>::spec() {
    static const CommandSpec spec =
        toggling<Overlay::grid>("toggle-grid", "Grid", "Shows the grid and its numbers.", "overlay axes", Key::g);
    return spec;
}

template <>
const CommandSpec& ToggleOverlay<Overlay::construction>::spec() {
    static const CommandSpec spec = toggling<Overlay::construction>(
        "toggle-construction", "Construction", "Shows the de Boor construction at u.", "overlay Casteljau triangle");
    return spec;
}

const CommandSpec& toggle_overlay_spec(Overlay overlay) {
    switch (overlay) {
        case Overlay::polygon:
            return ToggleOverlay<Overlay::polygon>::spec();
        case Overlay::hull:
            return ToggleOverlay<Overlay::hull>::spec();
        case Overlay::bezier_pieces:
            return ToggleOverlay<Overlay::bezier_pieces>::spec();
        case Overlay::curvature_comb:
            return ToggleOverlay<Overlay::curvature_comb>::spec();
        case Overlay::knots:
            return ToggleOverlay<Overlay::knots>::spec();
        case Overlay::hodograph:
            return ToggleOverlay<Overlay::hodograph>::spec();
        case Overlay::labels:
            return ToggleOverlay<Overlay::labels>::spec();
        case Overlay::grid:
            return ToggleOverlay<Overlay::grid>::spec();
        case Overlay::construction:
            break;
    }
    return ToggleOverlay<Overlay::construction>::spec();
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
                                  .is_checked = is_on<&View::dock_is_open>,
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
    static const CommandSpec spec{.name = "present",
                                  .title = "Present",
                                  .explanation = "Shows only the canvas and the basis plot.",
                                  .synonyms = "projector full screen",
                                  .group = CommandGroup::view,
                                  .offered = in_the_window,
                                  .shortcut = {Key::f11, {}},
                                  .is_checked = is_on<&View::is_presenting>,
                                  .run = body_of<toggle_member<TogglePresenting, &View::is_presenting>>};
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
    for (std::size_t i = 0; i < overlay_count; ++i) table.emplace_back(toggle_overlay_spec(static_cast<Overlay>(i)));
    add_all<ToggleTheme, ScaleUp, ScaleDown, ResetScale, ToggleInspector, ToggleDock, ToggleTitle, TogglePresenting>(
        table);
    add_all<FitPlot, SetKnotMove>(table);
}

}  // namespace batten::editor
