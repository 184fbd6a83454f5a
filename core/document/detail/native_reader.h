/// Makes documents of the text of native files.
#pragma once

#include "core/document/detail/text_stream.h"
#include "core/document/document.h"

namespace batten::core {

/// The document in `text`, checked completely; see parse_document in native_file.h.
[[nodiscard]] FileResult<Document> read_document(TextStream& text);

}  // namespace batten::core
