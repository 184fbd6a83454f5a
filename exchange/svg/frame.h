/// The boxes at whose edges viewers cut off what is drawn in them.
#pragma once

#include <cstddef>
#include <memory>

#include "core/curve/curve.h"
#include "core/edit/plane_map.h"

namespace batten::exchange {

/// The box of an inner svg element or of a symbol.
struct SvgFrame {
    core::Box box{};
    core::PlaneMap map{};  ///< affine, with the pivot 0, from where the box is to the plane
    std::shared_ptr<const SvgFrame> outer{};
};

/// Of so many frames that are turned or sheared the curve itself is looked at, of further ones its control points.
inline constexpr std::size_t most_turned_frames = 8;

/// Whether a curve of the plane reaches beyond `frame` or one around it by more than rounding; not where these are
/// mapped onto a line. No frame holds everything. Cost O(points + frames), times up to `most_turned_frames` for the
/// points.
bool is_cut_off(const core::Curve& curve, const SvgFrame* frame);

}  // namespace batten::exchange
