#include "app/editor/commands/joint_mark_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/kept_joints.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

using core::JointMark;

// Ends nearer than this part of the size of both curves meet.
constexpr double meant_together = 1e-6;

std::optional<Refusal> not_markable(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (is_made_of_points(state)) return "the curve is made of fit points, which have joints of their own";
    return std::nullopt;
}

std::optional<core::CurveEnd> end_at(const core::Curve& curve, double u) {
    if (curve.is_periodic()) return std::nullopt;
    if (u == curve.domain().lower) return core::CurveEnd::start;
    if (u == curve.domain().upper) return core::CurveEnd::end;
    return std::nullopt;
}

core::Point place_of(const core::Document& document, DocumentEnd end) {
    const core::Curve& curve = *document.curves[end.curve].curve;
    return core::point_at(curve, core::parameter_of(curve.domain(), end.end));
}

// The nearest other end that meets this one and belongs to no other joint.
std::optional<DocumentEnd> end_that_meets(const core::Document& document, DocumentEnd own) {
    const core::Box own_box = core::control_box(*document.curves[own.curve].curve);
    std::optional<DocumentEnd> found;
    double least = core::Box::infinity;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (document.curves[i].curve->is_periodic()) continue;
        core::Box box = core::control_box(*document.curves[i].curve);
        box.include(own_box.lower);
        box.include(own_box.upper);
        for (const core::CurveEnd end : {core::CurveEnd::start, core::CurveEnd::end}) {
            const DocumentEnd other{i, end};
            if (other == own || mark_of_end(document.curves[i], end) != nullptr) continue;
            const double distance = core::distance(place_of(document, own), place_of(document, other));
            if (!(distance <= meant_together * core::length(box.size())) || !(distance < least)) continue;
            least = distance;
            found = other;
        }
    }
    return found;
}

void put_end_mark(core::Document& document, DocumentEnd end, std::size_t joint, JointMark mark) {
    auto& ends = document.curves[end.curve].joints.ends;
    const auto old = std::ranges::find(ends, end.end, &core::EndMark::end);
    if (old != ends.end()) {
        old->joint = joint;
        old->mark = mark;
        return;
    }
    ends.push_back({end.end, joint, mark});
    std::ranges::sort(ends, {}, &core::EndMark::end);
}

Outcome<void> mark_end(core::Document& document, core::CurveEnd end, JointMark mark) {
    const DocumentEnd own{document.active, end};
    const auto partner = partner_of(document, own);
    const auto other = partner ? partner : end_that_meets(document, own);
    if (!other) return tl::unexpected(Refusal("no other end meets this one; join or match them first"));
    const core::EndMark* old = mark_of_end(document.curves[own.curve], end);
    const std::size_t joint = partner ? old->joint : free_joint(document);
    put_end_mark(document, own, joint, mark);
    put_end_mark(document, *other, joint, mark);
    return {};
}

void erase_mark(core::Document& document, double u) {
    core::DocumentCurve& entry = document.curves[document.active];
    std::erase_if(entry.joints.knots, [&](const core::KnotMark& mark) { return mark.u == u; });
    const auto end = end_at(*entry.curve, u);
    const core::EndMark* own = end ? mark_of_end(entry, *end) : nullptr;
    if (own == nullptr) return;
    const std::size_t joint = own->joint;
    for (core::DocumentCurve& other : document.curves)
        std::erase_if(other.joints.ends, [&](const core::EndMark& mark) { return mark.joint == joint; });
}

Outcome<void> mark_knot(core::DocumentCurve& entry, double u, JointMark mark) {
    if (!core::is_inner_knot(*entry.curve, u))
        return tl::unexpected(
            core::sentence("u = {u} is no knot; insert one there first", {{"u", core::shortest_text(u)}}));
    const auto place = std::ranges::lower_bound(entry.joints.knots, u, {}, &core::KnotMark::u);
    if (place != entry.joints.knots.end() && place->u == u)
        place->mark = mark;
    else
        entry.joints.knots.insert(place, {u, mark});
    return {};
}

// The seam of a periodic curve has the parameter where its period begins.
double knot_meant(const core::Curve& curve, double u) {
    return curve.is_periodic() && u == curve.domain().upper ? curve.domain().lower : u;
}

Outcome<Edit> mark_joint(const EditorState& state, const MarkJoint& command) {
    Edit edit{state.history.present()};
    core::DocumentCurve& entry = edit.document.curves[edit.document.active];
    const double u = knot_meant(*entry.curve, command.u);
    const auto end = end_at(*entry.curve, u);
    const auto marked = end ? mark_end(edit.document, *end, command.mark) : mark_knot(entry, u, command.mark);
    if (!marked) return tl::unexpected(marked.error());
    core::Document kept = edit.document;
    if (!keep_marked_joints(state.history.present(), kept).empty())
        return tl::unexpected(core::sentence("the curve cannot be made {mark} at u = {u}",
                                             {{"mark", core::title_of(command.mark)}, {"u", core::shortest_text(u)}}));
    edit.document = std::move(kept);
    return edit;
}

