#include "app/editor/commands/analysis_commands.h"

#include <fmt/core.h>

#include <glm/trigonometric.hpp>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/words/continuity_words.h"
#include "app/editor/words/length.h"
#include "app/editor/words/refusal.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/bounds.h"
#include "core/measure/continuity.h"
#include "core/measure/curvature.h"
#include "core/measure/cusps.h"
#include "core/measure/intersect_curves.h"

namespace batten::editor {

namespace {

using core::sentence;

bool is_smoother_than_promised(const core::JointContinuity& joint) {
    return joint.promised < 2 && std::max(joint.parametric, joint.geometric) > joint.promised;
}

std::string joint_label(const core::JointContinuity& joint) {
    const core::Place u("u", core::shortest_text(joint.u));
    switch (joint.kind) {
        case core::JointKind::seam:
            return sentence("seam {u}", {u});
        case core::JointKind::ends:
        case core::JointKind::curves:
            return "ends";
        case core::JointKind::knot:
            break;
    }
    return sentence("knot {u}", {u});
}

// A jump is as uncertain as what it is relative to.
FoundNumber jump_number(const char* name, const core::Jump& jump) {
    return {name, jump.size, jump.relative > 0.0 ? rounding_error * jump.size / jump.relative : 0.0, 1};
}

Finding continuity_row(const core::Curve& curve, const core::JointContinuity& joint) {
    Finding row{.label = joint_label(joint),
                .parameter = joint.u,
                .point = core::point_at(curve, joint.u),
                .numbers = {{"multiplicity", static_cast<double>(joint.multiplicity)},
                            {"C by knots", static_cast<double>(joint.promised)},
                            {"C found", static_cast<double>(joint.parametric)},
                            {"G found", static_cast<double>(joint.geometric)},
                            jump_number("jump", joint.position),
                            {"relative jump", joint.position.relative, rounding_error},
                            jump_number("jump of C'", joint.first),
                            {"relative jump of C'", joint.first.relative, rounding_error},
                            jump_number("jump of C''", joint.second),
                            {"relative jump of C''", joint.second.relative, rounding_error}},
                .note = continuity_verdict(joint)};
    if (joint.angle) row.numbers.push_back({"angle in degrees", glm::degrees(*joint.angle), 180.0 * rounding_error});
    if (joint.before) row.numbers.push_back({"curvature before", *joint.before, 0.0, -1});
    if (joint.after) row.numbers.push_back({"curvature after", *joint.after, 0.0, -1});
    return row;
}

Outcome<void> find_continuity(EditorState& state, const FindContinuity&) {
    const core::Curve& curve = active_curve(state);
    std::vector<Finding> rows;
    std::size_t smoother = 0;
    for (const core::JointContinuity& joint : core::joint_continuity(curve)) {
        rows.push_back(continuity_row(curve, joint));
        if (joint.kind != core::JointKind::ends && is_smoother_than_promised(joint)) ++smoother;
    }
    if (smoother == 0)
        return show_counted_rows(
            state, "Continuity",
            {.one = "{name} has 1 joint", .many = "{name} has {count} joints", .none = "{name} has no joints"},
            std::move(rows));
    std::string summary =
        sentence({.one = "{name} has 1 joint; {smoother} smoother by shape than by the knots",
                  .many = "{name} has {count} joints; {smoother} smoother by shape than by the knots"},
                 rows.size(), {active_name(state), {"smoother", smoother}});
    return show_rows(state, "Continuity", std::move(summary), std::move(rows));
}

Outcome<void> find_inflections(EditorState& state, const FindInflections&) {
    std::vector<Finding> rows;
    for (const core::Inflection& found : core::inflections(active_curve(state))) {
        Finding row{.label = found.where.length() > 0.0 ? "straight piece" : "inflection",
                    .parameter = found.u,
                    .point = found.point,
                    .note = found.is_jump ? "the curvature jumps from one sign to the other" : ""};
        add_interval(row, found.where);
        rows.push_back(std::move(row));
    }
    return show_counted_rows(state, "Inflections",
                             {.one = "{name} has 1 inflection",
                              .many = "{name} has {count} inflections",
                              .none = "{name} has no inflections"},
                             std::move(rows));
}

Outcome<void> find_curvature_extrema(EditorState& state, const FindCurvatureExtrema&) {
    std::vector<Finding> rows;
    for (const core::CurvatureExtremum& found : core::curvature_extrema(active_curve(state))) {
        Finding row{.label = found.is_maximum ? "maximum" : "minimum",
                    .parameter = found.u,
                    .point = found.point,
                    .numbers = {{"curvature", found.curvature, 0.0, -1}}};
        if (found.curvature != 0.0) row.numbers.push_back({"radius", 1.0 / found.curvature, 0.0, 1});
        add_interval(row, found.where);
        rows.push_back(std::move(row));
    }
    return show_counted_rows(state, "Curvature extrema",
                             {.one = "{name} has 1 extremum of curvature",
                              .many = "{name} has {count} extrema of curvature",
                              .none = "{name} has no extrema of curvature"},
                             std::move(rows));
}

std::string summary_of_cusps(const EditorState& state, std::size_t cusps, std::size_t stops) {
    if (stops == 0)
        return sentence({.one = "{name} has 1 cusp", .many = "{name} has {count} cusps", .none = "{name} has no cusps"},
                        cusps, {active_name(state)});
    const core::Place found("cusps", sentence({.one = "1 cusp", .many = "{count} cusps", .none = "no cusps"}, cusps));
    return sentence(
        {.one = "{name} has {cusps} and 1 other stop", .many = "{name} has {cusps} and {count} other stops"}, stops,
        {active_name(state), found});
}

Outcome<void> find_cusps(EditorState& state, const FindCusps&) {
    std::vector<Finding> rows;
    std::size_t proper = 0;
    for (const core::Cusp& found : core::cusps(active_curve(state))) {
        const bool turns = found.turn && std::abs(*found.turn) > core::ContinuityTolerances{}.angle;
        if (turns) ++proper;
        Finding row{.label = turns ? "cusp" : "zero speed", .parameter = found.u, .point = found.point};
        if (found.turn) row.numbers.push_back({"turn in degrees", glm::degrees(*found.turn), 180.0 * rounding_error});
        add_interval(row, found.where);
        rows.push_back(std::move(row));
    }
    std::string summary = summary_of_cusps(state, proper, rows.size() - proper);
    return show_rows(state, "Cusps", std::move(summary), std::move(rows));
}

constexpr core::PluralPattern all_self_intersections{.one = "{name} has 1 self-intersection",
                                                     .many = "{name} has {count} self-intersections",
                                                     .none = "{name} has no self-intersections"};
constexpr core::PluralPattern some_self_intersections{
    .one = "{name} has at least 1 self-intersection; parts of it are too close together to tell all",
    .many = "{name} has at least {count} self-intersections; parts of it are too close together to tell all",
    .none = "parts of {name} are too close together to tell whether they meet"};

Outcome<void> find_self_intersections(EditorState& state, const FindSelfIntersections&) {
    std::vector<Finding> rows;
    const core::CurveContacts found = core::self_intersections(active_curve(state), state.progress);
    for (const core::CurveContact& contact : found.contacts) {
        Finding row{.label = contact.is_overlap() ? "passed twice" : "double point",
                    .parameter = contact.u,
                    .point = contact.point,
                    .numbers = {{"second u", contact.v}},
                    .note = contact.is_tangent && !contact.is_overlap() ? "the branches touch" : ""};
        add_interval(row, contact.on_first);
        rows.push_back(std::move(row));
    }
    return show_counted_rows(state, "Self-intersections",
                             found.is_complete ? all_self_intersections : some_self_intersections, std::move(rows));
}

Finding box_row(const char* label, const core::Box& box) {
    return {.label = label,
            .numbers = {{"left", box.lower.x, 0.0, 1},
                        {"right", box.upper.x, 0.0, 1},
                        {"bottom", box.lower.y, 0.0, 1},
                        {"top", box.upper.y, 0.0, 1},
                        {"width", box.size().x, 0.0, 1},
                        {"height", box.size().y, 0.0, 1}}};
}

Outcome<void> find_bounds(EditorState& state, const FindBounds&) {
    const core::Curve& curve = active_curve(state);
    const core::Box box = core::tight_box(curve);
    if (box.is_empty()) return refused(state, {.code = core::CurveErrorCode::not_computable});
    const Units& units = units_of(state);
    std::string summary =
        sentence("{name} is {width} wide and {height} high", {active_name(state),
                                                              {"width", length_words(units, box.size().x)},
                                                              {"height", length_words(units, box.size().y)}});
    return show_rows(state, "Bounds", std::move(summary),
                     {box_row("curve", box), box_row("control points", core::control_box(curve))});
}

Outcome<void> find_span_hulls(EditorState& state, const FindSpanHulls&) {
    std::vector<Finding> rows;
    const double error = coordinate_error(active_curve(state));
    for (const core::SpanHull& found : core::span_hulls(active_curve(state))) {
        Finding row{.label = sentence("span {number}", {{"number", rows.size() + 1}}),
                    .parameter = found.interval.lower};
        add_interval(row, found.interval);
        for (std::size_t i = 0; i < found.hull.size(); ++i)
            add_numbers(row, fmt::format("corner {}", i + 1).c_str(), found.hull[i], error);
        rows.push_back(std::move(row));
    }
    return show_counted_rows(
        state, "Hulls of the spans",
        {.one = "{name} lies in 1 hull, one for each span", .many = "{name} lies in {count} hulls, one for each span"},
        std::move(rows));
}

}  // namespace

const CommandSpec& FindContinuity::spec() {
    static const CommandSpec spec{
        .name = "continuity",
        .title = "Continuity",
        .explanation = "Shows, at each knot, how smooth the curve is by its knots and by its shape.",
        .synonyms = "smooth joints C1 C2 G1 G2",
        .group = CommandGroup::analyze,
        .refusal = no_curve,
        .run = body_of<find_continuity>};
    return spec;
}

const CommandSpec& FindInflections::spec() {
    static const CommandSpec spec{.name = "inflections",
                                  .title = "Inflections",
                                  .explanation = "Finds where the curve passes from bending left to bending right.",
                                  .synonyms = "curvature zero",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Shape",
                                  .refusal = no_curve,
                                  .run = body_of<find_inflections>};
    return spec;
}

const CommandSpec& FindCurvatureExtrema::spec() {
    static const CommandSpec spec{.name = "curvature-extrema",
                                  .title = "Curvature extrema",
                                  .explanation = "Finds where the signed curvature is greatest and least.",
                                  .synonyms = "vertices maximum minimum radius",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Shape",
                                  .refusal = no_curve,
                                  .run = body_of<find_curvature_extrema>};
    return spec;
}

const CommandSpec& FindCusps::spec() {
    static const CommandSpec spec{.name = "cusps",
                                  .title = "Cusps",
                                  .explanation = "Finds where the speed is zero.",
                                  .synonyms = "stop singular",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Shape",
                                  .refusal = no_curve,
                                  .run = body_of<find_cusps>};
    return spec;
}

const CommandSpec& FindSelfIntersections::spec() {
    static const CommandSpec spec{.name = "self-intersections",
                                  .title = "Self-intersections",
                                  .explanation = "Finds the points through which the curve passes twice.",
                                  .synonyms = "loop double point crossing",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Shape",
                                  .refusal = no_curve,
                                  .run = body_of<find_self_intersections>,
                                  .at_work = "Seeking self-intersections"};
    return spec;
}

const CommandSpec& FindBounds::spec() {
    static const CommandSpec spec{
        .name = "bounds",
        .title = "Bounds",
        .explanation = "Gives the smallest box around the curve and that of its control points.",
        .synonyms = "box size width height",
        .group = CommandGroup::analyze,
        .submenu = "Shape",
        .refusal = no_curve,
        .run = body_of<find_bounds>};
    return spec;
}

const CommandSpec& FindSpanHulls::spec() {
    static const CommandSpec spec{.name = "span-hulls",
                                  .title = "Hulls of the spans",
                                  .explanation = "Gives the convex hull of the control points of every span.",
                                  .synonyms = "convex polygon",
                                  .group = CommandGroup::analyze,
                                  .submenu = "Shape",
                                  .refusal = no_curve,
                                  .run = body_of<find_span_hulls>};
    return spec;
}

void add_analysis_commands(CommandTable& table) {
    add_all<FindContinuity, FindInflections, FindCurvatureExtrema, FindCusps, FindSelfIntersections>(table);
    add_all<FindBounds, FindSpanHulls>(table);
}

}  // namespace batten::editor
