#include "core/document/document.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace batten::core {

namespace {

// "wave" for "wave 2"; the text itself where no number follows a blank.
std::string without_number(const std::string& name) {
    const std::size_t last_letter = name.find_last_not_of("0123456789");
    const bool is_numbered = last_letter != std::string::npos && last_letter > 0 && last_letter + 1 < name.size() &&
                             name[last_letter] == ' ';
    return is_numbered ? name.substr(0, last_letter) : name;
}

std::string numbered(const std::string& stem, std::size_t number) {
    return fmt::format("{} {}", stem, number);
}

}  // namespace

std::string color_text(DocumentColor color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue);
}

std::optional<DocumentColor> color_of_text(std::string_view text) {
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    std::array<std::uint8_t, 3> parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const char* begin = text.data() + 1 + 2 * i;
        const auto [end, error] = std::from_chars(begin, begin + 2, parts[i], 16);
        if (error != std::errc() || end != begin + 2) return std::nullopt;
    }
    return DocumentColor{parts[0], parts[1], parts[2]};
}

Tears tears_of(const DocumentCurve& entry) {
    return entry.curve->is_torn() ? Tears::allow : entry.tears;
}

std::optional<std::size_t> index_of_curve(const Document& document, const std::string& name) {
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (document.curves[i].name == name) return i;
    return std::nullopt;
}

std::optional<std::size_t> curve_meant_by(const Document& document, const std::string& text) {
    if (const auto index = index_of_curve(document, text)) return index;
    std::size_t number = 0;
    const char* end = text.data() + text.size();
    const auto [read_end, error] = std::from_chars(text.data(), end, number);
    const bool is_number = error == std::errc() && read_end == end && number < document.curves.size();
    return is_number ? std::optional(number) : std::nullopt;
}

std::string quoted_names(const Document& document) {
    std::vector<std::string> names;
    for (const DocumentCurve& curve : document.curves) names.push_back(fmt::format("'{}'", curve.name));
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::string unused_name(const Document& document, const std::string& wish) {
    return FreeNames(document).take(wish);
}

FreeNames::FreeNames(const Document& document) {
    for (const DocumentCurve& entry : document.curves) used_.insert(entry.name);
}

std::string FreeNames::take(const std::string& wish) {
    std::string name = wish.empty() ? "curve" : wish;
    if (used_.contains(name)) {
        const std::string stem = without_number(name);
        std::size_t& number = next_numbers_.try_emplace(stem, 2).first->second;
        do name = numbered(stem, number++);
        while (used_.contains(name));
    }
    used_.insert(name);
    return name;
}

}  // namespace batten::core
