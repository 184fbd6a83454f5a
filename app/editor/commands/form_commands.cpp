#include "app/editor/commands/form_commands.h"

#include <fmt/format.h>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/cell_names.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
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

using core::sentence;

std::string summary_of_closing(const EditorState& state, const core::ClosingReport& report) {
    switch (report.closing) {
        case core::Closing::open:
            return sentence("{name} is open; its ends are {gap} apart",
                            {active_name(state), {"gap", length_words(units_of(state), report.gap)}});
        case core::Closing::ends_meet:
            return sentence("{name} is closed by ends that meet", {active_name(state)});
        case core::Closing::wrapped:
            return sentence("{name} is closed by wrapped control points", {active_name(state)});
        case core::Closing::periodic:
            break;
    }
    return sentence("{name} is truly periodic", {active_name(state)});
}

Outcome<void> find_closing(EditorState& state, const FindClosing&) {
    const core::Curve& curve = active_curve(state);
    const core::ClosingReport report = core::closing_of(curve);
    const double start = curve.domain().lower;
    Finding finding{.label = core::title_of(report.closing),
                    .parameter = start,
                    .point = core::point_at(curve, start),
                    .numbers = {{"gap", report.gap, coordinate_error(curve), 1},
                                {"continuity", static_cast<double>(report.continuity)}}};
    return show_rows(state, "Closing", summary_of_closing(state, report), {std::move(finding)});
}

Finding row_of(const core::Curve& curve, const core::CollinearRun& run) {
    const std::size_t last = (run.first + run.count - 1) % curve.control_points().size();
    Finding row{.label = sentence("{first} to {last}", {{"first", point_text(run.first)}, {"last", point_text(last)}}),
                .parameter = run.straight.lower,
                .point = core::point_at(curve, run.straight.lower),
                .numbers = {{"points", static_cast<double>(run.count)}}};
    row.numbers.push_back({"from", run.straight.lower});
    row.numbers.push_back({"to", run.straight.upper});
    return row;
}

Outcome<void> find_collinear_runs(EditorState& state, const FindCollinearRuns&) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    for (const core::CollinearRun& run : core::collinear_runs(curve)) rows.push_back(row_of(curve, run));
    return show_counted_rows(state, "Straight pieces",
                             {.one = "{name} has 1 straight piece",
                              .many = "{name} has {count} straight pieces",
                              .none = "{name} has no straight pieces"},
                             std::move(rows));
}

std::string segment_label(std::size_t index) {
    return sentence("segment {index}", {{"index", index}});
}

Outcome<void> find_matrix_form(EditorState& state, const FindMatrixForm&) {
    const core::Curve& curve = active_curve(state);
    const auto segments = core::cubic_segments(curve);
    if (!segments) return refused(state, segments.error());
    std::vector<Finding> rows;
    for (const core::CubicSegment& segment : *segments) {
        Finding finding{.label = segment_label(rows.size()),
                        .parameter = segment.interval.lower,
                        .point = core::point_at(curve, segment.interval.lower),
                        .note = "a₀ + a₁ t + a₂ t² + a₃ t³, t from 0 to 1"};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::string name = fmt::format("a{}", k);
            const core::HomogeneousPoint& coefficient = segment.coefficients[k];
            add_numbers(finding, name.c_str(), core::plane_part(coefficient));
            if (curve.is_rational()) finding.numbers.push_back({fmt::format("{} w", name), coefficient.z});
        }
        rows.push_back(std::move(finding));
    }
    state.view.overlays.show(Overlay::cubic_matrix, true);
    return show_counted_rows(
        state, "Matrix form",
        {.one = "{name} has 1 segment in matrix form", .many = "{name} has {count} segments in matrix form"},
        std::move(rows));
}

