#include "core/base/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace batten::core {

std::string shortest_text(double value) {
    std::string text;
    append_shortest_text(text, value);
    return text;
}

void append_shortest_text(std::string& text, double value) {
    std::array<char, 32> buffer{};
    char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text.append(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
}

std::optional<LeadingNumber> leading_number(std::string_view text) {
    const std::size_t sign = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    return LeadingNumber{value, static_cast<std::size_t>(end - text.data())};
}

}  // namespace batten::core
