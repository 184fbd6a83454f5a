/// Commands that tie a curve to its images, in a mirror or around a center, and untie them.
#pragma once

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// What the choice of a seam says, wherever a mirror link is made.
inline constexpr const char* smooth_seam_meaning =
    "yes: ends near the line are turned until they meet their image smoothly, G2; no: they keep a corner";

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
