#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "app/editor/grid_step.h"
#include "core/evaluate/hodograph.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/measure/conic_form.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;

constexpr std::size_t most_sides = 1000;

Outcome<Edit> added(const EditorState& state, const char* name, core::Result<core::Curve> curve) {
    if (!curve) return tl::unexpected(core::describe(curve.error()));
    return with_curve(state, name, *std::move(curve));
}

core::Point point_at(const Arguments& arguments, std::size_t i) {
    return {arguments.number(i), arguments.number(i + 1)};
}

// The frame whose members are the arguments from 0 on.
core::EllipseFrame frame_of(const Arguments& arguments) {
    return {point_at(arguments, 0), arguments.number(2), arguments.number(3), arguments.number(4)};
}

Outcome<Edit> add_line(const EditorState& state, const Arguments& arguments) {
    return added(state, "line", core::line(point_at(arguments, 0), point_at(arguments, 2)));
}

Outcome<Edit> add_polyline(const EditorState& state, const Arguments& arguments) {
    const bool is_closed = arguments.number(1) != 0.0;
    const Outcome<std::vector<core::Point>> points = points_of(arguments.numbers(0), is_closed ? 3 : 2, "a polyline");
    if (!points) return tl::unexpected(points.error());
    return added(state, "polyline", core::polyline(*points, is_closed));
}

Outcome<Edit> add_polygon(const EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> sides = index_of(arguments.number(3), "sides");
    if (!sides) return tl::unexpected(sides.error());
    if (*sides > most_sides)
        return tl::unexpected("the polygon has " + std::to_string(*sides) + " sides; at most " +
                              std::to_string(most_sides) + " are allowed");
    return added(state, "polygon", core::regular_polygon(point_at(arguments, 0), arguments.number(2), *sides));
}

Outcome<core::CirclePolygon> circle_polygon(double points) {
    if (points == 9.0) return core::CirclePolygon::square;
    if (points == 7.0) return core::CirclePolygon::triangle;
    return tl::unexpected("the circle has " + number_text(points) + " control points; it must be 9 or 7");
}

Outcome<Edit> add_circle(const EditorState& state, const Arguments& arguments) {
    const auto polygon = circle_polygon(arguments.number(3));
    if (!polygon) return tl::unexpected(polygon.error());
    return added(state, "circle", core::circle(point_at(arguments, 0), arguments.number(2), *polygon));
}

Outcome<Edit> add_arc(const EditorState& state, const Arguments& arguments) {
    return added(
        state, "arc",
        core::circular_arc(point_at(arguments, 0), arguments.number(2), {arguments.number(3), arguments.number(4)}));
}

Outcome<Edit> add_ellipse(const EditorState& state, const Arguments& arguments) {
    return added(state, "ellipse", core::ellipse(frame_of(arguments)));
}

Outcome<Edit> add_elliptic_arc(const EditorState& state, const Arguments& arguments) {
    return added(state, "elliptic arc",
                 core::elliptic_arc(frame_of(arguments), {arguments.number(5), arguments.number(6)}));
}

Outcome<Edit> add_parabola(const EditorState& state, const Arguments& arguments) {
    return added(state, "parabola",
                 core::parabola_arc(point_at(arguments, 0), arguments.number(2), arguments.number(3),
                                    {arguments.number(4), arguments.number(5)}));
}

Outcome<Edit> add_hyperbola(const EditorState& state, const Arguments& arguments) {
    return added(state, "hyperbola",
                 core::hyperbola_arc(frame_of(arguments), {arguments.number(5), arguments.number(6)}));
}

