/// The member "joints" of a curve in native files: which of its joints are marked.
#pragma once

#include "core/document/detail/object_reader.h"
#include "core/document/document.h"
#include "core/document/joint_marks.h"

namespace batten::core {

/// The marks that the list `value` at `pointer` holds, of `curve`, checked completely.
[[nodiscard]] FileResult<JointMarks> read_joints(Json& value, const std::string& pointer, const Curve& curve);

/// The first mark of `curves`, whose objects are in the list `objects` at `pointer`, of an end that does not meet the
/// other end of its number as it says.
std::optional<FileError> check_marked_ends(const std::vector<DocumentCurve>& curves, const Json& objects,
                                           const std::string& pointer);

/// The list that read_joints reads back to equal marks.
Json json_of_joints(const JointMarks& marks);

}  // namespace batten::core
