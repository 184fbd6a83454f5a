/// The joints of a document in words, for findings and for the command line.
#pragma once

#include <string>
#include <vector>

#include "app/editor/state/findings.h"
#include "core/document/document.h"
#include "core/measure/joints.h"

namespace batten::editor {

/// All joints of the visible curves, with indices of the document's curves; ends nearer than `tolerance` are joints.
std::vector<core::Joint> joints_of_document(const core::Document& document, double tolerance);

/// How near ends must be where nobody says: a thousandth of the size of the visible curves.
double usual_joint_tolerance(const core::Document& document);

/// One row: "end of 'keel' to start of 'stem'", the class of the joint, and what jumps there.
Finding joint_row(const core::Document& document, const core::Joint& joint);

/// "5 joints: 1 gap, 1 with G⁰, 2 with G¹, 1 with G³".
std::string joints_summary(const std::vector<core::Joint>& joints);

}  // namespace batten::editor
