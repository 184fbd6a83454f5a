#include "core/document/detail/number_list.h"

#include <array>

#include "core/base/number_text.h"

namespace batten::core {

namespace {

// An item with what stands around it must not be longer than this; longer ones are left to the parser.
constexpr std::size_t longest_item = 1024;

// Goes along the bytes of a text; beyond them it sees zero bytes.
struct Cursor {
    std::string_view text;
    std::size_t at = 0;

    char front() const { return at < text.size() ? text[at] : '\0'; }

    void skip_blanks() {
        while (front() == ' ' || front() == '\n' || front() == '\t' || front() == '\r') ++at;
    }

    bool accept(char c) {
        skip_blanks();
        if (front() != c) return false;
        ++at;
        return true;
    }

    // Whether there is at least one digit.
    bool skip_digits() {
        const std::size_t first = at;
        while (front() >= '0' && front() <= '9') ++at;
        return at > first;
    }

    // Whether a number as JSON writes it stands here.
    bool skip_number() {
        if (front() == '-') ++at;
        const bool begins_with_zero = front() == '0';
        const std::size_t first = at;
        if (!skip_digits() || (begins_with_zero && at > first + 1)) return false;
        if (front() == '.') {
            ++at;
            if (!skip_digits()) return false;
        }
        if (front() != 'e' && front() != 'E') return true;
        ++at;
        if (front() == '+' || front() == '-') ++at;
        return skip_digits();
    }

    bool take_number(double& value) {
        skip_blanks();
        const std::size_t first = at;
        if (!skip_number()) return false;
        const std::string_view found = text.substr(first, at - first);
        const auto number = leading_number(found);
        if (!number) return false;
        value = found == "-0" ? 0.0 : number->value;  // a whole number has no negative zero
        return true;
    }
};

struct Item {
    std::array<double, 2> numbers;
    std::size_t count;
    std::size_t length;  // in the text, with what stands behind it up to the next item or the end of the list
};

std::optional<Item> item_at(std::string_view text, ListItem kind) {
    Cursor cursor{text};
    Item item{{}, kind == ListItem::pair ? 2U : 1U, 0};
    const bool is_whole = kind == ListItem::pair
                              ? cursor.accept('[') && cursor.take_number(item.numbers[0]) && cursor.accept(',') &&
                                    cursor.take_number(item.numbers[1]) && cursor.accept(']')
                              : cursor.take_number(item.numbers[0]);
    if (!is_whole) return std::nullopt;
    const bool goes_on = cursor.accept(',');
    cursor.skip_blanks();
    item.length = cursor.at;
    const char next = cursor.front();
    const bool is_item_next = kind == ListItem::pair ? next == '[' : next == '-' || (next >= '0' && next <= '9');
    return (goes_on ? is_item_next : next == ']') ? std::optional(item) : std::nullopt;
}

}  // namespace

Json take_numbers(TextStream& text, ListItem kind, const NumbersTaken& taken) {
    std::vector<std::uint8_t> bytes;
    for (;;) {
        std::string_view ahead = text.ahead(longest_item);
        const std::size_t all = ahead.size();
        const std::size_t taken_before = bytes.size();
        bool is_last = false;
        while (!is_last && (ahead.size() >= longest_item || all < longest_item)) {
            const auto item = item_at(ahead, kind);
            is_last = !item;
            if (!item) break;
            const auto* first = reinterpret_cast<const std::uint8_t*>(item->numbers.data());
            bytes.insert(bytes.end(), first, first + item->count * sizeof(double));
            ahead.remove_prefix(item->length);
        }
        text.skip(all - ahead.size());
        if (taken && bytes.size() > taken_before) taken(std::span(bytes).subspan(taken_before));
        if (is_last) return Json::binary(std::move(bytes), kind == ListItem::pair ? 2 : 1);
    }
}

Json json_number(double value) {
    std::string text;
    append_json_text(text, value);
    return Json::parse(text);
}

}  // namespace batten::core
