/// Joints that are marked, and stay as they are marked through every edit.
#pragma once

#include <optional>
#include <string>
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

/// Brings `after`, which an edit made of `before`, to what its marks say (core::keep_joints), with marks that follow
/// their knots: where knots are moved, and through reversal and joins. Marks without their knot or their other end are
/// dropped, and so are those of a joint that cannot be kept, or whose end was cut off, which the sentence that is
/// returned tells. Curves that are locked or made of fit points stay as they are. Cost O(n) for each curve with marks
/// that changed.
std::optional<std::string> keep_marked_joints(const core::Document& before, core::Document& after);

/// The same for joints of curves that have followed others as their images since, and stay as they are.
std::optional<std::string> keep_joints_of_images(const core::Document& before, core::Document& after);

}  // namespace batten::editor
