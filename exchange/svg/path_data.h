/// The commands of an SVG path.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "core/edit/plane_map.h"
#include "exchange/outline.h"

namespace batten::exchange {

/// Takes the outline of each subpath that draws something, which has been mapped; false ends the reading.
using OutlineSink = std::function<bool(Outline outline)>;

/// Reads the attribute d: all commands of SVG 2, in full or short, arcs as exact conics. Every control point is mapped
/// by `map`, an affine one. Returns where the text goes wrong, counted from 0, if it does: what stands before is read,
/// as SVG asks for. Cost O(length of the text).
std::optional<std::size_t> read_path_data(std::string_view text, const core::PlaneMap& map, const OutlineSink& sink);

}  // namespace batten::exchange
