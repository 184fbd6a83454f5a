/// Commands that bring the control polygon to the curve: midpoint knots in rounds, Bézier form step by step.
#pragma once

#include "app/editor/command.h"

namespace batten::editor {

struct RefineMidpoints {
    int rounds;
    static const CommandSpec& spec();
};

struct InsertForBezier {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
