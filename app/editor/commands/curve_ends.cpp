#include "app/editor/commands/curve_ends.h"

namespace batten::editor {

core::Result<core::Curve> change_ends(const core::Curve& curve, CurveEnds ends,
                                      core::Result<core::Curve> (*change)(const core::Curve&, core::CurveEnd)) {
    core::Result<core::Curve> result = curve;
    if (ends != CurveEnds::end) result = change(*result, core::CurveEnd::start);
    if (ends != CurveEnds::start && result) result = change(*result, core::CurveEnd::end);
    return result;
}

}  // namespace batten::editor
