#include "exchange/svg/conditions.h"

#include <algorithm>
#include <string_view>

#include "core/base/ascii.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

// "en" or "en-GB", in capitals or not.
bool is_english(std::string_view tag) {
    return core::in_small_letters(tag.substr(0, 2)) == "en" && (tag.size() == 2 || tag[2] == '-');
}

// Tags with commas between.
bool has_english(std::string_view tags) {
    while (!tags.empty()) {
        const std::string_view tag = tags.substr(0, tags.find(','));
        if (is_english(core::trimmed(tag, svg_blanks))) return true;
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