core::Result<core::Curve> conic_through(const std::vector<double>& c, double weight) {
    return core::conic({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, weight);
}

Outcome<Edit> add_conic(const EditorState& state, const Arguments& arguments) {
    const std::vector<double>& coordinates = arguments.numbers(0);
    if (coordinates.size() != 6)
        return tl::unexpected("a conic needs x and y of 3 points; " + std::to_string(coordinates.size()) +
                              " coordinates were given");
    return added(state, "conic", conic_through(coordinates, arguments.number(1)));
}

// "Make conic: ellipse, w/(1 + w) = 0.4142"
std::string conic_label(const EditorState&, const Arguments& arguments) {
    const auto curve = conic_through(arguments.numbers(0), arguments.number(1));
    const auto form = curve.and_then([](const core::Curve& conic) { return conic_form(core::bezier_piece(conic, 2)); });
    if (!form) return "Make conic";
    return std::string("Make conic: ") + core::title_of(form->type) +
           ", w/(1 + w) = " + number_text(form->shoulder_ratio);
}

Outcome<Edit> add_derivative(const EditorState& state, const Arguments&) {
    const std::string& name = state.history.present().active_curve()->name;
    return added(state, ("hodograph of " + name).c_str(), core::hodograph(active_curve(state)));
}

// Suggestions: the middle of the view on the grid, and lengths of a few grid steps.
double coarse_step(const EditorState& state) {
    return major_grid_step(state.view.camera.scale / state.view.interface_scale);
}

double on_grid(const EditorState& state, double value) {
    const double step = minor_grid_step(state.view.camera.scale / state.view.interface_scale);
    return step * std::round(value / step);
}

core::Point middle_of_view(const EditorState& state) {
    return {on_grid(state, state.view.camera.center.x), on_grid(state, state.view.camera.center.y)};
}

std::optional<Argument> middle_x(const EditorState& state) {
    return middle_of_view(state).x;
}

std::optional<Argument> middle_y(const EditorState& state) {
    return middle_of_view(state).y;
}

std::optional<Argument> left_x(const EditorState& state) {
    return middle_of_view(state).x - coarse_step(state);
}

std::optional<Argument> right_x(const EditorState& state) {
    return middle_of_view(state).x + coarse_step(state);
}

std::optional<Argument> one_step(const EditorState& state) {
    return coarse_step(state);
}

std::optional<Argument> half_step(const EditorState& state) {
    return 0.5 * coarse_step(state);
}

std::optional<Argument> step_back(const EditorState& state) {
    return -coarse_step(state);
}

std::optional<Argument> arch(const EditorState& state) {
    const core::Point middle = middle_of_view(state);
    const double step = coarse_step(state);
    return std::vector<double>{middle.x - step, middle.y, middle.x, middle.y + step, middle.x + step, middle.y};
}

template <int value>
std::optional<Argument> number(const EditorState&) {
    return static_cast<double>(value);
}

std::optional<Argument> quarter_weight(const EditorState&) {
    return std::sqrt(0.5);
}

// The steps of the history, as verbs.
constexpr char line_label[] = "Make line";
constexpr char polyline_label[] = "Make polyline";
constexpr char polygon_label[] = "Make regular polygon";
constexpr char circle_label[] = "Make circle";
constexpr char arc_label[] = "Make circular arc";
constexpr char ellipse_label[] = "Make ellipse";
constexpr char elliptic_arc_label[] = "Make elliptic arc";
constexpr char parabola_label[] = "Make parabola";
constexpr char hyperbola_label[] = "Make hyperbola";
constexpr char derivative_label[] = "Make hodograph";

template <const char* label>
std::string named(const EditorState&, const Arguments&) {
    return label;
}

ParameterSpec center(const char* name) {
    const bool is_x = name[0] == 'x';
    return {name, Kind::number, is_x ? "x of the center" : "y of the center", is_x ? middle_x : middle_y};
}

std::vector<ParameterSpec> ellipse_parameters() {
    return {center("x"),
            center("y"),
            {"a", Kind::number, "the first semi-axis", one_step},
            {"b", Kind::number, "the second semi-axis", half_step},
            {"rotation", Kind::number, "the direction of the first semi-axis in degrees", number<0>}};
}

std::vector<ParameterSpec> with(std::vector<ParameterSpec> parameters, std::initializer_list<ParameterSpec> more) {
    parameters.insert(parameters.end(), more);
    return parameters;
}

void add_straight_shapes(std::vector<CommandSpec>& table) {
    table.push_back({.name = "line",
                     .title = "Line",
                     .explanation = "Adds the line between two points.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = {{"x1", Kind::number, "x of the first end", left_x},
                                    {"y1", Kind::number, "y of the first end", middle_y},
                                    {"x2", Kind::number, "x of the other end", right_x},
                                    {"y2", Kind::number, "y of the other end", middle_y}},
                     .edit = add_line,
                     .label = named<line_label>});
    table.push_back(
        {.name = "polyline",
         .title = "Polyline",
         .explanation = "Adds straight legs from point to point, a unit of the parameter each.",
         .group = CommandGroup::make,
         .submenu = "Shapes",
         .parameters = {{"coordinates", Kind::numbers, "x and y of each point", arch},
                        {"closed", Kind::number, "1 to close it with one leg more, 0 to leave it open", number<0>}},
         .edit = add_polyline,
         .label = named<polyline_label>});
    table.push_back({.name = "polygon",
                     .title = "Regular polygon",
                     .explanation = "Adds a regular polygon with its first corner at the top.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = {center("x"),
                                    center("y"),
                                    {"radius", Kind::number, "from the center to the corners", one_step},
                                    {"sides", Kind::number, "how many, 3 or more", number<6>}},
                     .edit = add_polygon,
                     .label = named<polygon_label>});
}

