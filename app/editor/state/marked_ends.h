/// Which knots and ends of a document have marks.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/document/document.h"
#include "core/edit/joint_keeping.h"

namespace batten::editor {

/// An end of a curve of a document.
struct DocumentEnd {
    std::size_t curve = 0;
    core::CurveEnd end = core::CurveEnd::start;
    bool operator==(const DocumentEnd&) const = default;
};

/// The mark of the knot u of a curve; none where it has none.
std::optional<core::JointMark> mark_of_knot(const core::DocumentCurve& entry, double u);

/// The mark of an end; none where it has none.
const core::EndMark* mark_of_end(const core::DocumentCurve& entry, core::CurveEnd end);

/// The other end of a marked joint; none where the end is not marked.
std::optional<DocumentEnd> partner_of(const core::Document& document, DocumentEnd end);

/// A number that no joint of `document` has.
std::size_t free_joint(const core::Document& document);

/// The ends that are marked, by the numbers of their joints, in the order of the curves.
std::map<std::size_t, std::vector<DocumentEnd>> ends_by_joint(const core::Document& document);

/// How the curve comes to its end, or leaves its start.
core::JointArm arm_of(const core::Document& document, DocumentEnd end);

}  // namespace batten::editor
