#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/evaluate/blossom.h"
#include "core/evaluate/blossom_labels.h"
#include "core/evaluate/de_boor.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/uniform_cubic.h"
#include "core/measure/closing.h"
#include "core/measure/collinear.h"
#include "core/measure/conic_form.h"

namespace batten::editor {

namespace {

std::string numbered(const char* noun, std::size_t index) {
    return std::string(noun) + " " + std::to_string(index);
}

Outcome<void> show_closing(EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    const core::ClosingReport report = core::closing_of(curve);
    const double start = curve.domain().lower;
    Finding finding{.label = core::title_of(report.closing),
                    .parameter = start,
                    .point = core::point_at(curve, start),
                    .numbers = {{"gap", report.gap}, {"continuity", static_cast<double>(report.continuity)}}};
    switch (report.closing) {
        case core::Closing::open:
            return show_rows(state, "Closing", "is open; its ends are " + number_text(report.gap) + " apart",
                             {finding});
        case core::Closing::ends_meet:
            return show_rows(state, "Closing", "is closed by ends that meet", {finding});
        case core::Closing::wrapped:
            return show_rows(state, "Closing", "is closed by wrapped control points", {finding});
        case core::Closing::periodic:
            break;
    }
    return show_rows(state, "Closing", "is truly periodic", {finding});
}

Outcome<void> show_collinear_runs(EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    for (const core::CollinearRun& run : core::collinear_runs(curve)) {
        const std::size_t last = (run.first + run.count - 1) % curve.control_points().size();
        rows.push_back(
            {.label = point_text(static_cast<double>(run.first)) + " to " + point_text(static_cast<double>(last)),
             .parameter = run.straight.lower,
             .point = core::point_at(curve, run.straight.lower),
             .numbers = {{"points", static_cast<double>(run.count)},
                         {"from", run.straight.lower},
                         {"to", run.straight.upper}}});
    }
    const std::string what = "has " + count_text(rows.size(), "straight piece", "straight pieces");
    return show_rows(state, "Straight pieces", what, std::move(rows));
}

Outcome<void> show_matrix(EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    const auto segments = core::cubic_segments(curve);
    if (!segments) return tl::unexpected(core::describe(segments.error()));
    std::vector<Finding> rows;
    for (const core::CubicSegment& segment : *segments) {
        Finding finding{.label = numbered("segment", rows.size()),
                        .parameter = segment.interval.lower,
                        .point = core::point_at(curve, segment.interval.lower),
                        .note = "a₀ + a₁ t + a₂ t² + a₃ t³, t from 0 to 1"};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::string name = "a" + std::to_string(k);
            add_numbers(finding, name, segment.coefficients[k]);
            if (curve.is_rational()) finding.numbers.push_back({name + " w", segment.coefficients[k].z});
        }
        rows.push_back(std::move(finding));
    }
    const std::string what = "has " + count_text(rows.size(), "segment", "segments") + " in matrix form";
    return show_rows(state, "Matrix form", what, std::move(rows));
}

Outcome<void> show_ferguson(EditorState& state, const Arguments&) {
    const auto segments = core::ferguson_segments(active_curve(state));
    if (!segments) return tl::unexpected(core::describe(segments.error()));
    std::vector<Finding> rows;
    for (const core::FergusonSegment& segment : *segments) {
        Finding finding{
            .label = numbered("segment", rows.size()), .parameter = segment.interval.lower, .point = segment.start};
        add_numbers(finding, "start", segment.start);
        add_numbers(finding, "end", segment.end);
        add_numbers(finding, "start tangent", segment.start_tangent);
        add_numbers(finding, "end tangent", segment.end_tangent);
        rows.push_back(std::move(finding));
    }
    const std::string what = "has " + count_text(rows.size(), "segment", "segments") + " in Ferguson form";
    return show_rows(state, "Ferguson form", what, std::move(rows));
}

Outcome<void> show_anticentroids(EditorState& state, const Arguments&) {
    const auto joints = core::anticentroids(active_curve(state));
    if (!joints) return tl::unexpected(core::describe(joints.error()));
    std::vector<Finding> rows;
    for (const core::Anticentroid& joint : *joints) {
        Finding finding{.label = "triangle at " + point_text(static_cast<double>(joint.index)),
                        .parameter = joint.u,
                        .point = joint.anticentroid};
        add_numbers(finding, "anticentroid", joint.anticentroid);
        add_numbers(finding, "vertex", joint.vertex);
        add_numbers(finding, "middle of base", joint.base_middle);
        add_numbers(finding, "tangent", joint.tangent);
        add_numbers(finding, "second derivative", joint.second_derivative);
        rows.push_back(std::move(finding));
    }
    const std::string what = "has " + count_text(rows.size(), "anticentroid", "anticentroids");
    return show_rows(state, "Anticentroids", what, std::move(rows));
}

Outcome<void> show_conic_form(EditorState& state, const Arguments&) {
    std::vector<Finding> rows;
    for (const core::BezierPiece& piece : core::bezier_pieces(active_curve(state))) {
        const auto form = core::conic_form(piece);
        if (!form && form.error().code != core::CurveErrorCode::points_collinear)
            return tl::unexpected(core::describe(form.error()));
        if (!form) {
            rows.push_back({.label = "straight line", .parameter = piece.interval.lower});
            continue;
        }
        const core::ImplicitConic& k = form->equation;
        Finding finding{.label = core::title_of(form->type),
                        .point = form->shoulder,
                        .numbers = {{"w", form->weight}, {"w/(1+w)", form->shoulder_ratio}},
                        .note = "A X² + B XY + C Y² + D X + E Y + F = 0, (X, Y) seen from the origin given"};
        for (const auto& [name, value] :
             {std::pair{"A", k.a}, {"B", k.b}, {"C", k.c}, {"D", k.d}, {"E", k.e}, {"F", k.f}})
            finding.numbers.push_back({name, value});
        add_numbers(finding, "origin", k.origin);
        rows.push_back(std::move(finding));
    }
    const std::string what = "has " + count_text(rows.size(), "conic piece", "conic pieces");
    return show_rows(state, "Conic form", what, std::move(rows));
}

std::string label_text(const core::BlossomLabel& label) {
    return core::symbolic_text(label) + " = " + core::value_text(label);
}

Outcome<void> show_blossom_labels(EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    const std::size_t n = curve.control_points().size();
    std::vector<Finding> rows;
    for (std::size_t i = 0; i < n; ++i)
        rows.push_back({.label = point_text(static_cast<double>(i)),
                        .point = curve.control_points()[i],
                        .note = label_text(core::control_point_label(curve.knots(), i))});
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, arguments.number(0));
    for (std::size_t r = 1; r < triangle.levels.size(); ++r)
        for (std::size_t j = 0; j < triangle.levels[r].size(); ++j) {
            const core::DeBoorCell& cell = triangle.levels[r][j];
            rows.push_back({.label = plain_text(cell_text(triangle, r, j, n)),
                            .point = cell.point,
                            .note = label_text(core::de_boor_label(curve.knots(), cell.index, r))});
        }
    const std::string what =
        "has " + count_text(rows.size(), "blossom label", "blossom labels") + ", t = " + number_text(triangle.u);
    return show_rows(state, "Blossom labels", what, std::move(rows));
}

