/// Whether mapping a curve by its control points agrees with mapping its points.
#pragma once

#include <optional>
#include <vector>

#include "core/edit/transform.h"

namespace batten::editor {

struct MappedCurve {
    core::Curve curve;
    core::PlaneMap map;
};

/// What both ways lead to, and how far they are apart.
struct MapCheck {
    core::Result<core::Curve> image;             ///< mapped by control points, and weights where that is needed
    core::Box box{};                             ///< of the control points before and after
    std::vector<core::Point> points{};           ///< of the curve, at even parameters
    std::vector<core::Point> evaluated_first{};  ///< their images
    std::vector<core::Point> mapped_first{};     ///< points of `image` at the same parameters
    core::MapDifference difference{};

    /// What the points and the difference would be with the old weights; none where these stay.
    std::vector<core::Point> weights_kept{};
    std::optional<core::MapDifference> kept_difference{};

    /// Whether both are the same but for rounding.
    bool agrees() const;
};

/// At how many parameters the two are compared.
inline constexpr int compared_parameters = 241;

/// Cost O(n).
MapCheck check_map(const MappedCurve& mapped);

}  // namespace batten::editor
