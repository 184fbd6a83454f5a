/// The entities that an SVG file defines for itself, which are not expanded.
#pragma once

#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>

namespace batten::exchange {

/// The names of the entities that the DOCTYPE of `file`, the root of the tree, defines.
std::set<std::string, std::less<>> entity_names(const pugi::xml_node& file);

/// The first of the entities `names` that stands in an attribute or a text of `element` itself, but for names of
/// namespaces, from which nothing is drawn. Cost O(length of these).
std::optional<std::string_view> used_entity(const pugi::xml_node& element,
                                            const std::set<std::string, std::less<>>& names);

}  // namespace batten::exchange
