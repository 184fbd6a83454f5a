/// Commands that measure the active curve: points, lengths, areas, contacts.
#pragma once

#include <string>

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct Evaluate {
    double u;
    static const CommandSpec& spec();
};

struct MeasureArcLength {
    double begin;
    double end;
    static const CommandSpec& spec();
};

struct FindPointAtLength {
    double length;
    static const CommandSpec& spec();
};

struct MeasureArea {
    static const CommandSpec& spec();
};

struct FindNearest {
    core::Point position;
    static const CommandSpec& spec();
};

struct IntersectLine {
    core::Point first;
    core::Point second;
    static const CommandSpec& spec();
};

struct IntersectSegment {
    core::Point first;
    core::Point second;
    static const CommandSpec& spec();
};

struct IntersectCurve {
    std::string other;  ///< the name of the other curve
    static const CommandSpec& spec();
};

}  // namespace batten::editor
