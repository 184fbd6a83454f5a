/// One end of a curve, or both.
#pragma once

#include "app/editor/command_spec.h"
#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::editor {

enum class CurveEnds { start, end, both };

/// The curve after `change` at these ends, the start first.
core::Result<core::Curve> change_ends(const core::Curve& curve, CurveEnds ends,
                                      core::Result<core::Curve> (*change)(const core::Curve&, core::CurveEnd));

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::CurveEnds> {
    using enum editor::CurveEnds;
    static constexpr std::array table{Named{start, "start", "start"}, Named{end, "end", "end"},
                                      Named{both, "both", "both"}};
};

}  // namespace batten::core