Outcome<void> find_ferguson_form(EditorState& state, const FindFergusonForm&) {
    const auto segments = core::ferguson_segments(active_curve(state));
    if (!segments) return refused(state, segments.error());
    std::vector<Finding> rows;
    const double error = coordinate_error(active_curve(state));
    for (const core::FergusonSegment& segment : *segments) {
        Finding finding{
            .label = segment_label(rows.size()), .parameter = segment.interval.lower, .point = segment.start};
        add_numbers(finding, "start", segment.start, error);
        add_numbers(finding, "end", segment.end, error);
        add_numbers(finding, "start tangent", segment.start_tangent);
        add_numbers(finding, "end tangent", segment.end_tangent);
        rows.push_back(std::move(finding));
    }
    state.view.overlays.show(Overlay::ferguson, true);
    return show_counted_rows(
        state, "Ferguson form",
        {.one = "{name} has 1 segment in Ferguson form", .many = "{name} has {count} segments in Ferguson form"},
        std::move(rows));
}

Outcome<void> find_anticentroids(EditorState& state, const FindAnticentroids&) {
    const auto joints = core::anticentroids(active_curve(state));
    if (!joints) return refused(state, joints.error());
    std::vector<Finding> rows;
    const double error = coordinate_error(active_curve(state));
    for (const core::Anticentroid& joint : *joints) {
        Finding finding{.label = sentence("triangle at {point}", {{"point", point_text(joint.index)}}),
                        .parameter = joint.u,
                        .point = joint.anticentroid};
        add_numbers(finding, "anticentroid", joint.anticentroid, error);
        add_numbers(finding, "vertex", joint.vertex, error);
        add_numbers(finding, "middle of base", joint.base_middle, error);
        add_numbers(finding, "tangent", joint.tangent);
        add_numbers(finding, "second derivative", joint.second_derivative);
        rows.push_back(std::move(finding));
    }
    state.view.overlays.show(Overlay::anticentroids, true);
    return show_counted_rows(state, "Anticentroids",
                             {.one = "{name} has 1 anticentroid",
                              .many = "{name} has {count} anticentroids",
                              .none = "{name} has no anticentroids"},
                             std::move(rows));
}

Finding row_of(const core::ConicForm& form, double error) {
    const core::ImplicitConic& k = form.equation;
    Finding row{.label = core::title_of(form.type),
                .point = form.shoulder,
                .numbers = {{"w", form.weight},
                            {"w/(1+w)", form.shoulder_ratio},
                            {"A", k.a},
                            {"B", k.b},
                            {"C", k.c},
                            {"D", k.d},
                            {"E", k.e},
                            {"F", k.f}},
                .note = "A X² + B XY + C Y² + D X + E Y + F = 0, (X, Y) seen from the origin given"};
    add_numbers(row, "origin", k.origin, error);
    return row;
}

Outcome<void> find_conic_form(EditorState& state, const FindConicForm&) {
    std::vector<Finding> rows;
    const double error = coordinate_error(active_curve(state));
    for (const core::BezierPiece& piece : core::bezier_pieces(active_curve(state))) {
        const auto form = core::conic_form(piece);
        if (!form && form.error().code != core::CurveErrorCode::points_collinear) return refused(state, form.error());
        rows.push_back(form ? row_of(*form, error)
                            : Finding{.label = "straight line", .parameter = piece.interval.lower});
    }
    return show_counted_rows(state, "Conic form",
                             {.one = "{name} has 1 conic piece", .many = "{name} has {count} conic pieces"},
                             std::move(rows));
}

std::string label_text(const core::BlossomLabel& label) {
    return fmt::format("{} = {}", core::symbolic_text(label), core::value_text(label));
}

std::vector<Finding> rows_of(const NamedTriangle& named) {
    std::vector<Finding> rows;
    for (std::size_t r = 1; r < named.triangle.levels.size(); ++r)
        for (std::size_t j = 0; j < named.triangle.levels[r].size(); ++j) {
            const core::DeBoorCell& cell = named.triangle.levels[r][j];
            rows.push_back({.label = plain_text(named.point({r, j})),
                            .point = cell.point,
                            .note = label_text(core::de_boor_label(named.curve.knots(), cell.index, r))});
        }
    return rows;
}