Outcome<Edit> unmark_joint(const EditorState& state, const UnmarkJoint& command) {
    const double u = knot_meant(active_curve(state), command.u);
    if (!mark_at(state, u))
        return tl::unexpected(
            core::sentence("the joint at u = {u} has no mark", {{"u", core::shortest_text(command.u)}}));
    Edit edit{state.history.present()};
    erase_mark(edit.document, u);
    return edit;
}

// Of the selected knot, else of the handlebar.
std::optional<double> joint_meant(const EditorState& state) {
    if (const auto u = suggest::selected_knot_value(state)) return u;
    return state.selection.handlebar;
}

std::optional<Refusal> no_joint_meant(const EditorState& state) {
    if (std::optional<Refusal> refusal = not_markable(state)) return refusal;
    if (!joint_meant(state)) return "no knot is selected";
    return std::nullopt;
}

template <JointMark mark>
Outcome<Edit> mark_as(const EditorState& state, const MarkAs<mark>&) {
    return mark_joint(state, {.mark = mark, .u = *joint_meant(state)});
}

template <JointMark mark>
bool is_marked_as(const EditorState& state) {
    return !no_joint_meant(state) && mark_at(state, knot_meant(active_curve(state), *joint_meant(state))) == mark;
}

StepTexts texts_of_marking(const EditorState&, const MarkJoint& command) {
    const core::Place u("u", core::shortest_text(command.u));
    const core::Place mark("mark", core::title_of(command.mark));
    return {core::sentence("Mark joint {mark}", {mark}),
            core::sentence("Marked the joint at u = {u} {mark}", {u, mark})};
}

template <JointMark mark>
StepTexts texts_of_marking_as(const EditorState& state, const MarkAs<mark>&) {
    return texts_of_marking(state, {.mark = mark, .u = *joint_meant(state)});
}

template <JointMark mark>
CommandSpec marking(const char* name, const char* title, const char* explanation) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = "joint knot smooth",
            .group = CommandGroup::curve,
            .submenu = "Marked joints",
            .offered = in_the_window,
            .effect = ShapeEffect::changes,
            .refusal = no_joint_meant,
            .is_checked = is_marked_as<mark>,
            .run = body_of<mark_as<mark>>,
            .texts = texts_of<texts_of_marking_as<mark>>};
}

}  // namespace

std::optional<JointMark> mark_at(const EditorState& state, double u) {
    const core::DocumentCurve& entry = *state.history.present().active_curve();
    if (const auto end = end_at(*entry.curve, u)) {
        const core::EndMark* mark = mark_of_end(entry, *end);
        return mark == nullptr ? std::nullopt : std::optional(mark->mark);
    }
    return mark_of_knot(entry, u);
}

const CommandSpec& MarkJoint::spec() {
    static const CommandSpec spec{
        .name = "mark-joint",
        .title = "Mark joint",
        .explanation =
            "Makes a knot, or two ends that meet, a corner, smooth (G1) or curvature-smooth (G2), and has edits keep "
            "it.",
        .synonyms = "smooth corner G1 G2 continuity keep node",
        .group = CommandGroup::curve,
        .submenu = "Marked joints",
        .effect = ShapeEffect::changes,
        .fields = {field::choice<&MarkJoint::mark>("mark", "what edits keep there"),
                   field::parameter<&MarkJoint::u>("u", "a knot, or an end that meets another end")
                       .suggesting<joint_meant>()},
        .refusal = not_markable,
        .run = body_of<mark_joint>,
        .texts = texts_of<texts_of_marking>};
    return spec;
}

const CommandSpec& UnmarkJoint::spec() {
    static const CommandSpec spec{
        .name = "unmark-joint",
        .title = "Unmark joint",
        .explanation = "Lets edits change the joint again.",
        .synonyms = "free smooth corner",
        .group = CommandGroup::curve,
        .submenu = "Marked joints",
        .fields = {field::parameter<&UnmarkJoint::u>("u", "a marked knot or end").suggesting<joint_meant>()},
        .refusal = not_markable,
        .run = body_of<unmark_joint>,
        .done = "Unmarked the joint at u = {u}"};
    return spec;
}

template <>
const CommandSpec& MarkAs<JointMark::corner>::spec() {
    static const CommandSpec spec = marking<JointMark::corner>(
        "mark-corner", "Keep corner", "Lets the curve turn at the selected knot; ends only stay together.");
    return spec;
}

template <>
const CommandSpec& MarkAs<JointMark::smooth>::spec() {
    static const CommandSpec spec = marking<JointMark::smooth>(
        "mark-smooth", "Keep smooth (G1)", "Makes the curve smooth at the selected knot, and has edits keep it so.");
    return spec;
}

template <>
const CommandSpec& MarkAs<JointMark::curvature>::spec() {
    static const CommandSpec spec =
        marking<JointMark::curvature>("mark-curvature", "Keep curvature (G2)",
                                      "Makes the curvature agree at the selected knot, and has edits keep it so.");
    return spec;
}

void add_joint_mark_commands(CommandTable& table) {
    using enum JointMark;
    add_all<MarkJoint, MarkAs<corner>, MarkAs<smooth>, MarkAs<curvature>, UnmarkJoint>(table);
}

}  // namespace batten::editor
