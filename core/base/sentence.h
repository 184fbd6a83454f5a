/// Sentences for people: whole templates with named places, filled in here and nowhere else.
///
/// A template is written as it is read, "knot {index} is {value}; every weight must be above 0", so that it can be
/// found from what is on screen, and translated: a translation may name the places in another order. Nothing is glued
/// from parts, and plural forms are whole templates too.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace batten::core {

/// A place of a template by its name, and the text that stands there. Indices and counts are written as they are,
/// other numbers by whoever knows how many digits matter.
struct Place {
    std::string_view name;
    std::string text;

    Place(std::string_view place_name, std::string_view place_text) : name(place_name), text(place_text) {}
    template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
    Place(std::string_view place_name, Integer number) : name(place_name), text(std::to_string(number)) {}
};

/// `pattern` with its places filled in; "{{" stands for a brace. Every place of the pattern must be given, and every
/// place given must occur in it.
std::string sentence(const char* pattern, std::initializer_list<Place> places);

/// The same where more places may be given than the pattern has.
std::string filled_as_needed(const char* pattern, std::span<const Place> places);
std::string filled_as_needed(const char* pattern, std::initializer_list<Place> places);

/// The templates of one sentence about a count, which is the place {count} in each of them where it is wanted.
struct PluralPattern {
    const char* one;   ///< "one cusp was found"
    const char* many;  ///< "{count} cusps were found", and for none where `none` is not given
    const char* none = nullptr;

    const char* for_count(std::size_t count) const;
};

/// The template for `count`, filled in.
std::string sentence(const PluralPattern& pattern, std::size_t count, std::initializer_list<Place> places = {});

/// "stop, push or snap".
std::string listed_as_alternatives(std::span<const std::string> items);

}  // namespace batten::core
