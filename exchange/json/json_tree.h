/// A JSON text as a tree that is lean where it has many numbers.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/document/json_walk.h"

namespace batten::exchange {

class JsonValue;

/// A list. Numbers, or rows of equally many numbers, stand one after the other; other values by themselves.
struct JsonList {
    std::vector<double> numbers{};
    std::size_t row_length = 0;              ///< of rows of numbers, at least 1; 0: plain numbers
    std::vector<JsonValue> items;            ///< of what is neither numbers nor rows of them
    std::optional<std::size_t> first_odd{};  ///< the first item that is of another sort than the first; not kept
};

/// Null, true or false, a number, a text, a list or an object.
class JsonValue {
  public:
    using Member = std::pair<std::string, JsonValue>;
    using Object = std::vector<Member>;

    JsonValue() = default;
    explicit JsonValue(core::JsonScalar value)
        : value_(std::visit([](auto&& each) { return Value(std::move(each)); }, std::move(value))) {}
    explicit JsonValue(JsonList value) : value_(std::make_unique<JsonList>(std::move(value))) {}
    explicit JsonValue(Object value) : value_(std::make_unique<Object>(std::move(value))) {}

    bool is_null() const { return std::holds_alternative<std::monostate>(value_); }

    /// The value, or null where it is of another sort.
    const bool* flag() const { return std::get_if<bool>(&value_); }
    const double* number() const { return std::get_if<double>(&value_); }
    const std::string* text() const { return std::get_if<std::string>(&value_); }
    const JsonList* list() const;
    const Object* object() const;

    /// The member of that name of an object; null where there is none.
    const JsonValue* member(std::string_view name) const;

  private:
    using Value =
        std::variant<std::monostate, bool, double, std::string, std::unique_ptr<JsonList>, std::unique_ptr<Object>>;

    Value value_;
};

/// The tree of `text`. Refused, with "line L, column C": what core::walk_json refuses; more texts, lists and objects
/// than a fixed limit. Takes a few times the memory of the text at most. Cost O(n).
[[nodiscard]] core::FileResult<JsonValue> parse_json_tree(std::string_view text);

}  // namespace batten::exchange
