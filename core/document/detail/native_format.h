/// What the reader and the writer of native files must agree on.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/curve/knot_vector.h"

namespace batten::core {

/// Keeps the order of members, so that a file comes back as it was written.
using Json = nlohmann::ordered_json;

inline constexpr const char* format_name = "batten";
inline constexpr int format_version = 1;

/// How a knot kind is called in files.
inline constexpr std::array<std::pair<KnotKind, const char*>, 6> kind_names{{
    {KnotKind::uniform, "uniform"},
    {KnotKind::clamped_uniform, "clamped-uniform"},
    {KnotKind::bezier, "bezier"},
    {KnotKind::piecewise_bezier, "piecewise-bezier"},
    {KnotKind::periodic, "periodic"},
    {KnotKind::custom, "custom"},
}};

}  // namespace batten::core
