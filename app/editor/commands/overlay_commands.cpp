#include "app/editor/commands/overlay_commands.h"

#include <array>
#include <utility>

#include "app/editor/commands/groups.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/state/state.h"

namespace batten::editor {

namespace {

/// What is said of an overlay where it is offered.
struct OverlayText {
    Overlay overlay;
    const char* command;
    const char* title;
    const char* explanation;
    const char* synonyms;
    Key key = Key::none;
    const char* submenu = nullptr;  ///< of the menu Watch, by the chapters of a lecture; null: not a teaching view
};

constexpr const char* construction_views = "Construction";
constexpr const char* insertion_views = "Knot insertion";
constexpr const char* basis_views = "Basis functions";
constexpr const char* shape_views = "Shape";
constexpr const char* cubic_views = "Uniform cubics";
constexpr const char* weight_views = "Weights";
constexpr const char* question_views = "Questions";

constexpr std::array<OverlayText, overlay_count> texts = [] {
    using enum Overlay;
    return std::array<OverlayText, overlay_count>{{
        {polygon, "toggle-polygon", "Polygon", "Shows the control polygon and points.", "overlay control points legs",
         Key::tab},
        {hull, "toggle-hull", "Hull", "Shows the convex hull of the active span.", "overlay convex", Key::h},
        {bezier_pieces, "toggle-pieces", "Bézier pieces", "Shows the Bézier polygon of each span.", "overlay segments",
         Key::b},
        {curvature_comb, "toggle-comb", "Curvature comb", "Shows the curvature along the curve.", "overlay porcupine",
         Key::c},
        {knots, "toggle-knots", "Knots", "Shows the knots on the curve.", "overlay diamonds"},
        {hodograph, "toggle-hodograph", "Hodograph", "Shows the derivative as a curve.", "overlay velocity"},
        {labels, "toggle-labels", "Labels", "Shows the names of points.", "overlay text", Key::l},
        {grid, "toggle-grid", "Grid", "Shows the grid and its numbers.", "overlay axes", Key::g},
        {construction, "toggle-construction", "Construction", "Shows the de Boor construction at u.",
         "overlay Casteljau triangle"},
        {fill, "toggle-fill", "Filled", "Fills what the closed curves enclose; curves of one color are one shape.",
         "overlay area inside non-zero outline"},
        {even_odd_fill, "toggle-even-odd-fill", "Filled, even-odd",
         "Fills what the closed curves enclose an odd number of times.", "overlay area inside holes outline"},
        {directions, "toggle-directions", "Directions", "Shows the directions of the curves as arrows along them.",
         "overlay arrows orientation"},
        {rulers, "toggle-rulers", "Rulers",
         "Shows rulers at the upper and the left edge of the canvas, in the document's unit.",
         "overlay scale measure mm inch guides"},
        {triangle, "toggle-triangle", "Triangle",
         "Shows the triangle of de Boor or de Casteljau with the line that makes each point.", "view scheme algorithm",
         Key::none, construction_views},
        {halves, "toggle-halves", "Two halves",
         "Shows the two curves into which u splits the curve, each with its polygon.", "view split subdivide",
         Key::none, construction_views},
        {by_insertion, "toggle-by-insertion", "Point by insertion",
         "Shows how inserting u p times leads to the point C(u).", "view Boehm multiplicity", Key::none,
         construction_views},
        {blossoms, "toggle-blossoms", "Blossoms",
         "Names control points and construction points by their blossom values.", "view polar form labels", Key::none,
         construction_views},
        {corner_cutting, "toggle-corner-cutting", "Corner cutting",
         "Shows how inserting the knot u cuts the corners of the polygon.", "view Boehm insertion", Key::none,
         insertion_views},
        {polygon_distance, "toggle-polygon-distance", "Polygon and curve",
         "Shows how far the control polygon is from the curve, and how midpoint knots bring it nearer.",
         "view convergence refinement distance", Key::none, insertion_views},
        {bezier_points, "toggle-bezier-points", "Bézier points",
         "Names the Bézier points of each piece and tells which are control points already.", "view labels pieces",
         Key::none, insertion_views},
        {recurrence, "toggle-recurrence", "Recurrence",
         "Shows how the basis functions are blended from those of lower degree.", "view Cox de Boor triangle",
         Key::none, basis_views},
        {basis_pieces, "toggle-basis-pieces", "Polynomials", "Shows the polynomials of which a basis function is made.",
         "view power form coefficients", Key::none, basis_views},
        {basis_values, "toggle-basis-values", "Values and sum",
         "Shows the values of the basis functions at u and their sum.", "view partition of unity stacked areas",
         Key::none, basis_views},
        {rational_basis, "toggle-rational-basis", "Rational basis",
         "Shows the rational basis functions beside the polynomial ones.", "view weights R", Key::none, basis_views},
        {basis_derivatives, "toggle-basis-derivatives", "Derivatives of the basis",
         "Shows the derivatives of the basis functions.", "view slope", Key::none, basis_views},
        {continuity, "toggle-continuity", "Continuity", "Shows what each knot does to the smoothness of the curve.",
         "view meter smoothness C1 G1 jump", Key::none, shape_views},
        {curvature_plot, "toggle-curvature-plot", "Curvature plot",
         "Shows the curvature along the parameter below the basis plot.", "view kappa graph", Key::none, shape_views},
        {speed_plot, "toggle-speed-plot", "Speed plot", "Shows the speed along the parameter below the basis plot.",
         "view velocity graph", Key::none, shape_views},
        {osculating_circle, "toggle-osculating-circle", "Osculating circle",
         "Shows the circle that fits the curve best at u.", "view curvature radius", Key::none, shape_views},
        {tangent_normal, "toggle-tangent-normal", "Tangent and normal", "Shows the tangent and the normal at u.",
         "view frame", Key::none, shape_views},
        {curvature_marks, "toggle-curvature-marks", "Inflections and extremes",
         "Marks inflections and extremes of the curvature.", "view vertices", Key::none, shape_views},
        {equal_steps, "toggle-equal-steps", "Equal steps", "Shows points of the curve at equal steps of u.",
         "view dots parameter", Key::none, shape_views},
        {equal_lengths, "toggle-equal-lengths", "Equal lengths",
         "Shows points that divide the curve into equal lengths.", "view dots arc length", Key::none, shape_views},
        {second_hodograph, "toggle-second-hodograph", "Second hodograph", "Shows the second derivative as a curve.",
         "view acceleration", Key::none, shape_views},
        {end_derivatives, "toggle-end-derivatives", "End derivatives",
         "Shows the formulas of the derivatives at the ends.", "view tangents", Key::none, shape_views},
        {span_hulls, "toggle-span-hulls", "Hulls of all spans", "Shows the convex hull of each span.", "view convex",
         Key::none, shape_views},
        {support, "toggle-support", "Support",
         "Shows the part of the curve and the parameters that a control point acts on.", "view local control",
         Key::none, shape_views},
        {variation, "toggle-variation", "Variation diminishing",
         "Shows a line that crosses the curve no more often than the polygon.", "view crossings", Key::none,
         shape_views},
        {other_polygons, "toggle-other-polygons", "Polygons of other curves",
         "Shows the control polygons of the other curves too, with the names of their points where labels are shown.",
         "view inactive points joining", Key::none, shape_views},
        {cubic_conditions, "toggle-cubic-conditions", "Fifteen conditions",
         "Shows the equations that make the four pieces of the uniform cubic.", "view derivation", Key::none,
         cubic_views},
        {cubic_matrix, "toggle-cubic-matrix", "Matrix", "Shows the matrix of the uniform cubic and the segment at u.",
         "view Coons coefficients", Key::none, cubic_views},
        {anticentroids, "toggle-anticentroids", "Anticentroids",
         "Shows how the joints, tangents and second derivatives follow from the vertices.", "view triangle median",
         Key::none, cubic_views},
        {ferguson, "toggle-ferguson", "Ferguson form", "Shows the ends and end tangents of each segment.",
         "view Hermite", Key::none, cubic_views},
        {end_vertices, "toggle-end-vertices", "End vertices",
         "Shows what double, triple, phantom and collinear vertices do.", "view multiple", Key::none, cubic_views},
        {joined_cubics, "toggle-joined-cubics", "Joined cubics",
         "Shows where two uniform cubics join, and with which continuity.", "view Coons C2 shared vertices", Key::none,
         cubic_views},
        {farin_points, "toggle-farin-points", "Farin points",
         "Shows the ratios of the weights as points on the legs of the polygon.", "view weight points", Key::none,
         weight_views},
        {conic, "toggle-conic", "Conic", "Shows the conic through three points, its kind and its numbers.",
         "view ellipse parabola hyperbola circle", Key::none, weight_views},
        {homogeneous, "toggle-homogeneous", "Homogeneous view",
         "Shows the curve in space whose shadow the plane curve is.", "view projection 3D", Key::none, weight_views},
        {invariance, "toggle-invariance", "Invariance", "Shows that mapping the polygon maps the curve.",
         "view affine projective transformation", Key::none, question_views},
        {knot_questions, "toggle-knot-questions", "Knot questions", "Answers what a knot vector says.",
         "view uniform degree segments", Key::none, question_views},
        {quiz, "toggle-quiz", "Quiz", "Asks for what knot vectors say and marks the answers.", "view exercise test",
         Key::none, question_views},
    }};
}();

template <Overlay overlay>
Outcome<void> toggle(EditorState& state, const ToggleOverlay<overlay>&) {
    state.view.overlays.show(overlay, !state.view.overlays.is_shown(overlay));
    refit_view(state);
    return {};
}

bool shows_views(const Overlays& overlays) {
    for (std::size_t i = basic_overlay_count; i < overlay_count; ++i)
        if (overlays.is_shown(static_cast<Overlay>(i))) return true;
    return false;
}

std::optional<Refusal> no_views(const EditorState& state) {
    if (shows_views(state.view.overlays)) return std::nullopt;
    return "no view of the menu Watch is shown";
}

Outcome<void> hide_views(EditorState& state, const HideViews&) {
    for (std::size_t i = basic_overlay_count; i < overlay_count; ++i)
        state.view.overlays.show(static_cast<Overlay>(i), false);
    refit_view(state);
    return {};
}

template <Overlay overlay>
std::optional<Refusal> hidden_by_drawing(const EditorState& state) {
    if (!state.view.overlays.hides(overlay)) return std::nullopt;
    return "the drawing mode hides it; end the drawing mode to see it";
}

template <Overlay overlay>
bool is_shown(const EditorState& state) {
    return state.view.overlays.is_shown(overlay);
}

template <std::size_t index>
CommandSpec toggling() {
    constexpr OverlayText text = texts[index];
    static_assert(text.overlay == static_cast<Overlay>(index));
    return {.name = text.command,
            .title = text.title,
            .explanation = text.explanation,
            .synonyms = text.synonyms,
            .group = text.submenu == nullptr ? CommandGroup::view : CommandGroup::watch,
            .submenu = text.submenu,
            .offered = in_the_window,
            .shortcut = {text.key, {}},
            .refusal = hidden_by_drawing<text.overlay>,
            .is_checked = is_shown<text.overlay>,
            .run = body_of<toggle<text.overlay>>};
}

template <std::size_t... index>
std::array<CommandSpec, overlay_count> all_specs(std::index_sequence<index...>) {
    return {toggling<index>()...};
}

}  // namespace

const CommandSpec& toggle_overlay_spec(Overlay overlay) {
    static const std::array<CommandSpec, overlay_count> specs = all_specs(std::make_index_sequence<overlay_count>());
    return specs[static_cast<std::size_t>(overlay)];
}

const CommandSpec& HideViews::spec() {
    static const CommandSpec spec{.name = "hide-views",
                                  .title = "Hide all views",
                                  .explanation = "Hides the views of this menu with their cards.",
                                  .synonyms = "overlay off close cards clear",
                                  .group = CommandGroup::watch,
                                  .offered = in_the_window,
                                  .refusal = no_views,
                                  .run = body_of<hide_views>};
    return spec;
}

void add_overlay_commands(CommandTable& table) {
    for (std::size_t i = 0; i < overlay_count; ++i) table.emplace_back(toggle_overlay_spec(static_cast<Overlay>(i)));
    add_all<HideViews>(table);
}

}  // namespace batten::editor
