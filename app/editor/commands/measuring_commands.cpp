#include "app/editor/commands/measuring_commands.h"

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/arc_length.h"
#include "core/measure/area.h"
#include "core/measure/curvature.h"
#include "core/measure/intersect_curves.h"
#include "core/measure/intersect_line.h"
#include "core/measure/nearest.h"

namespace batten::editor {

namespace {

using core::sentence;

// A part may be as short as the rounding of the whole.
bool is_doubtful(const core::Curve& curve, const core::Integral& length) {
    if (core::is_sharp({std::abs(length.value), length.error})) return false;
    const core::Integral whole = core::arc_length(curve);
    return !core::is_sharp(whole) || length.error > whole.error;
}

// Which of the parameters are outside of the domain of an open curve, and what is taken instead.
std::string clamped_note(const core::Curve& curve, std::initializer_list<double> parameters) {
    std::vector<std::string> sentences;
    for (const double u : parameters)
        if (!curve.is_periodic() && !curve.domain().contains(u))
            sentences.push_back(clamped_sentence(curve.knots(), u, curve.knots().into_domain(u)));
    return told_in_turn(sentences).value_or("");
}

Outcome<void> measure_arc_length(EditorState& state, const MeasureArcLength& command) {
    const core::Curve& curve = active_curve(state);
    const core::Integral length = core::arc_length(curve, command.begin, command.end);
    Finding row{.label = "length",
                .numbers = {{"length", length.value, 0.0, 1},
                            {"error", length.error, 0.0, 1},
                            {"from", command.begin},
                            {"to", command.end}},
                .note = clamped_note(curve, {command.begin, command.end})};
    const Units& units = units_of(state);
    std::string summary =
        is_doubtful(curve, length)
            ? sentence(
                  "{name} has a length from {least} to {most}; its weights or points are too far apart to tell more",
                  {active_name(state),
                   {"least", length_words(units, length.value - length.error)},
                   {"most", length_words(units, length.value + length.error)}})
            : sentence("{name} has the length {length}",
                       {active_name(state), {"length", length_words(units, length.value)}});
    return show_rows(state, "Arc length", std::move(summary), {std::move(row)});
}

// What is beyond an end of an open curve ends there, and is said to do so.
const char* pattern_of_length(const core::Curve& curve, double wanted, double whole) {
    if (!curve.is_periodic() && wanted > whole)
        return "{name} ends at the length {whole}, at u = {u}: {length} is beyond it";
    if (!curve.is_periodic() && wanted < 0.0) return "{name} begins at the length 0, at u = {u}: {length} is before it";
    return "{name} has the length {length} at u = {u}";
}

Outcome<void> find_point_at_length(EditorState& state, const FindPointAtLength& command) {
    const core::Curve& curve = active_curve(state);
    const core::ArcLengthTable table(curve);
    const double whole = table.total().value;
    const double reached = curve.is_periodic() ? command.length : std::clamp(command.length, 0.0, whole);
    const double u = table.parameter_at(command.length);
    Finding row{.label = "point",
                .parameter = u,
                .point = core::point_at(curve, u),
                .numbers = {{"length", reached, 0.0, 1}, {"u", u}, {"whole length", whole, 0.0, 1}}};
    add_numbers(row, "point", *row.point, coordinate_error(curve));
    const Units& units = units_of(state);
    std::string summary = core::filled_as_needed(pattern_of_length(curve, command.length, whole),
                                                 {active_name(state),
                                                  {"length", length_words(units, command.length)},
                                                  {"whole", length_words(units, whole)},
                                                  {"u", core::shortest_text(u)}});
    return show_rows(state, "Point at length", std::move(summary), {std::move(row)});
}

Outcome<void> measure_area(EditorState& state, const MeasureArea&) {
    const auto area = core::enclosed_area(active_curve(state));
    if (!area) return refused(state, area.error());
    const core::Place value("area", area_words(units_of(state), area->signed_area));
    Finding row{.label = sentence("area {area}", {value}),
                .point = area->centroid,
                .numbers = {{"area", area->signed_area, area->error, 2}, {"error", area->error, 0.0, 2}},
                .note = area->signed_area < 0.0 ? "negative: the curve runs clockwise" : ""};
    if (area->centroid) add_numbers(row, "centroid", *area->centroid, coordinate_error(active_curve(state)));
    const char* pattern = area->centroid
                              ? "{name} encloses the area {area}"
                              : "{name} encloses the area {area}, as parts to its left and to its right cancel";
    std::string summary = core::filled_as_needed(pattern, {active_name(state), value});
    return show_rows(state, "Area", std::move(summary), {std::move(row)});
}

Outcome<void> find_nearest(EditorState& state, const FindNearest& command) {
    const core::CurveSample found = core::nearest_point(active_curve(state), command.position);
    const double distance = core::distance(found.point, command.position);
    Finding row{.label = "nearest point",
                .parameter = found.u,
                .point = found.point,
                .numbers = {{"distance", distance, coordinate_error(active_curve(state)), 1}, {"u", found.u}}};
    add_numbers(row, "point", found.point, coordinate_error(active_curve(state)));
    std::string summary =
        sentence("{name} is {distance} away at u = {u}", {active_name(state),
                                                          {"distance", length_words(units_of(state), distance)},
                                                          {"u", core::shortest_text(found.u)}});
    return show_rows(state, "Nearest point", std::move(summary), {std::move(row)});
}

std::string times_text(std::size_t count) {
    return sentence({.one = "1 time", .many = "{count} times"}, count);
}

Finding contact_row(const core::LineContact& contact) {
    Finding row{.label = core::title_of(contact.kind),
                .parameter = contact.u,
                .point = contact.point,
                .numbers = {{"along", contact.along}}};
    if (contact.where.length() > 0.0) row.note = "a straight piece in the line";
    add_interval(row, contact.where);
    return row;
}

// `pattern` has the places {name}, {crossings} and {polygon_crossings}.
Outcome<void> show_line_contacts(EditorState& state, const char* pattern, core::Result<core::LineContacts> contacts) {
    if (!contacts) return refused(state, contacts.error());
    std::vector<Finding> rows;
    for (const core::LineContact& contact : contacts->contacts) rows.push_back(contact_row(contact));
    std::string summary = sentence(pattern, {active_name(state),
                                             {"crossings", times_text(contacts->crossings)},
                                             {"polygon_crossings", times_text(contacts->polygon_crossings)}});
    return show_rows(state, "Intersections", std::move(summary), std::move(rows));
}

Outcome<void> intersect_line(EditorState& state, const IntersectLine& command) {
    return show_line_contacts(state, "{name} crosses the line {crossings}, its polygon {polygon_crossings}",
                              core::intersect_line(active_curve(state), command.first, command.second));
}

Outcome<void> intersect_segment(EditorState& state, const IntersectSegment& command) {
    return show_line_contacts(state, "{name} crosses the segment {crossings}, its polygon {polygon_crossings}",
                              core::intersect_segment(active_curve(state), command.first, command.second));
}

Finding contact_row(const core::CurveContact& contact) {
    Finding row{.label = contact.is_overlap() ? "coincides"
                         : contact.is_tangent ? "touches"
                                              : "crosses",
                .parameter = contact.u,
                .point = contact.point,
                .numbers = {{"other u", contact.v}}};
    if (!contact.is_overlap()) return row;
    add_interval(row, contact.on_first);
    row.numbers.push_back({"other from", contact.second_begin});
    row.numbers.push_back({"other to", contact.second_end});
    return row;
}

Outcome<void> intersect_curve(EditorState& state, const IntersectCurve& command) {
    const Outcome<std::size_t> index = curve_named(state, command.other);
    if (!index) return tl::unexpected(index.error());
    const core::DocumentCurve& other = state.history.present().curves[*index];
    if (*index == state.history.present().active)
        return tl::unexpected(
            sentence("'{name}' is the active curve itself; name another one, or use self-intersections",
                     {{"name", other.name}}));
    std::vector<Finding> rows;
    const core::CurveContacts found = core::intersect_curves(active_curve(state), *other.curve, state.progress);
    for (const core::CurveContact& contact : found.contacts) rows.push_back(contact_row(contact));
    const char* pattern = found.is_complete ? "{name} meets {other} {times}"
                                            : "{name} meets {other} at least {times}; parts of them run too close to "
                                              "each other to tell all";
    std::string summary =
        sentence(pattern, {active_name(state), {"other", other.name}, {"times", times_text(rows.size())}});
    return show_rows(state, "Intersections", std::move(summary), std::move(rows));
}

Finding evaluation_row(const core::Curve& curve, const std::string& label, double u, core::Side side) {
    const core::Jet jet = core::derivatives_at(curve, u, 3, side);
    Finding row{.label = label, .parameter = u, .point = jet.point};
    add_numbers(row, "C", jet.point, coordinate_error(curve));
    add_numbers(row, "C'", jet[1]);
    add_numbers(row, "C''", jet[2]);
    add_numbers(row, "C'''", jet[3]);
    if (const auto tangent = core::tangent_at(curve, u, side)) add_numbers(row, "tangent", *tangent, 0);
    if (const auto bending = core::bending_at(curve, u, side)) {
        row.numbers.push_back({"curvature", bending->curvature, 0.0, -1});
        row.numbers.push_back({"d curvature / ds", bending->by_arc_length, 0.0, -2});
    }
    return row;
}

// One row, or two at a knot inside the domain, where both sides may differ.
Outcome<void> evaluate(EditorState& state, const Evaluate& command) {
    const core::Curve& curve = active_curve(state);
    const double u = curve.knots().into_domain(command.u);
    const core::Interval domain = curve.domain();
    const bool is_inside = curve.is_periodic() || (domain.lower < u && u < domain.upper);
    const core::Place at("u", core::shortest_text(u));
    std::vector<Finding> rows;
    if (is_inside && curve.knots().multiplicity(u) > 0) {
        rows.push_back(evaluation_row(curve, sentence("left of u = {u}", {at}), u, core::Side::left));
        rows.push_back(evaluation_row(curve, sentence("right of u = {u}", {at}), u, core::Side::right));
    } else {
        rows.push_back(evaluation_row(curve, sentence("u = {u}", {at}), u, core::Side::right));
    }
    if (!domain.contains(command.u))
        for (Finding& row : rows) row.note = clamped_sentence(curve.knots(), command.u, u);
    std::string summary = sentence(
        "{name} is at {place} for u = {u}",
        {active_name(state), {"place", place_words(units_of(state), *rows.back().point, coordinate_error(curve))}, at});
    return show_rows(state, "Point and derivatives", std::move(summary), std::move(rows));
}

template <class Command>
std::vector<Field> two_points() {
    return {field::position<&Command::first>({"x0", "x of a first point"}, {"y0", "y of it"}),
            field::position<&Command::second>({"x1", "x of a second point"}, {"y1", "y of it"})};
}

}  // namespace

const CommandSpec& Evaluate::spec() {
    static const CommandSpec spec{
        .name = "evaluate",
        .title = "Point and derivatives",
        .explanation = "Gives point, derivatives, tangent and curvature at a parameter, on both sides of a knot.",
        .synonyms = "value position speed",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields = {field::parameter<&Evaluate::u>("u", "where in the domain").suggesting<suggest::current_parameter>()},
        .refusal = no_curve,
        .run = body_of<evaluate>};
    return spec;
}

const CommandSpec& MeasureArcLength::spec() {
    static const CommandSpec spec{
        .name = "arc-length",
        .title = "Arc length",
        .explanation = "Measures the curve between two parameters.",
        .synonyms = "distance perimeter",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields =
            {field::parameter<&MeasureArcLength::begin>("a", "from this parameter").suggesting<suggest::domain_begin>(),
             field::parameter<&MeasureArcLength::end>("b", "to this one").suggesting<suggest::domain_end>()},
        .refusal = no_curve,
        .run = body_of<measure_arc_length>};
    return spec;
}

const CommandSpec& FindPointAtLength::spec() {
    static const CommandSpec spec{
        .name = "point-at-length",
        .title = "Point at length",
        .explanation = "Finds the parameter at a given length from the beginning of the curve.",
        .synonyms = "arc distance",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields = {field::length<&FindPointAtLength::length>("s", "length along the curve")},
        .refusal = no_curve,
        .run = body_of<find_point_at_length>};
    return spec;
}

const CommandSpec& MeasureArea::spec() {
    static const CommandSpec spec{.name = "area",
                                  .title = "Area",
                                  .explanation = "Measures the area that a closed curve encloses, and its centroid.",
                                  .synonyms = "center of gravity",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Measure",
                                  .refusal = no_curve,
                                  .run = body_of<measure_area>};
    return spec;
}

const CommandSpec& FindNearest::spec() {
    static const CommandSpec spec{
        .name = "nearest",
        .title = "Nearest point",
        .explanation = "Finds the point of the curve that is nearest to a given one.",
        .synonyms = "closest project distance",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields = {field::position<&FindNearest::position>({"x", "x of the point"}, {"y", "y of the point"})},
        .refusal = no_curve,
        .run = body_of<find_nearest>};
    return spec;
}

const CommandSpec& IntersectLine::spec() {
    static const CommandSpec spec{
        .name = "intersect-line",
        .title = "Intersect with a line",
        .explanation = "Finds all points on a line, and counts how often curve and polygon cross it.",
        .synonyms = "crossing variation diminishing",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields = two_points<IntersectLine>(),
        .refusal = no_curve,
        .run = body_of<intersect_line>};
    return spec;
}

const CommandSpec& IntersectSegment::spec() {
    static const CommandSpec spec{
        .name = "intersect-segment",
        .title = "Intersect with a segment",
        .explanation = "Finds all points on a segment, and counts how often curve and polygon cross it.",
        .synonyms = "crossing",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields = two_points<IntersectSegment>(),
        .refusal = no_curve,
        .run = body_of<intersect_segment>};
    return spec;
}

const CommandSpec& IntersectCurve::spec() {
    static const CommandSpec spec{
        .name = "intersect",
        .title = "Intersect with a curve",
        .explanation = "Finds all points and pieces that the curve has in common with another one.",
        .synonyms = "crossing meet",
        .group = CommandGroup::analyze,
        .submenu = "Measure",
        .fields = {field::curve_name<&IntersectCurve::other>("other", "name of the other curve")
                       .suggesting<suggest::next_curve_name>()},
        .refusal = no_curve,
        .run = body_of<intersect_curve>,
        .at_work = "Seeking intersections"};
    return spec;
}

void add_measuring_commands(CommandTable& table) {
    add_all<Evaluate, MeasureArcLength, FindPointAtLength, MeasureArea, FindNearest>(table);
    add_all<IntersectLine, IntersectSegment, IntersectCurve>(table);
}

}  // namespace batten::editor
