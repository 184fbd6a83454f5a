/// Finds what is missing or damaged in the text of a STEP file, which OpenCASCADE takes for zeros.
#pragma once

#include <optional>
#include <string_view>

#include "core/document/file_text.h"

namespace batten::exchange {

/// The first defect, with its line; none where the file is whole (ISO 10303-21): it begins and ends as every STEP file
/// does, each instance in its data is written by the grammar and numbered once, and whatever an instance names is
/// there. A byte order mark and empty statements are none. Cost O(n log n).
std::optional<core::FileError> step_defect(std::string_view text);

}  // namespace batten::exchange
