/// Commands that combine what closed curves enclose, and measure it.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/shape/winding.h"

namespace batten::editor {

/// Of the active curve and others: a name, or several with commas between; absent: all other visible closed curves.
struct Unite {
    std::optional<std::string> others{};
    core::InsideRule rule = core::InsideRule::non_zero;
    static const CommandSpec& spec();
};

struct Subtract {
    std::optional<std::string> others{};
    core::InsideRule rule = core::InsideRule::non_zero;
    static const CommandSpec& spec();
};

struct IntersectShapes {
    std::optional<std::string> others{};
    core::InsideRule rule = core::InsideRule::non_zero;
    static const CommandSpec& spec();
};

struct ExcludeShapes {
    std::optional<std::string> others{};
    core::InsideRule rule = core::InsideRule::non_zero;
    static const CommandSpec& spec();
};

/// Area and centroid of what the active curve encloses, each place counted once.
struct FindCentroid {
    core::InsideRule rule = core::InsideRule::non_zero;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
