/// Sentences about what an edit did.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command_spec.h"

namespace batten::editor {

/// How far an edit went, where that is known.
struct Distances {
    std::optional<double> deviation{};  ///< from the curve before, at equal parameters
    std::optional<double> of_shapes{};  ///< the same whatever the parameters, where it is much less
    std::optional<double> error{};      ///< of what approximates something else
    bool is_rounding = false;           ///< the deviation is what rounding of the coordinates makes
};

/// What is said after a step: `done` ("Moved P₅") with what it did to the shape, or how far off its result is. Without
/// a curve to compare with there is no deviation, without an approximation no error.
std::string done_sentence(const std::string& done, ShapeEffect effect, const Distances& distances);

/// What is said after an edit that left everything as it was.
std::string nothing_changed_sentence();

}  // namespace batten::editor
