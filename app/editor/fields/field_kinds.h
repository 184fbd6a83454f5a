/// Makes the fields of a description, one function for each kind: field::parameter<&MoveKnot::u>("u", "where to").
#pragma once

#include "app/editor/fields/field.h"
#include "core/document/document.h"

namespace batten::editor::field {

namespace detail {

template <class T>
struct Inner {
    using Type = T;
    static constexpr bool is_optional = false;
};
template <class T>
struct Inner<std::optional<T>> {
    using Type = T;
    static constexpr bool is_optional = true;
};

template <auto member>
struct Member;
template <class C, class T, T C::*member>
struct Member<member> {
    using Command = C;
    using Type = T;
    using InnerType = typename Inner<T>::Type;
};

template <auto member, class Wanted>
concept MemberOf = std::is_same_v<typename Member<member>::InnerType, Wanted>;

template <auto member>
Field made(FieldKind kind, std::vector<FieldPart> parts) {
    using Command = typename Member<member>::Command;
    using Type = typename Member<member>::Type;
    Field field{.kind = kind, .parts = std::move(parts)};
    field.get = [](const void* command) {
        return FieldConversion<Type>::to(static_cast<const Command*>(command)->*member);
    };
    field.set = [](void* command, const FieldValue& value) {
        static_cast<Command*>(command)->*member = FieldConversion<Type>::from(value);
    };
    field.is_optional = Inner<Type>::is_optional;
    return field;
}

}  // namespace detail

template <auto member>
requires detail::MemberOf<member, double> Field number(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::number, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, double> Field parameter(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::parameter, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, double> Field length(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::length, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, double> Field angle(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::angle, {{name, meaning}});
}

template <auto member>
requires std::is_integral_v<typename detail::Member<member>::InnerType> Field count(const char* name,
                                                                                    const char* meaning) {
    return detail::made<member>(FieldKind::count, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::size_t> Field point_index(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::point_index, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::size_t> Field knot_index(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::knot_index, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::size_t> Field curve_index(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::curve_index, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, bool> Field flag(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::flag, {{name, meaning}});
}

/// Allows the values of the member's enumeration by their names.
template <auto member>
requires core::HasNames<typename detail::Member<member>::InnerType> Field choice(const char* name,
                                                                                 const char* meaning) {
    Field field = detail::made<member>(FieldKind::choice, {{name, meaning}});
    for (const auto& entry : core::Names<typename detail::Member<member>::InnerType>::table)
        field.choices.push_back({entry.name, entry.title});
    return field;
}

/// Two words with a name and a meaning each.
template <auto member>
requires detail::MemberOf<member, core::Point> Field position(FieldPart x, FieldPart y) {
    return detail::made<member>(FieldKind::position, {x, y});
}

/// Two words, or one list of two numbers where one part is given.
template <auto member>
requires detail::MemberOf<member, core::Vector> Field vector(FieldPart x, FieldPart y) {
    return detail::made<member>(FieldKind::vector, {x, y});
}
template <auto member>
requires detail::MemberOf<member, core::Vector> Field vector(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::vector, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::vector<core::Point>> Field positions(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::positions, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::vector<double>> Field parameters(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::parameters, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::vector<std::size_t>> Field point_indices(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::point_indices, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::vector<std::size_t>> Field curve_indices(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::curve_indices, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::string> Field curve_name(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::curve_name, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, core::DocumentColor> Field color(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::color, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::string> Field text(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::text, {{name, meaning}});
}

template <auto member>
requires detail::MemberOf<member, std::filesystem::path> Field file(const char* name, const char* meaning) {
    return detail::made<member>(FieldKind::file, {{name, meaning}});
}

}  // namespace batten::editor::field
