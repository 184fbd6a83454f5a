#include <glm/geometric.hpp>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
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

using Kind = ParameterKind;

core::Point point_of(const Arguments& arguments, std::size_t i) {
    return {arguments.number(i), arguments.number(i + 1)};
}

Outcome<void> show_arc_length(EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    const core::Integral length = core::arc_length(curve, arguments.number(0), arguments.number(1));
    Finding row{.label = "length",
                .numbers = {{"length", length.value},
                            {"error", length.error},
                            {"from", arguments.number(0)},
                            {"to", arguments.number(1)}}};
    return show_rows(state, "Arc length", "has the length " + number_text(length.value, 6), {std::move(row)});
}

Outcome<void> show_point_at_length(EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    const double u = core::ArcLengthTable(curve).parameter_at(arguments.number(0));
    Finding row{.label = "point",
                .parameter = u,
                .point = core::point_at(curve, u),
                .numbers = {{"length", arguments.number(0)}, {"u", u}}};
    add_numbers(row, "point", *row.point);
    const std::string what = "has the length " + number_text(arguments.number(0)) + " at u = " + number_text(u, 6);
    return show_rows(state, "Point at length", what, {std::move(row)});
}

Outcome<void> show_area(EditorState& state, const Arguments&) {
    const auto area = core::enclosed_area(active_curve(state));
    if (!area) return tl::unexpected(core::describe(area.error()));
    Finding row{.label = "area",
                .point = area->centroid,
                .numbers = {{"area", area->signed_area}, {"error", area->error}},
                .note = area->signed_area < 0.0 ? "negative: the curve runs clockwise" : ""};
    if (area->centroid) add_numbers(row, "centroid", *area->centroid);
    const std::string what = "encloses the area " + number_text(area->signed_area, 6);
    return show_rows(state, "Area", what, {std::move(row)});
}

Outcome<void> show_nearest(EditorState& state, const Arguments& arguments) {
    const core::Point query = point_of(arguments, 0);
    const core::CurveSample found = core::nearest_point(active_curve(state), query);
    const double distance = glm::distance(found.point, query);
    Finding row{.label = "nearest point",
                .parameter = found.u,
                .point = found.point,
                .numbers = {{"distance", distance}, {"u", found.u}}};
    add_numbers(row, "point", found.point);
    return show_rows(state, "Nearest point", "is " + number_text(distance) + " away at u = " + number_text(found.u),
                     {std::move(row)});
}

const char* kind_text(core::ContactKind kind) {
    switch (kind) {
        case core::ContactKind::touching:
            return "touches";
        case core::ContactKind::ending:
            return "ends there";
        case core::ContactKind::crossing:
            break;
    }
    return "crosses";
}

Outcome<void> show_line_contacts(EditorState& state, const char* what, core::Result<core::LineContacts> contacts) {
    if (!contacts) return tl::unexpected(core::describe(contacts.error()));
    std::vector<Finding> rows;
    for (const core::LineContact& contact : contacts->contacts) {
        Finding row{.label = kind_text(contact.kind),
                    .parameter = contact.u,
                    .point = contact.point,
                    .numbers = {{"along", contact.along}}};
        if (contact.where.length() > 0.0) {
            row.note = "a straight piece in the line";
            row.numbers.push_back({"from", contact.where.lower});
            row.numbers.push_back({"to", contact.where.upper});
        }
        rows.push_back(std::move(row));
    }
    const std::string summary = std::string("crosses the ") + what + " " +
                                count_text(contacts->crossings, "time", "times") + ", its polygon " +
                                count_text(contacts->polygon_crossings, "time", "times");
    return show_rows(state, "Intersections", summary, std::move(rows));
}

Outcome<void> show_line_intersections(EditorState& state, const Arguments& arguments) {
    return show_line_contacts(
        state, "line", core::intersect_line(active_curve(state), point_of(arguments, 0), point_of(arguments, 2)));
}

Outcome<void> show_segment_intersections(EditorState& state, const Arguments& arguments) {
    return show_line_contacts(
        state, "segment", core::intersect_segment(active_curve(state), point_of(arguments, 0), point_of(arguments, 2)));
}

Outcome<void> show_intersections(EditorState& state, const Arguments& arguments) {
    const Outcome<std::size_t> index = curve_named(state, arguments.text(0));
    if (!index) return tl::unexpected(index.error());
    if (*index == state.history.present().active)
        return tl::unexpected("'" + arguments.text(0) +
                              "' is the active curve itself; name another one, or use self-intersections");
    const core::Curve& other = *state.history.present().curves[*index].curve;
    std::vector<Finding> rows;
    for (const core::CurveContact& contact : core::intersect_curves(active_curve(state), other)) {
        Finding row{.label = contact.is_overlap() ? "coincides"
                             : contact.is_tangent ? "touches"
                                                  : "crosses",
                    .parameter = contact.u,
                    .point = contact.point,
                    .numbers = {{"other u", contact.v}}};
        if (contact.is_overlap())
            for (const auto& [name, value] : {std::pair{"from", contact.on_first.lower},
                                              {"to", contact.on_first.upper},
                                              {"other from", contact.second_begin},
                                              {"other to", contact.second_end}})
                row.numbers.push_back({name, value});
        rows.push_back(std::move(row));
    }
    const std::string what = "meets " + arguments.text(0) + " " + count_text(rows.size(), "time", "times");
    return show_rows(state, "Intersections", what, std::move(rows));
}

