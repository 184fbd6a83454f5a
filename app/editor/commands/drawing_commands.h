/// Commands that add what is drawn point by point: curves through fit points, and Bézier paths.
#pragma once

#include <vector>

#include "app/editor/command.h"
#include "core/base/geometry.h"
#include "core/make/fit_points.h"

namespace batten::editor {

struct ThroughPoints {
    std::vector<core::Point> points;
    core::FitKind kind = core::FitKind::c2;
    core::Parametrization parametrization = core::Parametrization::chordal;
    bool closed = false;
    static const CommandSpec& spec();
};

struct BezierPath {
    std::vector<core::Point> points;  ///< ends of pieces, and two handles between any two
    bool closed = false;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
