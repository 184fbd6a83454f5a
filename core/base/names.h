/// Names for the values of enumerations: one table for each, which files, commands, panels and messages share.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <string_view>

namespace batten::core {

/// A value of an enumeration, its name in files and commands, which never changes, and what people read.
template <class Enum>
struct Named {
    Enum value;
    const char* name;   ///< "clamped-uniform"
    const char* title;  ///< "clamped uniform"
};
template <class Enum>
Named(Enum, const char*, const char*) -> Named<Enum>;

/// The table of an enumeration; a specialization stands beside the enumeration:
///
///     template <>
///     struct Names<Side> {
///         static constexpr std::array table{Named{Side::left, "left", "left"}, Named{Side::right, "right", "right"}};
///     };
///
/// It has every value once, in the order of the enumeration.
template <class Enum>
struct Names;

template <class Enum>
concept HasNames = requires {
    Names<Enum>::table;
};

/// The entry of `value`, which is one of the enumeration.
template <HasNames Enum>
constexpr const Named<Enum>& named(Enum value) {
    const auto& table = Names<Enum>::table;
    const auto index = static_cast<std::size_t>(value);
    assert(index < table.size() && table[index].value == value);
    return table[index];
}

template <HasNames Enum>
constexpr const char* name_of(Enum value) {
    return named(value).name;
}

template <HasNames Enum>
constexpr const char* title_of(Enum value) {
    return named(value).title;
}

/// The value that is called `name` in files and commands.
template <HasNames Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
    for (const Named<Enum>& entry : Names<Enum>::table)
        if (entry.name == name) return entry.value;
    return std::nullopt;
}

}  // namespace batten::core
