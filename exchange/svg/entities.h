/// The entities that an SVG file defines for itself, which are not expanded.
#pragma once

#include <string_view>

#include "exchange/notes.h"

namespace batten::exchange {

/// Tells in `left_out` which elements of `text`, an SVG file, have entities that its DOCTYPE defines, in an attribute
/// or a text; names of namespaces do not count, from which nothing is drawn, nor does what is escaped or commented.
/// Nothing where `text` is no XML. Cost O(n log(entities)).
void tell_entities(std::string_view text, Notes& left_out);

}  // namespace batten::exchange
