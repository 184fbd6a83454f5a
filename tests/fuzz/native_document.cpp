// What can be read is written and read again to the same text; what cannot has a sentence.

#include "core/document/native_file.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const auto document = core::parse_document(bytes);
    if (!document) return require(!document.error().what.empty(), "a refusal says why");
    const std::string text = core::format_document(*document);
    const auto again = core::parse_document(text);
    require(again.has_value(), "what was written can be read");
    require(core::format_document(*again) == text, "what was read again is the same");
}

}  // namespace batten::fuzz
