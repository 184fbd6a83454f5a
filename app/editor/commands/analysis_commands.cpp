#include <glm/trigonometric.hpp>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/formula.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/bounds.h"
#include "core/measure/continuity.h"
#include "core/measure/curvature.h"
#include "core/measure/cusps.h"
#include "core/measure/intersect_curves.h"

namespace batten::editor {

namespace {

void add_interval(Finding& finding, core::Interval where) {
    if (where.length() == 0.0) return;
    finding.numbers.push_back({"from", where.lower});
    finding.numbers.push_back({"to", where.upper});
}

std::string level_text(const char* letter, int level) {
    return level < 0 ? "a gap" : plain_text(std::string(letter) + "^{" + std::to_string(level) + "}");
}

// "C⁰ by its knots, C⁰ and G¹ by its shape"; what is found goes up to 2 only.
std::string continuity_note(const core::JointContinuity& joint) {
    const std::string found = joint.parametric < 0 ? "a gap by its shape"
                                                   : level_text("C", joint.parametric) + " and " +
                                                         level_text("G", joint.geometric) + " by its shape";
    if (joint.kind == core::JointKind::ends) return "ends meet, " + found;
    return level_text("C", joint.promised) + " by its knots, " + found;
}

bool is_smoother_than_promised(const core::JointContinuity& joint) {
    return joint.promised < 2 && std::max(joint.parametric, joint.geometric) > joint.promised;
}

std::string joint_label(const core::JointContinuity& joint) {
    switch (joint.kind) {
        case core::JointKind::seam:
            return "seam " + number_text(joint.u);
        case core::JointKind::ends:
            return "ends";
        case core::JointKind::knot:
            break;
    }
    return "knot " + number_text(joint.u);
}

Finding joint_row(const core::Curve& curve, const core::JointContinuity& joint) {
    Finding row{.label = joint_label(joint),
                .parameter = joint.u,
                .point = core::point_at(curve, joint.u),
                .numbers = {{"multiplicity", static_cast<double>(joint.multiplicity)},
                            {"C by knots", static_cast<double>(joint.promised)},
                            {"C found", static_cast<double>(joint.parametric)},
                            {"G found", static_cast<double>(joint.geometric)},
                            {"jump", joint.position.size},
                            {"relative jump", joint.position.relative},
                            {"jump of C'", joint.first.size},
                            {"relative jump of C'", joint.first.relative},
                            {"jump of C''", joint.second.size},
                            {"relative jump of C''", joint.second.relative}},
                .note = continuity_note(joint)};
    if (joint.angle) row.numbers.push_back({"angle in degrees", glm::degrees(*joint.angle)});
    if (joint.before) row.numbers.push_back({"curvature before", *joint.before});
    if (joint.after) row.numbers.push_back({"curvature after", *joint.after});
    return row;
}

Outcome<void> show_continuity(EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    std::size_t smoother = 0;
    for (const core::JointContinuity& joint : core::joint_continuity(curve)) {
        rows.push_back(joint_row(curve, joint));
        if (joint.kind != core::JointKind::ends && is_smoother_than_promised(joint)) ++smoother;
    }
    std::string what = "has " + count_text(rows.size(), "joint", "joints");
    if (smoother > 0) what += "; " + std::to_string(smoother) + " smoother by shape than by the knots";
    return show_rows(state, "Continuity", what, std::move(rows));
}

Outcome<void> show_inflections(EditorState& state, const Arguments&) {
    std::vector<Finding> rows;
    for (const core::Inflection& found : core::inflections(active_curve(state))) {
        Finding row{.label = found.where.length() > 0.0 ? "straight piece" : "inflection",
                    .parameter = found.u,
                    .point = found.point,
                    .note = found.is_jump ? "the curvature jumps from one sign to the other" : ""};
        add_interval(row, found.where);
        rows.push_back(std::move(row));
    }
    const std::string what = "has " + count_text(rows.size(), "inflection", "inflections");
    return show_rows(state, "Inflections", what, std::move(rows));
}

Outcome<void> show_curvature_extrema(EditorState& state, const Arguments&) {
    std::vector<Finding> rows;
    for (const core::CurvatureExtremum& found : core::curvature_extrema(active_curve(state))) {
        Finding row{.label = found.is_maximum ? "maximum" : "minimum",
                    .parameter = found.u,
                    .point = found.point,
                    .numbers = {{"curvature", found.curvature}}};
        if (found.curvature != 0.0) row.numbers.push_back({"radius", 1.0 / found.curvature});
        add_interval(row, found.where);
        rows.push_back(std::move(row));
    }
    const std::string what = "has " + count_text(rows.size(), "extremum", "extrema") + " of curvature";
    return show_rows(state, "Curvature extrema", what, std::move(rows));
}

Outcome<void> show_cusps(EditorState& state, const Arguments&) {
    std::vector<Finding> rows;
    std::size_t proper = 0;
    for (const core::Cusp& found : core::cusps(active_curve(state))) {
        const bool turns = found.turn && std::abs(*found.turn) > core::ContinuityTolerances{}.angle;
        if (turns) ++proper;
        Finding row{.label = turns ? "cusp" : "zero speed", .parameter = found.u, .point = found.point};
        if (found.turn) row.numbers.push_back({"turn in degrees", glm::degrees(*found.turn)});
        add_interval(row, found.where);
        rows.push_back(std::move(row));
    }
    std::string what = "has " + count_text(proper, "cusp", "cusps");
    if (rows.size() > proper) what += " and " + count_text(rows.size() - proper, "other stop", "other stops");
    return show_rows(state, "Cusps", what, std::move(rows));
}

Outcome<void> show_self_intersections(EditorState& state, const Arguments&) {
    std::vector<Finding> rows;
    for (const core::CurveContact& found : core::self_intersections(active_curve(state))) {
        Finding row{.label = found.is_overlap() ? "passed twice" : "double point",
                    .parameter = found.u,
                    .point = found.point,
                    .numbers = {{"second u", found.v}},
                    .note = found.is_tangent && !found.is_overlap() ? "the branches touch" : ""};
        add_interval(row, found.on_first);
        rows.push_back(std::move(row));
    }
    const std::string what = "has " + count_text(rows.size(), "self-intersection", "self-intersections");
    return show_rows(state, "Self-intersections", what, std::move(rows));
}

Finding box_row(const char* label, const core::Box& box) {
    return {.label = label,
            .numbers = {{"left", box.lower.x},
                        {"right", box.upper.x},
                        {"bottom", box.lower.y},
                        {"top", box.upper.y},
                        {"width", box.size().x},
                        {"height", box.size().y}}};
}

Outcome<void> show_bounds(EditorState& state, const Arguments&) {
    const core::Curve& curve = active_curve(state);
    const core::Box box = core::tight_box(curve);
    const std::string what = "is " + number_text(box.size().x) + " wide and " + number_text(box.size().y) + " high";
    return show_rows(state, "Bounds", what,
                     {box_row("curve", box), box_row("control points", core::control_box(curve))});
}

Outcome<void> show_span_hulls(EditorState& state, const Arguments&) {
    std::vector<Finding> rows;
    for (const core::SpanHull& found : core::span_hulls(active_curve(state))) {
        Finding row{.label = "span " + std::to_string(rows.size() + 1), .parameter = found.interval.lower};
        add_interval(row, found.interval);
        for (std::size_t i = 0; i < found.hull.size(); ++i)
            add_numbers(row, "corner " + std::to_string(i + 1), found.hull[i]);
        rows.push_back(std::move(row));
    }
    const std::string what = "lies in " + count_text(rows.size(), "hull", "hulls") + ", one for each span";
    return show_rows(state, "Hulls of the spans", what, std::move(rows));
}

}  // namespace

void add_analysis_commands(std::vector<CommandSpec>& table) {
    table.push_back(measuring_command("continuity", "Continuity",
                                      "Tells at every knot how smooth the curve is by its knots and by its shape.",
                                      nullptr, show_continuity));
    table.push_back(measuring_command("inflections", "Inflections",
                                      "Finds where the curve passes from bending left to bending right.", "Shape",
                                      show_inflections));
    table.push_back(measuring_command("curvature-extrema", "Curvature extrema",
                                      "Finds where the signed curvature is greatest and least.", "Shape",
                                      show_curvature_extrema));
    table.push_back(measuring_command("cusps", "Cusps", "Finds where the speed is zero.", "Shape", show_cusps));
    table.push_back(measuring_command("self-intersections", "Self-intersections",
                                      "Finds the points through which the curve passes twice.", "Shape",
                                      show_self_intersections));
    table.push_back(measuring_command("bounds", "Bounds",
                                      "Gives the smallest box around the curve and that of its control points.",
                                      "Shape", show_bounds));
    table.push_back(measuring_command("span-hulls", "Hulls of the spans",
                                      "Gives the convex hull of the control points of every span.", "Shape",
                                      show_span_hulls));
}

}  // namespace batten::editor
