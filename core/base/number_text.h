/// Numbers as text that reads back to the same double, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace batten::core {

/// The shortest such text, "0.1", whatever the locale.
std::string shortest_text(double value);

/// Appends it to `text`.
void append_shortest_text(std::string& text, double value);

/// Appends the shortest such text as JSON has it: with an exponent only below 1e-4 and from 1e15 on, and for whole
/// numbers before that without a fraction. Negative zero is "-0.0". `value` must be finite.
void append_json_text(std::string& text, double value);

/// A number that stands at the front of a text, and how many bytes it takes there.
struct LeadingNumber {
    double value = 0.0;
    std::size_t length = 0;
};

/// The decimal number at the front of `text`, "2", "+.5" or "1e-3", as the double that is nearest to it, whatever the
/// locale: 0, with its sign, where it is nearer to 0 than they are. None where there is no number, or one that is not
/// finite or too large for doubles.
std::optional<LeadingNumber> leading_number(std::string_view text);

}  // namespace batten::core
