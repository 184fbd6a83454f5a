#include "exchange/svg/entities.h"

#include <algorithm>

#include "core/base/ascii.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

std::optional<std::string_view> entity_in(std::string_view text, const std::set<std::string, std::less<>>& names) {
    for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
        constexpr std::size_t longest = 256;
        const std::string_view rest = text.substr(at + 1, longest);
        const std::string_view name = rest.substr(0, std::min(rest.find(';'), rest.size()));
        if (name.size() < rest.size() && names.contains(name)) return name;
    }
    return std::nullopt;
}

}  // namespace

std::set<std::string, std::less<>> entity_names(const pugi::xml_node& file) {
    constexpr std::string_view beginning = "<!ENTITY";
    std::set<std::string, std::less<>> names;
    for (const pugi::xml_node& node : file.children()) {
        if (node.type() != pugi::node_doctype) continue;
        const std::string_view text = node.value();
        for (std::size_t at = text.find(beginning); at != std::string_view::npos; at = text.find(beginning, at + 1)) {
            const std::string_view rest = core::trimmed(text.substr(at + beginning.size()), svg_blanks);
            names.emplace(rest.substr(0, std::min(rest.find_first_of(svg_blanks), rest.size())));
        }
    }
    return names;
}

std::optional<std::string_view> used_entity(const pugi::xml_node& element,
                                            const std::set<std::string, std::less<>>& names) {
    if (names.empty()) return std::nullopt;
    for (const pugi::xml_attribute& attribute : element.attributes()) {
        if (std::string_view(attribute.name()).starts_with("xmlns")) continue;
        if (const auto found = entity_in(attribute.value(), names)) return found;
    }
    for (const pugi::xml_node& part : element.children())
        if (const auto found = entity_in(part.value(), names)) return found;
    return std::nullopt;
}

}  // namespace batten::exchange
