/// Sentences about what an edit did.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command_table.h"

namespace batten::editor {

/// A label of the history told as done: "Move P₅" becomes "Moved P₅".
std::string past_of(const std::string& label);

/// What the status bar says after an edit: "Inserted knot 0.5: the curve is unchanged", "Moved P₅: deviates by at most
/// 0.12". `deviation` counts for shape-changing commands only; none where there is no curve to compare with.
std::string edit_sentence(const std::string& label, ShapeEffect effect, std::optional<double> deviation);

/// What is said after a step: `done` ("Moved P₅") with what it did to the shape, or how far off its result is. Without
/// a curve to compare with there is no deviation, without an approximation no error.
std::string done_sentence(const std::string& done, ShapeEffect effect, std::optional<double> deviation,
                          std::optional<double> error);

/// The same sentence for an edit that approximates: "Fitted curve to points: error at most 0.003".
std::string with_error(const std::string& sentence, double error);

}  // namespace batten::editor
