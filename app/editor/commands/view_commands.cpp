#include <cmath>

#include "app/editor/commands/groups.h"
#include "app/editor/fit_view.h"
#include "app/editor/formula.h"
#include "app/editor/user_scale.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr double zoom_factor = 1.25;
constexpr double scale_step = 0.1;
constexpr Modifiers ctrl{true, false, false};

Outcome<void> fit(EditorState& state, const Arguments&) {
    fit_view(state);
    return {};
}

Outcome<void> zoom_by(EditorState& state, double factor) {
    render::Camera& camera = state.view.camera;
    camera = render::zoomed(camera, factor, 0.5 * camera.size_px);
    return {};
}

template <Overlay overlay>
Outcome<void> toggle(EditorState& state, const Arguments&) {
    state.view.overlays.show(overlay, !state.view.overlays.is_shown(overlay));
    return {};
}

template <Overlay overlay>
void add_toggle(std::vector<CommandSpec>& table, const char* name, const char* title, const char* explanation,
                Key key = Key::none) {
    table.push_back({.name = name,
                     .title = title,
                     .explanation = explanation,
                     .group = CommandGroup::view,
                     .shortcut = {key, {}},
                     .is_checked = [](const EditorState& state) { return state.view.overlays.is_shown(overlay); },
                     .act = toggle<overlay>});
}

// A switch of the view that is a plain bool.
template <bool View::*member>
void add_switch(std::vector<CommandSpec>& table, const char* name, const char* title, const char* explanation,
                Key key) {
    table.push_back({.name = name,
                     .title = title,
                     .explanation = explanation,
                     .group = CommandGroup::view,
                     .shortcut = {key, {}},
                     .is_checked = [](const EditorState& state) { return state.view.*member; },
                     .act = [](EditorState& state, const Arguments&) -> Outcome<void> {
                         state.view.*member = !(state.view.*member);
                         return {};
                     }});
}

Outcome<void> toggle_theme(EditorState& state, const Arguments&) {
    state.view.theme = state.view.theme == ThemeName::dark ? ThemeName::light : ThemeName::dark;
    return {};
}

Outcome<void> set_theme(EditorState& state, const Arguments& arguments) {
    const std::optional<ThemeName> theme = core::value_named<ThemeName>(arguments.text(0));
    if (!theme) return tl::unexpected("there is no theme called '" + arguments.text(0) + "'; there are dark and light");
    state.view.theme = *theme;
    return {};
}

// To the next tenth, so that steps up and down meet again.
template <int direction>
Outcome<void> step_scale(EditorState& state, const Arguments&) {
    set_user_scale(state.view, std::round(state.view.user_scale / scale_step + direction) * scale_step);
    return {};
}

Outcome<void> reset_scale(EditorState& state, const Arguments&) {
    set_user_scale(state.view, 1.0);
    return {};
}

Outcome<void> set_scale(EditorState& state, const Arguments& arguments) {
    set_user_scale(state.view, arguments.number(0));
    return {};
}

Outcome<void> set_plot_range(EditorState& state, const Arguments& arguments) {
    const core::Interval range{arguments.number(0), arguments.number(1)};
    if (!(range.lower < range.upper))
        return tl::unexpected("the plot cannot show " + number_text(range.lower) + " to " + number_text(range.upper) +
                              "; the first must be less than the second");
    state.view.plot_range = range;
    return {};
}

Outcome<void> fit_plot(EditorState& state, const Arguments&) {
    state.view.plot_range.reset();
    return {};
}

Outcome<void> set_knot_move(EditorState& state, const Arguments& arguments) {
    const std::optional<core::KnotMove> move = core::value_named<core::KnotMove>(arguments.text(0));
    if (!move)
        return tl::unexpected("knots cannot be moved by '" + arguments.text(0) + "'; there are stop, push and snap");
    state.view.knot_move = *move;
    return {};
}

void add_camera(std::vector<CommandSpec>& table) {
    table.push_back({.name = "fit",
                     .title = "Fit",
                     .explanation = "Shows the whole document.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::f, {}},
                     .act = fit});
    table.push_back({.name = "zoom-in",
                     .title = "Zoom in",
                     .explanation = "Shows the middle of the canvas larger.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::plus, {}},
                     .act = [](EditorState& state, const Arguments&) { return zoom_by(state, zoom_factor); }});
    table.push_back({.name = "zoom-out",
                     .title = "Zoom out",
                     .explanation = "Shows more around the middle of the canvas.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::minus, {}},
                     .act = [](EditorState& state, const Arguments&) { return zoom_by(state, 1.0 / zoom_factor); }});
}