void add_circles(std::vector<CommandSpec>& table) {
    const ParameterSpec radius{"radius", Kind::number, "above 0", one_step};
    const ParameterSpec start{"start", Kind::number, "where it begins, in degrees", number<0>};
    const ParameterSpec sweep{"sweep", Kind::number, "how far it goes, in degrees, counter-clockwise", number<90>};
    table.push_back({.name = "circle",
                     .title = "Circle",
                     .explanation = "Adds an exact circle of 9 control points in a square, or 7 in a triangle.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = {center("x"), center("y"), radius, {"points", Kind::number, "9 or 7", number<9>}},
                     .edit = add_circle,
                     .label = named<circle_label>});
    table.push_back({.name = "arc",
                     .title = "Circular arc",
                     .explanation = "Adds an exact arc of a circle, in pieces of at most 90 degrees.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = {center("x"), center("y"), radius, start, sweep},
                     .edit = add_arc,
                     .label = named<arc_label>});
    table.push_back({.name = "ellipse",
                     .title = "Ellipse",
                     .explanation = "Adds an exact ellipse of 9 control points.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = ellipse_parameters(),
                     .edit = add_ellipse,
                     .label = named<ellipse_label>});
    table.push_back({.name = "elliptic-arc",
                     .title = "Elliptic arc",
                     .explanation = "Adds an exact arc of an ellipse; its angles are those of the circle behind it.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = with(ellipse_parameters(), {start, sweep}),
                     .edit = add_elliptic_arc,
                     .label = named<elliptic_arc_label>});
}

void add_other_conics(std::vector<CommandSpec>& table) {
    table.push_back({.name = "parabola",
                     .title = "Parabola",
                     .explanation = "Adds an arc of a parabola, as one polynomial piece of degree 2.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = {{"x", Kind::number, "x of the vertex", middle_x},
                                    {"y", Kind::number, "y of the vertex", middle_y},
                                    {"focal length", Kind::number, "from the vertex to the focus", half_step},
                                    {"axis", Kind::number, "the direction it opens to, in degrees", number<90>},
                                    {"from", Kind::number, "where it begins, measured across the axis", step_back},
                                    {"to", Kind::number, "where it ends", one_step}},
                     .edit = add_parabola,
                     .label = named<parabola_label>});
    table.push_back({.name = "hyperbola",
                     .title = "Hyperbola",
                     .explanation = "Adds an arc of one branch of a hyperbola, as one rational piece of degree 2.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = with(ellipse_parameters(),
                                        {{"from", Kind::number, "hyperbolic angle where it begins", number<-1>},
                                         {"to", Kind::number, "hyperbolic angle where it ends", number<1>}}),
                     .edit = add_hyperbola,
                     .label = named<hyperbola_label>});
    table.push_back({.name = "conic",
                     .title = "Conic from three points",
                     .explanation = "Adds a conic from its ends, the corner of its tangents, and the corner's weight: "
                                    "an ellipse below 1, a parabola at 1, a hyperbola above.",
                     .group = CommandGroup::make,
                     .submenu = "Shapes",
                     .parameters = {{"coordinates", Kind::numbers, "x and y of first end, corner and other end", arch},
                                    {"weight", Kind::number, "of the corner, above 0", quarter_weight}},
                     .edit = add_conic,
                     .label = conic_label});
}

}  // namespace

void add_making_commands(std::vector<CommandSpec>& table) {
    add_straight_shapes(table);
    add_circles(table);
    add_other_conics(table);
    table.push_back({.name = "derivative",
                     .title = "Hodograph as a curve",
                     .explanation = "Adds the derivative of the active curve as a curve of its own.",
                     .group = CommandGroup::make,
                     .refusal = no_curve,
                     .edit = add_derivative,
                     .label = named<derivative_label>});
}

}  // namespace batten::editor
