/// Numbers typed for the place of a gesture: length and angle, dx and dy, or a whole place.
#pragma once

#include <optional>

#include "app/editor/fields/field.h"
#include "app/editor/state/key.h"
#include "app/editor/state/placing.h"
#include "app/editor/words/length.h"

namespace batten::editor {

/// Whether letters may be the first that is typed, "sqrt(2)": while a button is held nothing else listens to them.
enum class FirstLetters { begin_numbers, are_shortcuts };

/// What is typed after one character more; none where it is not for the place: a first one is a digit, a sign, a
/// point, a parenthesis, '@', '<', '=' as in a spreadsheet, or a letter where these begin numbers. 'x' and 'y' before
/// any other ask for dx and dy instead of length and angle; what follows the first character is any part of an
/// expression.
std::optional<TypedPlace> typed_character(TypedPlace typed, char32_t character,
                                          FirstLetters letters = FirstLetters::are_shortcuts);

/// The same after a key: Backspace takes back the last character, and dx and dy where there is none; Tab goes to the
/// other field. None where nothing is typed, or the key is another one.
std::optional<TypedPlace> typed_key(TypedPlace typed, Key key);

/// Where the numbers say that the place is. What is left open the place `pointed` gives, where the pointer is. In the
/// fields: the length and the angle (in degrees, counterclockwise from the right) of the way from `from`, or dx and dy.
/// In the first field alone "@10,5" is dx and dy, "10<45" (or "@10<45") length and angle, "3,4" (or "3;4") x and y;
/// without a comma "3" alone is a length. Once there is a second field a comma begins decimals. Where there is no
/// `from`, lengths count from (0, 0). Lengths and coordinates are in the document's unit where none is written. Refused
/// where an expression cannot be read, or where the place is infinite.
Outcome<core::Point> place_typed(const TypedPlace& typed, std::optional<core::Point> from, core::Point pointed,
                                 const Units& units = std::nullopt);

/// The length that is typed, alone or with an angle, in the world; none where there is none.
std::optional<double> typed_length(const TypedPlace& typed, const Units& units);

/// The length that is typed alone, in the world; none where there is none, or more.
std::optional<double> typed_length_alone(const TypedPlace& typed, const Units& units);

/// The length that is typed in a field, in the world; none where there is none.
std::optional<double> typed_length_in(const TypedPlace& typed, std::size_t field, const Units& units);

/// A factor that is typed in a field, "1.5" or "150%"; none where there is none.
std::optional<double> typed_factor(const TypedPlace& typed, std::size_t field);

/// An angle that is typed in the first field, in degrees; none where there is none.
std::optional<double> typed_angle(const TypedPlace& typed);

/// Why what is typed for `placing` is no place, length, factor or angle, as it is to be; empty where it is one.
std::string typed_problem(const Placing& placing, core::Point pointed, const Units& units);

/// "dx, dy" of the field that is typed: what a person reads before it.
const char* title_of_field(const TypedPlace& typed, std::size_t field);

}  // namespace batten::editor