Outcome<void> find_blossom_labels(EditorState& state, const FindBlossomLabels& command) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    for (std::size_t i = 0; i < curve.control_points().size(); ++i)
        rows.push_back({.label = point_text(i),
                        .point = curve.control_points()[i],
                        .note = label_text(core::control_point_label(curve.knots(), i))});
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, command.u);
    for (Finding& row : rows_of({curve, triangle, state.view.notation})) rows.push_back(std::move(row));
    std::string summary =
        sentence("{name} has {count} blossom labels, t = {t}",
                 {active_name(state), {"count", rows.size()}, {"t", core::shortest_text(triangle.u)}});
    return show_rows(state, "Blossom labels", std::move(summary), std::move(rows));
}

// "b(0.1, 0.2, 0.3)"
std::string blossom_text(const std::vector<double>& arguments) {
    std::vector<std::string> texts;
    for (const double argument : arguments) texts.push_back(core::shortest_text(argument));
    return fmt::format("b({})", fmt::join(texts, ", "));
}

Outcome<void> find_blossom(EditorState& state, const FindBlossom& command) {
    const core::Curve& curve = active_curve(state);
    if (command.arguments.size() != static_cast<std::size_t>(curve.degree()))
        return tl::unexpected(sentence("a blossom of degree {degree} has {degree} arguments; found {count}",
                                       {{"degree", curve.degree()}, {"count", command.arguments.size()}}));
    const double u = curve.knots().into_domain(command.u);
    const core::HomogeneousPoint value = core::blossom(curve, curve.knots().span_at(u), command.arguments);
    Finding finding{.label = blossom_text(command.arguments), .numbers = {{"weight", value.z}}};
    if (value.z != 0.0) finding.point = core::project(value);
    std::string summary = sentence("{name} has this polar form over the span of {u}",
                                   {active_name(state), {"u", core::shortest_text(u)}});
    return show_rows(state, "Blossom", std::move(summary), {std::move(finding)});
}

// A control point beyond an unclamped end acts most where the curve is no longer drawn.
std::string outside_note(const core::Curve& curve) {
    return sentence(
        "outside the domain from {lower} to {upper}; the curve does not go so far",
        {{"lower", core::shortest_text(curve.domain().lower)}, {"upper", core::shortest_text(curve.domain().upper)}});
}

Outcome<void> find_greville_points(EditorState& state, const FindGrevillePoints&) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    const double error = coordinate_error(curve);
    for (const core::GrevillePoint& point : core::greville_points(curve)) {
        Finding finding{.label = sentence("ξ of {point}", {{"point", point_text(rows.size())}}),
                        .point = point.curve_point};
        if (curve.domain().contains(point.abscissa))
            finding.parameter = point.abscissa;
        else
            finding.note = outside_note(curve);
        finding.numbers.push_back({"abscissa", point.abscissa});
        add_numbers(finding, "control point", point.control_point, error);
        rows.push_back(std::move(finding));
    }
    return show_counted_rows(state, "Greville points",
                             {.one = "{name} has 1 Greville point", .many = "{name} has {count} Greville points"},
                             std::move(rows));
}

}  // namespace

const CommandSpec& FindClosing::spec() {
    static const CommandSpec spec{
        .name = "closing",
        .title = "Closing",
        .explanation = "Says whether the ends meet, the control points are wrapped, or the curve is periodic.",
        .synonyms = "closed open",
        .group = CommandGroup::analyze,
        .refusal = no_curve,
        .run = body_of<find_closing>};
    return spec;
}

const CommandSpec& FindCollinearRuns::spec() {
    static const CommandSpec spec{
        .name = "collinear-runs",
        .title = "Straight pieces",
        .explanation = "Finds runs of control points on one line and the straight pieces they make.",
        .synonyms = "line",
        .group = CommandGroup::analyze,
        .refusal = no_curve,
        .run = body_of<find_collinear_runs>};
    return spec;
}

