/// How much memory documents take that share curves.
#pragma once

#include <cstddef>

#include "core/document/document.h"

namespace batten::editor {

/// The bytes of the curves of `document`: their arrays of knots, control points and weights, each once, and what each
/// curve takes beside them. Those arrays that `other` holds too are not counted; it may be null.
std::size_t bytes_beside(const core::Document& document, const core::Document* other);

}  // namespace batten::editor
