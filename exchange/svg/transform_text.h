/// Where SVG elements are moved to, by the attribute transform or the CSS property.
#pragma once

#include <optional>
#include <string_view>

#include "core/edit/plane_map.h"
#include "exchange/svg/style.h"
#include "exchange/svg/viewport.h"

namespace batten::exchange {

/// First `inner`, then `outer`: both are affine, with the pivot 0.
core::PlaneMap chained(const core::PlaneMap& outer, const core::PlaneMap& inner);

/// The map of a list of matrix, translate, scale, rotate, skewX and skewY, with the pivot 0; none where the text is no
/// such list.
std::optional<core::PlaneMap> read_transform(std::string_view text);

/// The same for the functions of CSS in the plane, whose lengths and angles have units; % are parts of `viewport`.
std::optional<core::PlaneMap> read_css_transform(std::string_view text, const Viewport& viewport);

/// How an element is moved as a whole: its style, else its attribute, about its transform-origin; nowhere where it says
/// nothing. None where that cannot be read.
std::optional<core::PlaneMap> transform_of(const SvgProperties& properties, const Viewport& viewport);

}  // namespace batten::exchange
