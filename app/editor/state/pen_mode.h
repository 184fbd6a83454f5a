/// What the pen makes of the points that are clicked.
#pragma once

#include "core/base/names.h"

namespace batten::editor {

enum class PenMode {
    control_points,  ///< they are control points
    through_c2,      ///< the curve passes them; by core::FitKind
    through_local,
    through_fair,
    bezier  ///< the joints of Bézier pieces; a drag draws the handles of a smooth one, a click makes a corner
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::PenMode> {
    using enum editor::PenMode;
    static constexpr std::array table{Named{control_points, "control-points", "control points"},
                                      Named{through_c2, "through-c2", "through points, C²"},
                                      Named{through_local, "through-local", "through points, local"},
                                      Named{through_fair, "through-fair", "through points, fair"},
                                      Named{bezier, "bezier", "Bézier"}};
};

}  // namespace batten::core
