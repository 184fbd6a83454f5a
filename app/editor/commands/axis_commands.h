/// Commands that let an axis or a center be clicked on the canvas, for what makes images of a curve.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/axis_pick.h"

namespace batten::editor {

struct PickMirror {
    static const CommandSpec& spec();
};

struct PickLinkMirror {
    bool is_smooth;  ///< ends near the axis meet their images at no corner
    static const CommandSpec& spec();
};

struct PickLinkRotation {
    std::size_t count;  ///< of the curves, with the one that is there
    static const CommandSpec& spec();
};

struct PickArrayPolar {
    std::size_t count;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
