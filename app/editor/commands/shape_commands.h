/// Commands that move points of the active curve itself, fair it and offset it.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "core/base/geometry.h"
#include "core/shape/offset_shape.h"

namespace batten::editor {

struct MoveCurvePoint {
    double u;
    core::Point position;
    static const CommandSpec& spec();
};

struct SetTangent {
    double u;
    core::Vector derivative;
    core::Side side = core::Side::right;  ///< of a knot at which the curve may turn
    static const CommandSpec& spec();
};

struct MovePointAndTangent {
    double u;
    core::Point position;
    core::Vector derivative;
    static const CommandSpec& spec();
};

struct Fair {
    double distance;  ///< how far the curve may move
    static const CommandSpec& spec();
};

struct Offset {
    double distance;  ///< to the left
    double tolerance;
    /// Absent: to the left, with the knots of the curve, and nothing is cut away.
    std::optional<core::OffsetSide> side{};
    core::OffsetCorners corners = core::OffsetCorners::mitre;
    core::OffsetCaps caps = core::OffsetCaps::none;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
