/// The command that chooses the map of the view of invariance.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "app/editor/state/shown_map.h"

namespace batten::editor {

struct ShowMap {
    ShownMapKind kind;
    std::optional<double> amount;  ///< none: what is usual for this kind
    static const CommandSpec& spec();
};

}  // namespace batten::editor
