/// What ties curves of a document together that are images of each other.
#pragma once

#include <optional>
#include <string>

#include "core/base/geometry.h"

namespace batten::core {

/// The curve is an image of all others of its group. Image `place` is that of number 0 mirrored in the line through
/// `center` in the direction `angle`, or turned about `center` by `place` of `turns` equal parts of a full turn; number
/// 0 itself need not be there.
struct Symmetry {
    static constexpr std::size_t most_turns = 10'000;

    std::size_t group = 0;
    std::size_t place = 0;             ///< 0 or 1 where it is a mirror, else below `turns`
    std::optional<std::size_t> turns;  ///< at least 2; none: a mirror
    Point center{};
    double angle = 90.0;            ///< degrees; of a mirror's line
    std::string unknown_members{};  ///< that this version does not know, as a JSON object; empty if none

    bool operator==(const Symmetry&) const = default;
};

}  // namespace batten::core
