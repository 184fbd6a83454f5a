/// Lengths as people read and type them: in the unit of the document, where it has one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "core/base/geometry.h"
#include "core/document/units.h"

namespace batten::editor {

struct EditorState;

/// Of a document; none where its lengths are plain numbers.
using Units = std::optional<core::DocumentUnits>;

/// Of the committed document.
const Units& units_of(const EditorState& state);

/// How much of the world the length 1 is.
double world_per_length(const Units& units);

/// A length, or a coordinate, of the world in the document's unit.
double in_units(const Units& units, double world);
core::Point in_units(const Units& units, core::Point world);

/// The same of a power of a length: 2 of an area, -1 of a curvature.
double in_units(const Units& units, double world, int power);

/// "12.5 mm", where `number` words a length in the document's unit; the number itself where there is none.
std::string with_unit(const Units& units, const std::string& number);

/// The same of a power of a length: "12.5 mm²" of the second; the number itself but of the first two.
std::string with_unit(const Units& units, const std::string& number, int power);

/// The shortest text of a number that was computed, of which a message has 15 significant digits: "0.3" of 0.1 * 3.
std::string message_text(double value);

/// A power of a length of the world in the document's unit, as messages have it.
std::string quantity_words(const Units& units, double world, int power);

/// The same of a length.
std::string length_words(const Units& units, double world);

/// "12.5 mm²", an area of the world in the square of the unit.
std::string area_words(const Units& units, double world);

/// What stands behind a number in a narrow place: " mm", " in", " px", or nothing.
std::string unit_ending(const Units& units);

/// The value in the world of an expression (fields/expression.h): plain numbers are lengths in the document's unit, and
/// what is written as "12.5mm", "1/2 in" or "96px" is so long. Refused where the document has no unit, and one is
/// written.
[[nodiscard]] tl::expected<double, std::string> parse_length(std::string_view text, const Units& units);

/// The same for each number of a list; see parse_expressions.
[[nodiscard]] tl::expected<std::vector<double>, std::string> parse_lengths(std::string_view text, const Units& units);

}  // namespace batten::editor
