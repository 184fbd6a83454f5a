/// What changed from one document to the next, in few bytes where it is little.
#pragma once

#include <string>

#include "app/editor/recovery/document_pieces.h"

namespace batten::editor {

/// How `next` is made of `previous`: curves as they were, and of others what lies between the first and the last byte
/// that differs. Costs a comparison of those arrays that are not shared. The first document follows on none, {}.
std::string delta_between(const DocumentPieces& previous, const DocumentPieces& next);

/// The pieces that `delta` makes of `previous`. Refused where it cannot be one of these.
[[nodiscard]] Outcome<DocumentPieces> with_delta(const DocumentPieces& previous, std::string_view delta);

}  // namespace batten::editor
