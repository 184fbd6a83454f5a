#include "app/editor/commands/making_commands.h"

#include <cmath>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/lettering_commands.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/pointer/grid_step.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/hodograph.h"
#include "core/make/shapes.h"
#include "core/measure/conic_form.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr double most_sides = 1000.0;

Outcome<Edit> added(const EditorState& state, const char* name, core::Result<core::Curve> curve) {
    if (!curve) return refused(state, curve.error());
    return with_curve(state, name, *std::move(curve));
}

template <class Command>
core::EllipseFrame frame_of(const Command& command) {
    return {command.center, command.first_axis, command.second_axis, command.rotation};
}

Outcome<Edit> add_line(const EditorState& state, const AddLine& command) {
    return added(state, "line", core::line(command.from, command.to));
}

Outcome<Edit> add_polyline(const EditorState& state, const AddPolyline& command) {
    if (command.closed && command.points.size() < 3)
        return tl::unexpected(Refusal("a closed polyline needs 3 points or more; 2 were given"));
    return added(state, "polyline", core::polyline(command.points, command.closed));
}

Outcome<Edit> add_polygon(const EditorState& state, const AddPolygon& command) {
    return added(state, "polygon", core::regular_polygon(command.center, command.radius, command.sides, command.start));
}

Outcome<Edit> add_circle(const EditorState& state, const AddCircle& command) {
    return added(state, "circle", core::circle(command.center, command.radius, command.polygon));
}

Outcome<Edit> add_arc(const EditorState& state, const AddArc& command) {
    return added(state, "arc", core::circular_arc(command.center, command.radius, {command.start, command.sweep}));
}

Outcome<Edit> add_ellipse(const EditorState& state, const AddEllipse& command) {
    return added(state, "ellipse", core::ellipse(frame_of(command)));
}

Outcome<Edit> add_elliptic_arc(const EditorState& state, const AddEllipticArc& command) {
    return added(state, "elliptic arc", core::elliptic_arc(frame_of(command), {command.start, command.sweep}));
}

Outcome<Edit> add_parabola(const EditorState& state, const AddParabola& command) {
    auto arc = core::parabola_arc(command.vertex, command.focal_length, command.axis, {command.from, command.to});
    // Across the axis the range is one of lengths.
    const Units& units = units_of(state);
    if (!arc && arc.error().code == core::CurveErrorCode::range_empty)
        return tl::unexpected(
            sentence("the range begins at {lower} and ends at {upper}; its end must be above its beginning",
                     {{"lower", length_words(units, command.from)}, {"upper", length_words(units, command.to)}}));
    return added(state, "parabola", std::move(arc));
}

Outcome<Edit> add_hyperbola(const EditorState& state, const AddHyperbola& command) {
    return added(state, "hyperbola", core::hyperbola_arc(frame_of(command), {command.from, command.to}));
}

core::Result<core::Curve> conic_of(const AddConic& command) {
    return core::conic(command.points[0], command.points[1], command.points[2], command.weight);
}

Outcome<Edit> add_conic(const EditorState& state, const AddConic& command) {
    return added(state, "conic", conic_of(command));
}

StepTexts texts_of_conic(const EditorState&, const AddConic& command) {
    const auto form =
        conic_of(command).and_then([](const core::Curve& conic) { return conic_form(core::bezier_piece(conic, 2)); });
    if (!form) return {"Make conic", "Made conic"};
    const core::Place type("type", core::title_of(form->type));
    const core::Place ratio("ratio", core::shortest_text(form->shoulder_ratio));
    return {sentence("Make conic: {type}, w/(1 + w) = {ratio}", {type, ratio}),
            sentence("Made conic: {type}, w/(1 + w) = {ratio}", {type, ratio})};
}

Outcome<Edit> add_hodograph(const EditorState& state, const AddHodograph&) {
    const std::string name = sentence("hodograph of {name}", {{"name", state.history.present().active_curve()->name}});
    return added(state, name.c_str(), core::hodograph(active_curve(state)));
}

// Suggestions: the middle of the view on the grid, and lengths of a few grid steps.
double coarse_step(const EditorState& state) {
    return canvas_grid_steps(state).major;
}

double half_step(const EditorState& state) {
    return 0.5 * coarse_step(state);
}

double step_back(const EditorState& state) {
    return -coarse_step(state);
}

using suggest::middle_of_view;

core::Point left_of_middle(const EditorState& state) {
    return middle_of_view(state) - core::Vector(coarse_step(state), 0.0);
}

core::Point right_of_middle(const EditorState& state) {
    return middle_of_view(state) + core::Vector(coarse_step(state), 0.0);
}