const CommandSpec& FindConicForm::spec() {
    static const CommandSpec spec{
        .name = "conic-form",
        .title = "Conic form",
        .explanation = "Says which conic each piece of a quadratic curve is, with its implicit equation.",
        .synonyms = "ellipse parabola hyperbola",
        .group = CommandGroup::analyze,
        .submenu = "Forms",
        .refusal = no_curve,
        .run = body_of<find_conic_form>};
    return spec;
}

const CommandSpec& FindMatrixForm::spec() {
    static const CommandSpec spec{
        .name = "cubic-matrix",
        .title = "Matrix form",
        .explanation = "Gives the coefficients of each segment of a uniform cubic, and shows the matrix.",
        .synonyms = "Coons power polynomial",
        .group = CommandGroup::analyze,
        .submenu = "Forms",
        .refusal = no_curve,
        .run = body_of<find_matrix_form>};
    return spec;
}

const CommandSpec& FindFergusonForm::spec() {
    static const CommandSpec spec{
        .name = "ferguson",
        .title = "Ferguson form",
        .explanation = "Gives the ends and end tangents of each segment of a uniform cubic, and shows them.",
        .synonyms = "Hermite",
        .group = CommandGroup::analyze,
        .submenu = "Forms",
        .refusal = no_curve,
        .run = body_of<find_ferguson_form>};
    return spec;
}

const CommandSpec& FindAnticentroids::spec() {
    static const CommandSpec spec{
        .name = "anticentroids",
        .title = "Anticentroids",
        .explanation =
            "Gives and shows the triangles of neighboring control points of a uniform cubic, whose anticentroids are "
            "its joints.",
        .synonyms = "median",
        .group = CommandGroup::analyze,
        .submenu = "Forms",
        .refusal = no_curve,
        .run = body_of<find_anticentroids>};
    return spec;
}

const CommandSpec& FindBlossomLabels::spec() {
    static const CommandSpec spec{
        .name = "blossom-labels",
        .title = "Blossom labels",
        .explanation =
            "Names every control point and every point of the construction by the arguments of its "
            "blossom.",
        .synonyms = "polar",
        .group = CommandGroup::analyze,
        .submenu = "Forms",
        .fields = {field::parameter<&FindBlossomLabels::u>("u", "where in the domain")
                       .suggesting<suggest::current_parameter>()},
        .refusal = no_curve,
        .run = body_of<find_blossom_labels>};
    return spec;
}

const CommandSpec& FindBlossom::spec() {
    static const CommandSpec spec{
        .name = "blossom",
        .title = "Blossom",
        .explanation = "Gives the polar form of one polynomial piece at any arguments.",
        .synonyms = "polar",
        .group = CommandGroup::analyze,
        .submenu = "Forms",
        .fields = {field::parameters<&FindBlossom::arguments>("arguments", "as many as the degree"),
                   field::parameter<&FindBlossom::u>("u", "a parameter of the piece")
                       .suggesting<suggest::current_parameter>()},
        .refusal = no_curve,
        .run = body_of<find_blossom>};
    return spec;
}

const CommandSpec& FindGrevillePoints::spec() {
    static const CommandSpec spec{.name = "greville-points",
                                  .title = "Greville points",
                                  .explanation = "Gives, for each control point, the parameter at which it acts most.",
                                  .synonyms = "abscissae nodes",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Forms",
                                  .refusal = no_curve,
                                  .run = body_of<find_greville_points>};
    return spec;
}

void add_form_commands(CommandTable& table) {
    add_all<FindClosing, FindCollinearRuns, FindConicForm, FindMatrixForm, FindFergusonForm>(table);
    add_all<FindAnticentroids, FindBlossomLabels, FindBlossom, FindGrevillePoints>(table);
}

}  // namespace batten::editor
