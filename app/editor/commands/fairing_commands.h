/// Commands that give the active curve other control points while it stays near where it was.
#pragma once

#include <vector>

#include "app/editor/command.h"

namespace batten::editor {

struct FairPart {
    double from;
    double to;  ///< may lie beyond the seam of a periodic curve
    double distance;
    static const CommandSpec& spec();
};

struct Rebuild {
    std::size_t count;
    int degree;
    static const CommandSpec& spec();
};

struct Simplify {
    double tolerance;
    static const CommandSpec& spec();
};

struct DeleteAndRefit {
    std::vector<std::size_t> points;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