std::vector<core::Point> arch(const EditorState& state) {
    return {left_of_middle(state), middle_of_view(state) + core::Vector(0.0, coarse_step(state)),
            right_of_middle(state)};
}

double quarter_weight(const EditorState&) {
    return std::sqrt(0.5);
}

template <auto member>
Field center_field() {
    return field::position<member>({"x", "x of the center"}, {"y", "y of the center"})
        .template suggesting<middle_of_view>();
}

template <auto member>
Field radius_field() {
    return field::length<member>("radius", "above 0").template suggesting<coarse_step>();
}

template <auto member>
Field start_field() {
    return field::angle<member>("start", "where it begins, in degrees").usually(0.0);
}

template <auto member>
Field sweep_field() {
    return field::angle<member>("sweep", "how far it goes, in degrees, counterclockwise").usually(90.0);
}

template <class Command>
std::vector<Field> frame_fields() {
    return {
        center_field<&Command::center>(),
        field::length<&Command::first_axis>("a", "the first semi-axis").template suggesting<coarse_step>(),
        field::length<&Command::second_axis>("b", "the second semi-axis").template suggesting<half_step>(),
        field::angle<&Command::rotation>("rotation", "the direction of the first semi-axis in degrees").usually(0.0)};
}

std::vector<Field> with(std::vector<Field> fields, std::initializer_list<Field> more) {
    fields.insert(fields.end(), more);
    return fields;
}

}  // namespace

const CommandSpec& AddLine::spec() {
    static const CommandSpec spec{
        .name = "line",
        .title = "Line",
        .explanation = "Adds the line between two points.",
        .synonyms = "segment straight",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields = {field::position<&AddLine::from>({"x1", "x of the first end"}, {"y1", "y of the first end"})
                       .suggesting<left_of_middle>(),
                   field::position<&AddLine::to>({"x2", "x of the other end"}, {"y2", "y of the other end"})
                       .suggesting<right_of_middle>()},
        .run = body_of<add_line>,
        .step = "Make line",
        .done = "Made line"};
    return spec;
}

const CommandSpec& AddPolyline::spec() {
    static const CommandSpec spec{
        .name = "polyline",
        .title = "Polyline",
        .explanation = "Adds straight legs from point to point, each over one unit of the parameter.",
        .synonyms = "zigzag",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields = {field::positions<&AddPolyline::points>("coordinates", "x and y of each point")
                       .suggesting<arch>()
                       .at_least(2.0),
                   field::flag<&AddPolyline::closed>("closed", "yes to close it with one more leg").usually(false)},
        .run = body_of<add_polyline>,
        .step = "Make polyline",
        .done = "Made polyline"};
    return spec;
}

const CommandSpec& AddPolygon::spec() {
    static const CommandSpec spec{
        .name = "polygon",
        .title = "Regular polygon",
        .explanation = "Adds a regular polygon with its first corner at the top, or elsewhere.",
        .synonyms = "triangle square hexagon",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields =
            {center_field<&AddPolygon::center>(),
             field::length<&AddPolygon::radius>("radius", "from the center to the corners").suggesting<coarse_step>(),
             field::count<&AddPolygon::sides>("sides", "how many, 3 or more")
                 .usually(6)
                 .at_least(3.0)
                 .at_most(most_sides),
             field::angle<&AddPolygon::start>("start", "the direction of the first corner, in degrees").usually(90.0)},
        .run = body_of<add_polygon>,
        .step = "Make regular polygon",
        .done = "Made regular polygon"};
    return spec;
}

const CommandSpec& AddCircle::spec() {
    static const CommandSpec spec{
        .name = "circle",
        .title = "Circle",
        .explanation = "Adds an exact circle of 9 control points in a square, or 7 in a triangle.",
        .synonyms = "round NURBS",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields = {center_field<&AddCircle::center>(), radius_field<&AddCircle::radius>(),
                   field::choice<&AddCircle::polygon>("points", "how many control points")
                       .usually(core::CirclePolygon::square)},
        .run = body_of<add_circle>,
        .step = "Make circle",
        .done = "Made circle"};
    return spec;
}

const CommandSpec& AddArc::spec() {
    static const CommandSpec spec{.name = "arc",
                                  .title = "Circular arc",
                                  .explanation = "Adds an exact arc of a circle, in pieces of at most 90 degrees.",
                                  .synonyms = "round",
                                  .group = CommandGroup::make,
                                  .submenu = "Shapes",
                                  .fields = {center_field<&AddArc::center>(), radius_field<&AddArc::radius>(),
                                             start_field<&AddArc::start>(), sweep_field<&AddArc::sweep>()},
                                  .run = body_of<add_arc>,
                                  .step = "Make circular arc",
                                  .done = "Made circular arc"};
    return spec;
}

