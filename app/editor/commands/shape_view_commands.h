/// Commands on what the views of a curve's shape are set to.
#pragma once

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct SetCombScale {
    double factor;  ///< 1: as long as the comb is by itself
    static const CommandSpec& spec();
};

struct SetPartCount {
    int count;
    static const CommandSpec& spec();
};

struct PutLine {
    core::Point first;
    core::Point second;
    static const CommandSpec& spec();
};

struct LevelLine {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
