/// Makes documents of the text of native files.
#pragma once

#include "core/document/detail/text_stream.h"
#include "core/document/native_file.h"

namespace batten::core {

/// The document in `text`, checked completely; see parse_document in native_file.h. `points_read` is told its points.
[[nodiscard]] FileResult<Document> read_document(TextStream& text, const PointsRead& points_read = {});

}  // namespace batten::core
