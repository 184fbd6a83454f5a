#include "app/editor/state/marked_ends.h"

#include <algorithm>

namespace batten::editor {

std::optional<core::JointMark> mark_of_knot(const core::DocumentCurve& entry, double u) {
    const auto found = std::ranges::lower_bound(entry.joints.knots, u, {}, &core::KnotMark::u);
    return found != entry.joints.knots.end() && found->u == u ? std::optional(found->mark) : std::nullopt;
}

const core::EndMark* mark_of_end(const core::DocumentCurve& entry, core::CurveEnd end) {
    for (const core::EndMark& mark : entry.joints.ends)
        if (mark.end == end) return &mark;
    return nullptr;
}

std::optional<DocumentEnd> partner_of(const core::Document& document, DocumentEnd end) {
    const core::EndMark* own = mark_of_end(document.curves[end.curve], end.end);
    if (own == nullptr) return std::nullopt;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        for (const core::EndMark& mark : document.curves[i].joints.ends)
            if (mark.joint == own->joint && DocumentEnd{i, mark.end} != end) return DocumentEnd{i, mark.end};
    return std::nullopt;
}

std::size_t free_joint(const core::Document& document) {
    std::size_t number = 0;
    for (const core::DocumentCurve& entry : document.curves)
        for (const core::EndMark& mark : entry.joints.ends) number = std::max(number, mark.joint + 1);
    return number;
}

std::map<std::size_t, std::vector<DocumentEnd>> ends_by_joint(const core::Document& document) {
    std::map<std::size_t, std::vector<DocumentEnd>> ends;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        for (const core::EndMark& mark : document.curves[i].joints.ends) ends[mark.joint].push_back({i, mark.end});
    return ends;
}

core::JointArm arm_of(const core::Document& document, DocumentEnd end) {
    const core::Interval domain = document.curves[end.curve].curve->domain();
    return {end.curve, core::parameter_of(domain, end.end),
            end.end == core::CurveEnd::end ? core::Side::left : core::Side::right};
}

}  // namespace batten::editor
