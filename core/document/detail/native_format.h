/// What the reader and the writer of native files must agree on.
#pragma once

#include <nlohmann/json.hpp>

namespace batten::core {

/// Keeps the order of members, so that a file comes back as it was written.
using Json = nlohmann::ordered_json;

inline constexpr const char* format_name = "batten";
inline constexpr int format_version = 1;

}  // namespace batten::core
