/// Text as it stands in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace batten::render {

/// `text`, UTF-8, with &, <, > and quotes as entities, and without the control characters that XML does not allow.
std::string xml_text(std::string_view text);

}  // namespace batten::render
