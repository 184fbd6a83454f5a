/// What the brush does, and how large it is.
#pragma once

#include <array>
#include <optional>

#include "core/base/geometry.h"
#include "core/base/names.h"

namespace batten::editor {

enum class BrushKind { soft_move, fair };
inline constexpr std::size_t brush_kind_count = 2;

/// What the radius may be, in design pixels.
inline constexpr core::Interval brush_radii{4.0, 2000.0};

struct Brush {
    BrushKind kind = BrushKind::soft_move;
    double radius = 80.0;            ///< design pixels, within brush_radii
    std::optional<double> distance;  ///< how far fairing may move the curve; none: a hundredth of its size
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::BrushKind> {
    using enum editor::BrushKind;
    static constexpr std::array table{Named{soft_move, "soft-move", "soft move"}, Named{fair, "fair", "fairing"}};
};

}  // namespace batten::core
