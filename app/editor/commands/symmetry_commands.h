/// Commands that tie a curve to its images, in a mirror or around a center, and untie them.
#pragma once

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct LinkMirror {
    core::Point center;
    double angle;    ///< of the line, in degrees
    bool is_smooth;  ///< ends near the line meet it at a right angle
    static const CommandSpec& spec();
};

struct LinkRotation {
    std::size_t turns;
    core::Point center;
    static const CommandSpec& spec();
};

struct Unlink {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
