/// Commands that round corners or cut them off.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"

namespace batten::editor {

/// Puts an arc between the active curve and another one, or at a corner of the active curve.
struct Fillet {
    double radius;
    double u;                            ///< on the active curve, near where the arc shall touch it
    std::optional<std::string> other{};  ///< none: the active curve itself
    std::optional<double> other_u{};     ///< there; none: the other side of the corner, or what is nearest to u
    bool joined = true;                  ///< both curves and the arc become one
    static const CommandSpec& spec();
};

/// The same with a straight line, so far from the corner on both sides.
struct Chamfer {
    double distance;
    double other_distance;
    double u;
    std::optional<std::string> other{};
    std::optional<double> other_u{};
    bool joined = true;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
