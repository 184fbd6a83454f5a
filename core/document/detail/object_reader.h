/// Takes the members of a JSON object into variables and notes the first thing found wrong.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/names.h"
#include "core/document/detail/native_format.h"
#include "core/document/detail/number_list.h"
#include "core/document/native_file.h"

namespace batten::core {

/// `name` for a sentence: whole, or its beginning and "…" where it is long. It is UTF-8.
std::string short_name(std::string_view name);

/// The JSON pointer of a member or an item of what stands at `pointer`.
std::string place_in(std::string_view pointer, std::string_view name);
std::string place_in(std::string_view pointer, std::size_t index);

/// "the member "knots" is missing" at `pointer`.
FileError missing_member(const std::string& pointer, std::string_view name);

/// "found 2.5, but it must be <allowed>" at `pointer`.
FileError wrong_value(const std::string& pointer, const Json& found, const std::string& allowed);

/// The error of a text that should be one of these names.
FileError wrong_choice(const std::string& pointer, const Json& found, const std::vector<std::string>& names);

/// Each take() stores `value` in `target`, or gives the reason why it cannot.
std::optional<FileError> take(const Json& value, const std::string& pointer, bool& target);
std::optional<FileError> take(const Json& value, const std::string& pointer, double& target);
std::optional<FileError> take(const Json& value, const std::string& pointer, std::string& target);
std::optional<FileError> take(const Json& value, const std::string& pointer, Point& target);
std::optional<FileError> take(const Json& value, const std::string& pointer,
                              std::map<std::string, std::string>& target);

/// One of an enumeration, by its name.
template <HasNames Enum>
std::optional<FileError> take(const Json& value, const std::string& pointer, Enum& target) {
    const auto found = value.is_string() ? value_named<Enum>(value.get<std::string>()) : std::nullopt;
    if (found) {
        target = *found;
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (const auto& entry : Names<Enum>::table) names.emplace_back(entry.name);
    return wrong_choice(pointer, value, names);
}

/// The items of a list may be packed, as number_list.h says; those are let go once they are stored.
template <class T>
std::optional<FileError> take(Json& value, const std::string& pointer, std::vector<T>& target) {
    if (!value.is_array()) return wrong_value(pointer, value, "a list");
    target.clear();
    for (Json& item : value) {
        if constexpr (can_be_packed<T>)
            if (item.is_binary()) {
                unpack(std::exchange(item, nullptr), target);
                continue;
            }
        const std::string place = place_in(pointer, target.size());
        if (auto error = take(item, place, target.emplace_back())) return error;
    }
    return std::nullopt;
}

template <class T>
std::optional<FileError> take(Json& value, const std::string& pointer, std::optional<T>& target) {
    return take(value, pointer, target.emplace());
}

/// Adds a member that `object` does not have yet, at once, however many there are; returns its value.
Json& added_member(Json& object, const std::string& name, Json value);

/// Gives `object` the members of `unknown`, a JSON object as text, that it does not have yet.
void add_unknown_members(Json& object, const std::string& unknown);

/// Reads one object. After the first error nothing more is stored.
class ObjectReader {
  public:
    /// `object` must outlive the reader; `pointer` is its place in the file, "" for the whole.
    ObjectReader(Json& object, std::string pointer);

    /// Stores member `name` in `target`, which stays as it is when there is no such member.
    template <class T>
    void optional(const char* name, T& target) {
        if (Json* value = find(name)) note(take(*value, place(name), target));
    }

    /// The same for a member that must be there.
    template <class T>
    void required(const char* name, T& target) {
        if (Json* value = find(name))
            note(take(*value, place(name), target));
        else
            note(missing_member(pointer_, name));
    }

    /// The member `name`, or null; asked for by name, it counts as known.
    Json* find(const char* name);

    /// Keeps `error` unless there is one already.
    void note(std::optional<FileError> error);

    const std::optional<FileError>& error() const { return error_; }

    /// The JSON pointer of member `name`.
    std::string place(std::string_view name) const { return place_in(pointer_, name); }

    /// The members that nobody asked for, as a JSON object; empty if none.
    std::string unknown_members() const;

  private:
    Json& object_;
    std::string pointer_;
    std::set<std::string> known_;
    std::optional<FileError> error_;
};

}  // namespace batten::core
