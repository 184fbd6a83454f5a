/// Values of the fields of commands, of whatever type, on their way between a command and a text, a form or a log.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/names.h"
#include "core/document/document.h"

namespace batten::editor {

/// What was left out, or is not there.
using Absent = std::monostate;

/// Choices, files and colors are texts; a vector is the point it leads to from (0, 0).
using FieldValue = std::variant<Absent, bool, std::int64_t, double, std::string, core::Point, std::vector<double>,
                                std::vector<std::size_t>, std::vector<core::Point>>;

inline bool is_absent(const FieldValue& value) {
    return std::holds_alternative<Absent>(value);
}

/// How a member of type T becomes a FieldValue and comes back; the value fits the member, which the field's kind sees
/// to. Specialized below for what is not an alternative of FieldValue itself.
template <class T>
struct FieldConversion {
    static FieldValue to(const T& member) { return member; }
    static T from(const FieldValue& value) { return std::get<T>(value); }
};

template <class T>
requires std::is_integral_v<T> &&(!std::is_same_v<T, bool>)struct FieldConversion<T> {
    static FieldValue to(T member) { return static_cast<std::int64_t>(member); }
    static T from(const FieldValue& value) { return static_cast<T>(std::get<std::int64_t>(value)); }
};

template <core::HasNames Enum>
struct FieldConversion<Enum> {
    static FieldValue to(Enum member) { return std::string(core::name_of(member)); }
    static Enum from(const FieldValue& value) { return *core::value_named<Enum>(std::get<std::string>(value)); }
};

template <>
struct FieldConversion<core::Vector> {
    static FieldValue to(core::Vector member) { return core::tip_of(member); }
    static core::Vector from(const FieldValue& value) { return core::vector_to(std::get<core::Point>(value)); }
};

template <>
struct FieldConversion<std::filesystem::path> {
    static FieldValue to(const std::filesystem::path& member) { return member.string(); }
    static std::filesystem::path from(const FieldValue& value) { return std::get<std::string>(value); }
};

template <>
struct FieldConversion<core::DocumentColor> {
    static FieldValue to(core::DocumentColor member) { return core::color_text(member); }
    static core::DocumentColor from(const FieldValue& value) {
        return *core::color_of_text(std::get<std::string>(value));
    }
};

template <class T>
struct FieldConversion<std::optional<T>> {
    static FieldValue to(const std::optional<T>& member) {
        return member ? FieldConversion<T>::to(*member) : FieldValue(Absent{});
    }
    static std::optional<T> from(const FieldValue& value) {
        return is_absent(value) ? std::nullopt : std::optional<T>(FieldConversion<T>::from(value));
    }
};

}  // namespace batten::editor
