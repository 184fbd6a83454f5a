/// Which color each control point has: points keep theirs while others come and go around them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>

#include "app/editor/state/theme.h"
#include "core/document/document.h"

namespace batten::editor {

/// How many different colors there are.
inline constexpr std::size_t hue_count = std::tuple_size_v<decltype(Theme::palette)>;

/// A new point has another color than so many neighbors on each side; with the point itself they are fewer than colors.
inline constexpr std::size_t hue_neighbors = 3;

/// The first color from `start` on, round the palette, that is not among `near`; `start` where all are.
std::size_t free_hue(std::span<const std::uint8_t> near, std::size_t start);

/// The place in the palette, for Theme::point(), of control point `i` of the curve; that of its index, until points
/// came or went.
std::size_t point_hue(const core::DocumentCurve& entry, std::size_t i);

/// Gives the entry another curve, which came of the present one, and which is made of no fit points. As many points as
/// before keep their colors and pins in order; others have those of their origins (point_origins.h). A point that has
/// no older one gets the next color that none of three neighbors on each side has. Cost O(n p) where the number of
/// points changes.
void replace_curve(core::DocumentCurve& entry, std::shared_ptr<const core::Curve> curve);

}  // namespace batten::editor