Outcome<void> show_blossom(EditorState& state, const Arguments& arguments) {
    const core::Curve& curve = active_curve(state);
    const std::vector<double>& values = arguments.numbers(0);
    if (values.size() != static_cast<std::size_t>(curve.degree()))
        return tl::unexpected("a blossom of degree " + std::to_string(curve.degree()) + " has as many arguments; " +
                              std::to_string(values.size()) + " were given");
    const double u = curve.knots().into_domain(arguments.number(1));
    const core::HomogeneousPoint value = core::blossom(curve, curve.knots().span_at(u), values);
    std::string label;
    for (const double argument : values) label += (label.empty() ? "b(" : ", ") + number_text(argument);
    Finding finding{.label = label + ")", .numbers = {{"weight", value.z}}};
    if (value.z != 0.0) finding.point = core::project(value);
    return show_rows(state, "Blossom", "has this polar form over the span of " + number_text(u), {std::move(finding)});
}

Outcome<void> show_greville_points(EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    for (const core::GrevillePoint& point : core::greville_points(curve)) {
        Finding finding{.label = "ξ of " + point_text(static_cast<double>(rows.size())), .point = point.curve_point};
        if (curve.domain().contains(point.abscissa)) finding.parameter = point.abscissa;
        finding.numbers.push_back({"abscissa", point.abscissa});
        add_numbers(finding, "control point", point.control_point);
        rows.push_back(std::move(finding));
    }
    const std::string what = "has " + count_text(rows.size(), "Greville point", "Greville points");
    return show_rows(state, "Greville points", what, std::move(rows));
}

}  // namespace

void add_form_commands(std::vector<CommandSpec>& table) {
    table.push_back(measuring_command("closing", "Closing",
                                      "Tells whether the ends meet, the control points are wrapped, or the curve is "
                                      "periodic.",
                                      nullptr, show_closing));
    table.push_back(measuring_command("collinear-runs", "Straight pieces",
                                      "Finds runs of control points on one line and the straight pieces they make.",
                                      nullptr, show_collinear_runs));
    table.push_back(measuring_command(
        "conic-form", "Conic form", "Tells which conic each piece of a quadratic curve is, and its implicit equation.",
        "Forms", show_conic_form));
    table.push_back(measuring_command("cubic-matrix", "Matrix form",
                                      "Gives the coefficients of each segment of a uniform cubic.", "Forms",
                                      show_matrix));
    table.push_back(measuring_command("ferguson", "Ferguson form",
                                      "Gives the ends and end tangents of each segment of a uniform cubic.", "Forms",
                                      show_ferguson));
    table.push_back(measuring_command("anticentroids", "Anticentroids",
                                      "Gives the triangles of neighbouring control points of a uniform cubic, whose "
                                      "anticentroids are its joints.",
                                      "Forms", show_anticentroids));
    CommandSpec labels = measuring_command("blossom-labels", "Blossom labels",
                                           "Names every control point and every point of the construction by the "
                                           "arguments of its blossom.",
                                           "Forms", show_blossom_labels);
    labels.parameters = {{"u", ParameterKind::number, "where in the domain", current_parameter}};
    table.push_back(std::move(labels));
    CommandSpec blossom = measuring_command(
        "blossom", "Blossom", "Gives the polar form of one polynomial piece at any arguments.", "Forms", show_blossom);
    blossom.parameters = {{"arguments", ParameterKind::numbers, "as many as the degree"},
                          {"u", ParameterKind::number, "a parameter of the piece", current_parameter}};
    table.push_back(std::move(blossom));
    table.push_back(measuring_command("greville-points", "Greville points",
                                      "Gives for each control point the parameter at which it acts most.", "Forms",
                                      show_greville_points));
}

}  // namespace batten::editor