void add_overlays(std::vector<CommandSpec>& table) {
    add_toggle<Overlay::polygon>(table, "toggle-polygon", "Polygon", "Shows the control polygon and points.", Key::tab);
    add_toggle<Overlay::hull>(table, "toggle-hull", "Hull", "Shows the convex hull of the active span.", Key::h);
    add_toggle<Overlay::bezier_pieces>(table, "toggle-pieces", "Bézier pieces",
                                       "Shows the Bézier polygon of each span.", Key::b);
    add_toggle<Overlay::curvature_comb>(table, "toggle-comb", "Curvature comb", "Shows the curvature along the curve.",
                                        Key::c);
    add_toggle<Overlay::knots>(table, "toggle-knots", "Knots", "Shows the knots on the curve.");
    add_toggle<Overlay::hodograph>(table, "toggle-hodograph", "Hodograph", "Shows the derivative as a curve.");
    add_toggle<Overlay::labels>(table, "toggle-labels", "Labels", "Shows the names of points.", Key::l);
    add_toggle<Overlay::grid>(table, "toggle-grid", "Grid", "Shows the grid and its numbers.", Key::g);
    add_toggle<Overlay::construction>(table, "toggle-construction", "Construction",
                                      "Shows the de Boor construction at u.");
}

void add_interface(std::vector<CommandSpec>& table) {
    table.push_back({.name = "toggle-theme",
                     .title = "Dark or light theme",
                     .explanation = "Changes between the dark and the light theme.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::t, {}},
                     .act = toggle_theme});
    table.push_back({.name = "scale-up",
                     .title = "Larger interface",
                     .explanation = "Makes texts, lines and panels larger.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::plus, ctrl},
                     .act = step_scale<1>});
    table.push_back({.name = "scale-down",
                     .title = "Smaller interface",
                     .explanation = "Makes texts, lines and panels smaller.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::minus, ctrl},
                     .act = step_scale<-1>});
    table.push_back({.name = "scale-reset",
                     .title = "Usual size of interface",
                     .explanation = "Gives texts, lines and panels their usual size.",
                     .group = CommandGroup::view,
                     .shortcut = {Key::digit_0, ctrl},
                     .act = reset_scale});
    add_switch<&View::inspector_is_open>(table, "toggle-inspector", "Inspector",
                                         "Folds the inspector away, or unfolds it.", Key::f3);
    add_switch<&View::dock_is_open>(table, "toggle-dock", "Basis plot", "Folds the basis plot away, or unfolds it.",
                                    Key::f4);
    add_switch<&View::is_presenting>(table, "present", "Present", "Shows only the canvas and the basis plot.",
                                     Key::f11);
}

void add_settings(std::vector<CommandSpec>& table) {
    table.push_back({.name = "fit-plot",
                     .title = "Fit plot",
                     .explanation = "Shows all knots in the basis plot.",
                     .group = CommandGroup::view,
                     .act = fit_plot});
    table.push_back(
        {.name = "set-plot-range",
         .title = "Set range of plot",
         .explanation = "Shows these parameters in the basis plot.",
         .group = CommandGroup::gesture,
         .parameters = {{"lo", Kind::number, "the first parameter"}, {"hi", Kind::number, "the last parameter"}},
         .act = set_plot_range,
         .is_logged = false});
    table.push_back({.name = "set-knot-move",
                     .title = "Set how knots move",
                     .explanation = "Lets a dragged knot stop at its neighbours, push them along, or snap onto them.",
                     .group = CommandGroup::view,
                     .parameters = {{"mode", Kind::text, "stop, push or snap"}},
                     .act = set_knot_move});
    table.push_back({.name = "set-theme",
                     .title = "Set theme",
                     .explanation = "Takes the dark or the light theme.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"theme", Kind::text, "dark or light"}},
                     .act = set_theme,
                     .is_logged = false});
    table.push_back({.name = "set-user-scale",
                     .title = "Set size of interface",
                     .explanation = "Makes texts, lines and panels larger or smaller by a factor.",
                     .group = CommandGroup::gesture,
                     .parameters = {{"factor", Kind::number, "0.5 to 3"}},
                     .act = set_scale,
                     .is_logged = false});
}

}  // namespace

void add_view_commands(std::vector<CommandSpec>& table) {
    add_camera(table);
    add_overlays(table);
    add_interface(table);
    add_settings(table);
}

}  // namespace batten::editor
