/// The command that chooses what the document's lengths are measured in.
#pragma once

#include "app/editor/command.h"
#include "core/document/units.h"

namespace batten::editor {

/// The unit of a document, which may have none.
enum class UnitChoice { none, mm, inch, px };

struct SetUnits {
    UnitChoice unit;
    double scale = 1.0;  ///< how much of the world is one unit, above 0
    static const CommandSpec& spec();
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::UnitChoice> {
    using enum editor::UnitChoice;
    static constexpr std::array table{Named{none, "none", "plain numbers"}, Named{mm, "mm", "millimeters"},
                                      Named{inch, "inch", "inches"}, Named{px, "px", "pixels"}};
};

}  // namespace batten::core
