/// Whether two documents are equal, whatever steps led to them.
#pragma once

#include "core/document/document.h"

namespace batten::editor {

/// Whether title, curves and view agree; curves are compared by value. Cheap for curves that are shared.
bool has_same_content(const core::Document& a, const core::Document& b);

/// The same, and the active curve is the same.
bool is_same_document(const core::Document& a, const core::Document& b);

}  // namespace batten::editor
