/// An axis or a center that is chosen by clicks on the canvas, for what makes images of a curve.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/geometry.h"
#include "core/base/names.h"

namespace batten::editor {

/// What the axis, or the center, is for.
enum class AxisUse { mirror, link_mirror, link_rotation, array_polar };

struct AxisPick {
    AxisUse use = AxisUse::mirror;
    std::size_t count = 0;               ///< how many curves there shall be around a center
    std::optional<core::Point> first{};  ///< of the two points of an axis
    bool is_smooth = true;               ///< of a mirror link: ends near the axis meet their images smoothly
    bool operator==(const AxisPick&) const = default;
};

/// Whether two clicks are needed; one does for a center.
constexpr bool needs_axis(AxisUse use) {
    return use == AxisUse::mirror || use == AxisUse::link_mirror;
}

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::AxisUse> {
    using enum editor::AxisUse;
    static constexpr std::array table{
        Named{mirror, "mirror", "mirror"}, Named{link_mirror, "link-mirror", "mirror image"},
        Named{link_rotation, "link-rotation", "rotated images"}, Named{array_polar, "array-polar", "ring of copies"}};
};

}  // namespace batten::core
