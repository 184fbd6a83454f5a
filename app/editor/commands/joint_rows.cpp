#include "app/editor/commands/joint_rows.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "app/editor/commands/joint_report.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr double share_of_document = 1e-3;

bool is_start(const core::Document& document, const core::JointPlace& place) {
    return place.u == document.curves[place.curve].curve->domain().lower;
}

std::string label_of(const core::Document& document, const core::Joint& joint) {
    const core::Place first("first", document.curves[joint.first.curve].name);
    const core::Place second("second", document.curves[joint.second.curve].name);
    if (!joint.first.is_end)
        return sentence("u = {u} of '{first}'", {first, {"u", core::shortest_text(joint.first.u)}});
    if (joint.first.curve == joint.second.curve) return sentence("both ends of '{first}'", {first});
    const bool starts = is_start(document, joint.first);
    if (is_start(document, joint.second))
        return starts ? sentence("start of '{first}' to start of '{second}'", {first, second})
                      : sentence("end of '{first}' to start of '{second}'", {first, second});
    return starts ? sentence("start of '{first}' to end of '{second}'", {first, second})
                  : sentence("end of '{first}' to end of '{second}'", {first, second});
}

void add_number(Finding& row, const char* name, const std::optional<double>& value, double error, int power) {
    if (value) row.numbers.push_back({name, *value, error, power});
}

}  // namespace

std::vector<core::Joint> joints_of_document(const core::Document& document, double tolerance) {
    std::vector<const core::Curve*> curves;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (!document.curves[i].visible) continue;
        curves.push_back(document.curves[i].curve.get());
        indices.push_back(i);
    }
    std::vector<core::Joint> joints = core::joints_of(curves, tolerance);
    for (core::Joint& joint : joints)
        for (core::JointPlace* place : {&joint.first, &joint.second}) place->curve = indices[place->curve];
    return joints;
}

double usual_joint_tolerance(const core::Document& document) {
    core::Box box;
    for (const core::DocumentCurve& entry : document.curves) {
        if (!entry.visible) continue;
        const core::Box own = core::control_box(*entry.curve);
        box.include(own.lower);
        box.include(own.upper);
    }
    const double size = box.is_empty() ? 0.0 : core::robust_length(box.size());
    return size > 0.0 ? share_of_document * size : share_of_document;
}

Finding joint_row(const core::Document& document, const core::Joint& joint) {
    const core::Meeting& meeting = joint.meeting;
    Finding row{.label = label_of(document, joint), .point = joint.place, .note = level_text(joint.level)};
    if (joint.first.curve == document.active) row.parameter = joint.first.u;
    row.numbers.push_back({"level", static_cast<double>(joint.level)});
    row.numbers.push_back({"gap", meeting.gap, 0.0, 1});
    if (meeting.angle) row.numbers.push_back({"turn in degrees", *meeting.angle * 180.0 / std::numbers::pi, 1e-10});
    add_number(row, "curvature before", meeting.before, meeting.curvature_noise, -1);
    add_number(row, "curvature behind", meeting.after, meeting.curvature_noise, -1);
    add_number(row, "change before", meeting.change_before, meeting.change_noise, -2);
    add_number(row, "change behind", meeting.change_after, meeting.change_noise, -2);
    return row;
}

std::string joints_summary(const std::vector<core::Joint>& joints) {
    std::array<std::size_t, 5> counts{};
    for (const core::Joint& joint : joints) ++counts[static_cast<std::size_t>(std::max(1 + joint.level, 0))];
    return sentence({.one = "one joint: gaps {gaps}, G⁰ {g0}, G¹ {g1}, G² {g2}, G³ {g3}",
                     .many = "{count} joints: gaps {gaps}, G⁰ {g0}, G¹ {g1}, G² {g2}, G³ {g3}",
                     .none = "no ends are near each other, and no curve has a corner or a jump of curvature"},
                    joints.size(),
                    {{"gaps", counts[0]}, {"g0", counts[1]}, {"g1", counts[2]}, {"g2", counts[3]}, {"g3", counts[4]}});
}

}  // namespace batten::editor
