/// Whether a text is JSON that is safe to read, for readers of other files than documents.
#pragma once

#include <string_view>

#include "core/document/file_text.h"

namespace batten::core {

/// Refused with "line L, column C": what is not JSON, numbers too large for a double, text that is not UTF-8, a zero
/// byte, a member that occurs twice in one object, and what goes beyond the limits of the native format (FORMAT.md) in
/// nesting, members, values and bytes. What is not refused can be walked by recursion. Cost: that of reading it.
[[nodiscard]] FileResult<void> check_json(std::string_view text);

}  // namespace batten::core
