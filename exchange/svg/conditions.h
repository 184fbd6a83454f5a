/// Which parts of an SVG are meant for whom.
#pragma once

#include <pugixml.hpp>

namespace batten::exchange {

/// Whether a viewer draws the element for someone who reads English: its systemLanguage, where it has one, names that
/// language, and it asks for no extension. requiredFeatures is always met, as SVG 2 says.
bool is_for_english_viewers(const pugi::xml_node& element);

}  // namespace batten::exchange