Finding evaluation_row(const core::Curve& curve, const std::string& label, double u, core::Side side) {
    const auto derivatives = core::derivatives_at(curve, u, 3, side);
    Finding row{.label = label, .parameter = u, .point = derivatives[0]};
    const char* names[]{"C", "C'", "C''", "C'''"};
    for (std::size_t k = 0; k < derivatives.size(); ++k) add_numbers(row, names[k], derivatives[k]);
    if (const auto tangent = core::tangent_at(curve, u, side)) add_numbers(row, "tangent", *tangent);
    if (const auto bending = core::bending_at(curve, u, side)) {
        row.numbers.push_back({"curvature", bending->curvature});
        row.numbers.push_back({"d curvature / ds", bending->by_arc_length});
    }
    return row;
}

// One row, or two at a knot inside the domain, where both sides may differ.
Outcome<void> show_evaluation(EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    const double u = curve.knots().into_domain(arguments.number(0));
    const core::Interval domain = curve.domain();
    const bool is_inside = curve.is_periodic() || (domain.lower < u && u < domain.upper);
    const std::string at = "u = " + number_text(u, 6);
    std::vector<Finding> rows;
    if (is_inside && curve.knots().multiplicity(u) > 0) {
        rows.push_back(evaluation_row(curve, "left of " + at, u, core::Side::left));
        rows.push_back(evaluation_row(curve, "right of " + at, u, core::Side::right));
    } else {
        rows.push_back(evaluation_row(curve, at, u, core::Side::right));
    }
    const core::Point point = *rows.back().point;
    const std::string what = "is at (" + number_text(point.x) + ", " + number_text(point.y) + ") for " + at;
    return show_rows(state, "Point and derivatives", what, std::move(rows));
}

std::optional<Argument> domain_begin(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return active_curve(state).domain().lower;
}

std::optional<Argument> domain_end(const EditorState& state) {
    if (no_curve(state)) return std::nullopt;
    return active_curve(state).domain().upper;
}

std::vector<ParameterSpec> two_points() {
    return {{"x0", Kind::number, "x of a first point"},
            {"y0", Kind::number, "y of it"},
            {"x1", Kind::number, "x of a second point"},
            {"y1", Kind::number, "y of it"}};
}

CommandSpec with_parameters(CommandSpec spec, std::vector<ParameterSpec> parameters) {
    spec.parameters = std::move(parameters);
    return spec;
}

}  // namespace

void add_measuring_commands(std::vector<CommandSpec>& table) {
    table.push_back(with_parameters(
        measuring_command("evaluate", "Point and derivatives",
                          "Gives point, derivatives, tangent and curvature at a parameter, on both sides of a knot.",
                          "Measure", show_evaluation),
        {{"u", Kind::number, "where in the domain", current_parameter}}));
    table.push_back(with_parameters(
        measuring_command("arc-length", "Arc length", "Measures the curve between two parameters.", "Measure",
                          show_arc_length),
        {{"a", Kind::number, "from this parameter", domain_begin}, {"b", Kind::number, "to this one", domain_end}}));
    table.push_back(
        with_parameters(measuring_command("point-at-length", "Point at length",
                                          "Finds the parameter at a length from the beginning of the curve.", "Measure",
                                          show_point_at_length),
                        {{"s", Kind::number, "length along the curve"}}));
    table.push_back(measuring_command("area", "Area", "Measures what a closed curve encloses, and its centroid.",
                                      "Measure", show_area));
    table.push_back(with_parameters(
        measuring_command("nearest", "Nearest point", "Finds the point of the curve that is nearest to a given one.",
                          "Measure", show_nearest),
        {{"x", Kind::number, "x of the point"}, {"y", Kind::number, "y of the point"}}));
    table.push_back(with_parameters(
        measuring_command("intersect-line", "Intersect with a line",
                          "Finds all points on a line, and counts how often curve and polygon cross it.", "Measure",
                          show_line_intersections),
        two_points()));
    table.push_back(with_parameters(
        measuring_command("intersect-segment", "Intersect with a segment",
                          "Finds all points on a segment, and counts how often curve and polygon cross it.", "Measure",
                          show_segment_intersections),
        two_points()));
    table.push_back(
        with_parameters(measuring_command("intersect", "Intersect with a curve",
                                          "Finds all points and pieces that the curve has in common with another one.",
                                          "Measure", show_intersections),
                        {{"other", Kind::text, "name of the other curve", next_curve_name}}));
}

}  // namespace batten::editor
