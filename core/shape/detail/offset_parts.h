/// The untrimmed offset, part by part.
#pragma once

#include <vector>

#include "core/shape/detail/offset_source.h"
#include "core/shape/offset_shape.h"

namespace batten::core {

enum class OffsetPartKind {
    raw,    ///< stands for the true offset, over the parameters of the source
    exact,  ///< the true offset of a line or an arc; or what goes around a corner
    cap
};

struct OffsetPart {
    Curve curve;
    OffsetPartKind kind = OffsetPartKind::exact;
    std::size_t source = 0;
    bool is_cut_off = false;  ///< a straight line nearer to `center`, a corner or end, than the distance
    Point center{};
};

/// The parts of the offset of `source`, whose number is given, in order: of each stretch, and around each corner on its
/// outer side. Ends that meet are bit-equal. Errors: those of fit_offset.
[[nodiscard]] Result<std::vector<OffsetPart>> offset_parts(const OffsetSource& source, std::size_t number,
                                                           const OffsetRequest& request);

/// The cap from the end of the last of `parts` to `to`, around the end of its source, `source`.
[[nodiscard]] Result<OffsetPart> offset_cap(const OffsetSource& source, std::size_t number,
                                            const std::vector<OffsetPart>& parts, Point to, OffsetCaps caps);

}  // namespace batten::core
