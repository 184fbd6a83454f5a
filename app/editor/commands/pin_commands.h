/// Commands that pin control points, so that edits of the shape leave them where they are.
#pragma once

#include <vector>

#include "app/editor/command.h"

namespace batten::editor {

struct PinPoints {
    std::vector<std::size_t> points;
    static const CommandSpec& spec();
};

struct UnpinPoints {
    std::vector<std::size_t> points;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
