/// What documents that can be recovered are called.
#pragma once

#include <span>
#include <string>

#include "app/editor/state/recoverable.h"

namespace batten::editor {

/// "wave.json", or "section/wave.json" where another one of `all` has a file of that name in another folder; "untitled"
/// without a file.
std::string recoverable_name(const Recoverable& document, std::span<const Recoverable> all);

}  // namespace batten::editor
