/// Commands on the degree of the active curve.
#pragma once

#include <optional>

#include "app/editor/command.h"

namespace batten::editor {

/// Another degree with the same control points.
struct SetDegree {
    int degree;
    static const CommandSpec& spec();
};

struct Elevate {
    int by;
    static const CommandSpec& spec();
};

struct Reduce {
    int by;
    std::optional<double> tolerance{};  ///< none: as far as it takes
    static const CommandSpec& spec();
};

}  // namespace batten::editor
