#include "tests/fuzz/sample_state.h"

#include "core/document/native_file.h"
#include "tests/editor/sample_editor.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

editor::Editor sample_editor() {
    return editor::Editor(core::parse_document(editor::sample_text).value());
}

void require_sound(const core::Document& document) {
    for (const core::DocumentCurve& entry : document.curves) {
        const auto made = core::Curve::make(entry.curve->definition());
        require(made.has_value() && *made == *entry.curve, "every curve is valid");
    }
    const std::string text = core::format_document(document);
    const auto read = core::parse_document(text);
    require(read.has_value(), "the document can be read again");
    require(core::format_document(*read) == text, "the document read again is the same");
}

}  // namespace batten::fuzz
