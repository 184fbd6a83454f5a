#include "core/document.h"

#include <algorithm>

namespace batten::core {

namespace {

bool has_name(const Document& document, const std::string& name) {
    return std::any_of(document.curves.begin(), document.curves.end(),
                       [&](const DocumentCurve& curve) { return curve.name == name; });
}

// "wave" for "wave 2"; the text itself where no number follows a blank.
std::string without_number(const std::string& name) {
    const std::size_t last_letter = name.find_last_not_of("0123456789");
    const bool is_numbered = last_letter != std::string::npos && last_letter > 0 && last_letter + 1 < name.size() &&
                             name[last_letter] == ' ';
    return is_numbered ? name.substr(0, last_letter) : name;
}

}  // namespace

std::string unused_name(const Document& document, const std::string& wish) {
    const std::string first = wish.empty() ? "curve" : wish;
    if (!has_name(document, first)) return first;
    const std::string stem = without_number(first);
    std::size_t number = 2;
    while (has_name(document, stem + " " + std::to_string(number))) ++number;
    return stem + " " + std::to_string(number);
}

}  // namespace batten::core
