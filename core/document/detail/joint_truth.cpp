#include "core/document/detail/joint_truth.h"

#include <numbers>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/edit/joint_keeping.h"
#include "core/measure/meeting.h"

namespace batten::core {

namespace {

std::string because_of(const Meeting& meeting, int level) {
    if (level < 0)
        return sentence("a mark of ends that meet; these are {gap} apart", {{"gap", shortest_text(meeting.gap)}});
    if (!meeting.angle) return R"("corner", since there is no direction on one side)";
    if (level == 0)
        return sentence(R"("corner", since the tangent turns by {angle}° there)",
                        {{"angle", shortest_text(std::abs(*meeting.angle) * 180.0 / std::numbers::pi)}});
    if (!meeting.before || !meeting.after) return R"("smooth" or "corner", since there is no curvature on one side)";
    return sentence(R"("smooth" or "corner", since the curvature jumps there from {before} to {after})",
                    {{"before", shortest_text(*meeting.before)}, {"after", shortest_text(*meeting.after)}});
}

std::optional<std::string> unless_true(const Meeting& meeting, double size, const std::vector<EditedCurve>& curves,
                                       const KeptJoint& joint) {
    const int level = smoothness_of(meeting, size);
    if (level >= joint.level || is_kept(curves, joint)) return std::nullopt;
    return because_of(meeting, level);
}

JointArm arm_of(std::size_t index, const Curve& curve, CurveEnd end) {
    return {index, parameter_of(curve.domain(), end), end == CurveEnd::end ? Side::left : Side::right};
}

}  // namespace

std::optional<std::string> marks_instead(const Curve& curve, double size, double u, JointMark mark) {
    if (mark == JointMark::corner) return std::nullopt;
    return unless_true(meeting_of(passing_at(curve, u, Side::left), passing_at(curve, u, Side::right)), size,
                       {{.curve = curve}}, {{0, u, Side::left}, {0, u, Side::right}, static_cast<int>(mark)});
}

std::optional<std::string> marks_instead(const Curve& first, CurveEnd first_end, const Curve& second,
                                         CurveEnd second_end, JointMark mark) {
    Box box = control_box(first);
    const Box other = control_box(second);
    box.include(other.lower);
    box.include(other.upper);
    return unless_true(meeting_of(passing_beyond(first, first_end), run_back(passing_beyond(second, second_end))),
                       robust_length(box.size()), {{.curve = first}, {.curve = second}},
                       {arm_of(0, first, first_end), arm_of(1, second, second_end), static_cast<int>(mark)});
}

}  // namespace batten::core
