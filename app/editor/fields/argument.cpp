#include "app/editor/fields/argument.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace batten::editor {

namespace {

std::optional<double> number_of(std::string_view word) {
    double value = 0.0;
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
    return is_number ? std::optional(value) : std::nullopt;
}

// "1,2,3" and, so that a list of one can be typed, "1,".
std::optional<std::vector<double>> numbers_of(std::string_view word) {
    std::vector<double> numbers;
    while (!word.empty()) {
        const std::size_t end = std::min(word.find(','), word.size());
        const std::optional<double> number = number_of(word.substr(0, end));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        word.remove_prefix(std::min(end + 1, word.size()));
    }
    return numbers;
}

}  // namespace

Argument parse_argument(const std::string& word) {
    if (const std::optional<double> number = number_of(word)) return *number;
    const bool has_comma = word.find(',') != std::string::npos;
    if (const auto numbers = has_comma ? numbers_of(word) : std::nullopt) return *numbers;
    return word;
}

}  // namespace batten::editor
