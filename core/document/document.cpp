#include "core/document/document.h"

namespace batten::core {

namespace {

bool has_name(const Document& document, const std::string& name) {
    return index_of_curve(document, name).has_value();
}

// "wave" for "wave 2"; the text itself where no number follows a blank.
std::string without_number(const std::string& name) {
    const std::size_t last_letter = name.find_last_not_of("0123456789");
    const bool is_numbered = last_letter != std::string::npos && last_letter > 0 && last_letter + 1 < name.size() &&
                             name[last_letter] == ' ';
    return is_numbered ? name.substr(0, last_letter) : name;
}

}  // namespace

std::optional<std::size_t> index_of_curve(const Document& document, const std::string& name) {
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (document.curves[i].name == name) return i;
    return std::nullopt;
}

std::string quoted_names(const Document& document) {
    std::string names;
    for (const DocumentCurve& curve : document.curves) names += (names.empty() ? "'" : ", '") + curve.name + "'";
    return names.empty() ? "none" : names;
}

std::string unused_name(const Document& document, const std::string& wish) {
    const std::string first = wish.empty() ? "curve" : wish;
    if (!has_name(document, first)) return first;
    const std::string stem = without_number(first);
    std::size_t number = 2;
    while (has_name(document, stem + " " + std::to_string(number))) ++number;
    return stem + " " + std::to_string(number);
}

}  // namespace batten::core
