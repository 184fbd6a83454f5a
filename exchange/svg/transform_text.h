/// The attribute transform of SVG.
#pragma once

#include <optional>
#include <string_view>

#include "core/edit/plane_map.h"

namespace batten::exchange {

/// First `inner`, then `outer`: both are affine, with the pivot 0.
core::PlaneMap chained(const core::PlaneMap& outer, const core::PlaneMap& inner);

/// The map of a list of matrix, translate, scale, rotate, skewX and skewY, with the pivot 0; none where the text is no
/// such list.
std::optional<core::PlaneMap> read_transform(std::string_view text);

}  // namespace batten::exchange
