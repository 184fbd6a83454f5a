/// Sentences about what an edit did.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command_spec.h"

namespace batten::editor {

/// What is said after a step: `done` ("Moved P₅") with what it did to the shape, or how far off its result is. Without
/// a curve to compare with there is no deviation, without an approximation no error.
std::string done_sentence(const std::string& done, ShapeEffect effect, std::optional<double> deviation,
                          std::optional<double> error);

}  // namespace batten::editor
