/// Commands that move points of the active curve itself, fair it and offset it.
#pragma once

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct MoveCurvePoint {
    double u;
    core::Point position;
    static const CommandSpec& spec();
};

struct SetTangent {
    double u;
    core::Vector derivative;
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
    static const CommandSpec& spec();
};

}  // namespace batten::editor
