/// Lists of numbers in a JSON text and in its tree. A long list stands in the tree as the bytes of its doubles, packed
/// in one binary value, which no text makes.
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/geometry.h"
#include "core/document/detail/native_format.h"
#include "core/document/detail/text_stream.h"

namespace batten::core {

/// What the items of a list are.
enum class ListItem {
    number,
    pair  ///< a list of two numbers
};

/// Is told the bytes of items that were taken, which are never none.
using NumbersTaken = std::function<void(std::span<const std::uint8_t> bytes)>;

/// Takes the items at the front of `text`, which stands behind the opening bracket of a list, as long as each is of
/// this kind and nothing strange follows: what is left is the rest of the list, to be read by a parser that has seen
/// the bracket alone. Returns the items packed; `taken` is told them, block by block of the text.
Json take_numbers(TextStream& text, ListItem kind, const NumbersTaken& taken = {});

/// Whether items of this type can stand packed in a tree.
template <class T>
inline constexpr bool can_be_packed = std::is_same_v<T, double> || std::is_same_v<T, Point>;

/// A number as it is written, whole ones without a fraction.
Json json_number(double value);

/// `items` packed.
template <class T>
requires can_be_packed<T> Json packed(std::span<const T> items) {
    std::vector<std::uint8_t> bytes(items.size_bytes());
    if (!bytes.empty()) std::memcpy(bytes.data(), items.data(), bytes.size());
    return Json::binary(std::move(bytes), std::is_same_v<T, Point> ? 2 : 1);
}

/// Of what kind the items of a packed list are.
inline ListItem packed_item(const Json& packed) {
    return packed.get_binary().subtype() == 2 ? ListItem::pair : ListItem::number;
}

/// How many items `packed` holds, and item i.
template <class T>
requires can_be_packed<T> std::size_t packed_count(const Json& packed) {
    return packed.get_binary().size() / sizeof(T);
}
template <class T>
requires can_be_packed<T> T packed_at(const Json& packed, std::size_t i) {
    T item;
    std::memcpy(&item, packed.get_binary().data() + i * sizeof(T), sizeof(T));
    return item;
}

/// Appends the items that `packed` holds.
template <class T>
requires can_be_packed<T>
void unpack(const Json& packed, std::vector<T>& items) {
    const std::size_t before = items.size();
    const std::size_t count = packed_count<T>(packed);
    items.resize(before + count);
    if (count > 0) std::memcpy(&items[before], packed.get_binary().data(), count * sizeof(T));
}

}  // namespace batten::core
