/// Whether joints of curves are as they are marked.
#pragma once

#include <optional>
#include <string>

#include "core/curve/curve_end.h"
#include "core/document/joint_marks.h"

namespace batten::core {

/// Which marks the knot u of the curve can have, with the reason, as an end of "it must be ..."; none where it can have
/// `mark`; `size` is that of the curve's control box. A joint is what smoothness_of says, or as smooth as is_kept says:
/// what edits keep can always be marked so.
std::optional<std::string> marks_instead(const Curve& curve, double size, double u, JointMark mark);

/// The same of two ends that shall meet.
std::optional<std::string> marks_instead(const Curve& first, CurveEnd first_end, const Curve& second,
                                         CurveEnd second_end, JointMark mark);

}  // namespace batten::core
