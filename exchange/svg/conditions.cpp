#include "exchange/svg/conditions.h"

#include <algorithm>
#include <string_view>

namespace batten::exchange {

namespace {

// "en" or "en-GB", in capitals or not.
bool is_english(std::string_view tag) {
    const auto is = [&](std::size_t i, char small, char capital) { return tag[i] == small || tag[i] == capital; };
    return tag.size() >= 2 && is(0, 'e', 'E') && is(1, 'n', 'N') && (tag.size() == 2 || tag[2] == '-');
}

// Tags with commas between.
bool has_english(std::string_view tags) {
    while (!tags.empty()) {
        const std::string_view tag = tags.substr(0, tags.find(','));
        const std::size_t start = std::min(tag.find_first_not_of(" \t\r\n\f"), tag.size());
        const std::size_t end = tag.find_last_not_of(" \t\r\n\f") + 1;
        if (start < end && is_english(tag.substr(start, end - start))) return true;
        tags.remove_prefix(std::min(tag.size() + 1, tags.size()));
    }
    return false;
}

}  // namespace

bool is_for_english_viewers(const pugi::xml_node& element) {
    const pugi::xml_attribute language = element.attribute("systemLanguage");
    return !element.attribute("requiredExtensions") && (!language || has_english(language.value()));
}

}  // namespace batten::exchange