const CommandSpec& AddEllipse::spec() {
    static const CommandSpec spec{.name = "ellipse",
                                  .title = "Ellipse",
                                  .explanation = "Adds an exact ellipse of 9 control points.",
                                  .synonyms = "oval conic",
                                  .group = CommandGroup::make,
                                  .submenu = "Shapes",
                                  .fields = frame_fields<AddEllipse>(),
                                  .run = body_of<add_ellipse>,
                                  .step = "Make ellipse",
                                  .done = "Made ellipse"};
    return spec;
}

const CommandSpec& AddEllipticArc::spec() {
    static const CommandSpec spec{
        .name = "elliptic-arc",
        .title = "Elliptic arc",
        .explanation = "Adds an exact arc of an ellipse; its angles are those of the circle behind it.",
        .synonyms = "oval conic",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields = with(frame_fields<AddEllipticArc>(),
                       {start_field<&AddEllipticArc::start>(), sweep_field<&AddEllipticArc::sweep>()}),
        .run = body_of<add_elliptic_arc>,
        .step = "Make elliptic arc",
        .done = "Made elliptic arc"};
    return spec;
}

const CommandSpec& AddParabola::spec() {
    static const CommandSpec spec{
        .name = "parabola",
        .title = "Parabola",
        .explanation = "Adds an arc of a parabola, as one polynomial piece of degree 2.",
        .synonyms = "conic",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields =
            {field::position<&AddParabola::vertex>({"x", "x of the vertex"}, {"y", "y of the vertex"})
                 .suggesting<middle_of_view>(),
             field::length<&AddParabola::focal_length>("focal length", "from the vertex to the focus")
                 .suggesting<half_step>(),
             field::angle<&AddParabola::axis>("axis", "the direction in which it opens, in degrees").usually(90.0),
             field::length<&AddParabola::from>("from", "where it begins, measured across the axis")
                 .suggesting<step_back>(),
             field::length<&AddParabola::to>("to", "where it ends").suggesting<coarse_step>()},
        .run = body_of<add_parabola>,
        .step = "Make parabola",
        .done = "Made parabola"};
    return spec;
}

const CommandSpec& AddHyperbola::spec() {
    static const CommandSpec spec{
        .name = "hyperbola",
        .title = "Hyperbola",
        .explanation = "Adds an arc of one branch of a hyperbola, as one rational piece of degree 2.",
        .synonyms = "conic",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields = with(frame_fields<AddHyperbola>(),
                       {field::number<&AddHyperbola::from>("from", "hyperbolic angle where it begins").usually(-1.0),
                        field::number<&AddHyperbola::to>("to", "hyperbolic angle where it ends").usually(1.0)}),
        .run = body_of<add_hyperbola>,
        .step = "Make hyperbola",
        .done = "Made hyperbola"};
    return spec;
}

const CommandSpec& AddConic::spec() {
    static const CommandSpec spec{
        .name = "conic",
        .title = "Conic from three points",
        .explanation =
            "Adds a conic from its ends, the corner of its tangents, and the corner's weight: an ellipse "
            "below 1, a parabola at 1, a hyperbola above.",
        .synonyms = "ellipse parabola hyperbola",
        .group = CommandGroup::make,
        .submenu = "Shapes",
        .fields = {field::positions<&AddConic::points>("coordinates", "x and y of first end, corner and other end")
                       .suggesting<arch>()
                       .at_least(3.0)
                       .at_most(3.0),
                   field::number<&AddConic::weight>("weight", "of the corner, above 0").suggesting<quarter_weight>()},
        .run = body_of<add_conic>,
        .texts = texts_of<texts_of_conic>};
    return spec;
}

const CommandSpec& AddHodograph::spec() {
    static const CommandSpec spec{.name = "derivative",
                                  .title = "Hodograph as a curve",
                                  .explanation = "Adds the derivative of the active curve as a curve of its own.",
                                  .synonyms = "velocity",
                                  .group = CommandGroup::make,
                                  .refusal = no_curve,
                                  .run = body_of<add_hodograph>,
                                  .step = "Make hodograph",
                                  .done = "Made hodograph"};
    return spec;
}

void add_making_commands(CommandTable& table) {
    add_all<AddLine, AddPolyline, AddPolygon, AddCircle, AddArc, AddEllipse, AddEllipticArc>(table);
    add_all<AddParabola, AddHyperbola, AddConic, AddHodograph, TextOutlines>(table);
}

}  // namespace batten::editor
