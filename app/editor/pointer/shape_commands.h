/// The command that makes a shape of the places that were clicked.
#pragma once

#include <optional>

#include "app/editor/command.h"
#include "app/editor/fields/field.h"
#include "app/editor/pointer/shape_mode.h"

namespace batten::editor {

/// How many places make a shape.
std::size_t place_count(ShapeKind kind);

/// What is known of the last place of a shape beside where it is.
struct ShapeHints {
    std::size_t sides = 6;  ///< of a polygon
    /// That was typed for the way to it, and counts to the last bit; for an ellipse how far it reaches from its first
    /// axis.
    std::optional<double> length{};
    double turned = 0.0;  ///< > 0 where an arc goes counterclockwise to it, < 0 clockwise
};

/// The command for places in the order of ShapeKind, as many as place_count says. Exact where the places are: a length
/// that was typed is the radius. Refused where they make no such shape, as three places on a line make no circle.
Outcome<Command> shape_command(ShapeKind kind, const std::vector<core::Point>& places, const ShapeHints& hints);

}  // namespace batten::editor
