/// Knot vectors as people type them: "0 0 0 1 2 3 3 3", "T = (0, ..., 7), p = 3".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/derived/knot_questions.h"
#include "app/editor/fields/field.h"

namespace batten::editor {

struct TypedVector {
    std::vector<double> knots;
    std::optional<int> degree{};  ///< where it was typed behind the knots
};

/// Whether `text` is a knot vector and not a command: two numbers or more, or something in parentheses, with a letter
/// and
/// "=" before it or not.
bool is_typed_vector(std::string_view text);

/// The knots that `text` means: numbers as parse_expressions reads them, in parentheses or not, behind a letter and "="
/// or not; "..." goes on in the step of the two numbers before, or in ones, up to the number behind. The degree may
/// stand behind the parentheses or as "p = 3" at the end. The sentence says what was found and what is needed.
Outcome<TypedVector> read_vector(std::string_view text);

/// "(0, 0, 0, 1, 2, 2, 2)"; of a long vector the middle is left out, "(0, 1, 2, 3, 4, 5, …, 98, 99)".
std::string vector_text(std::span<const double> knots, const NumberWriter& text_of = core::shortest_text);

}  // namespace batten::editor
