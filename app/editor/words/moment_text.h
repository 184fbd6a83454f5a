/// When something was, as people say it.
#pragma once

#include <cstdint>
#include <string>

namespace batten::editor {

/// "today at 15:04", "yesterday at 15:04" or "on November 21, 2026 at 15:04": `seconds` since 1970 in the user's time
/// zone, as it is said at `now`.
std::string moment_text(std::int64_t seconds, std::int64_t now);

}  // namespace batten::editor
