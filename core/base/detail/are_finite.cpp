#include "core/base/detail/are_finite.h"

#include <array>
#include <numeric>

namespace batten::core {

bool are_finite(std::span<const Point> points) {
    // Zero, or not a number; several sums, so that the compiler forms them side by side.
    std::array<double, 8> sums{};
    const std::size_t quads = points.size() / 4;
    for (std::size_t i = 0; i < 4 * quads; i += 4)
        for (std::size_t k = 0; k < 4; ++k) {
            sums[2 * k] += 0.0 * points[i + k].x;
            sums[2 * k + 1] += 0.0 * points[i + k].y;
        }
    for (std::size_t i = 4 * quads; i < points.size(); ++i) sums[0] += 0.0 * points[i].x + 0.0 * points[i].y;
    return std::accumulate(sums.begin(), sums.end(), 0.0) == 0.0;
}

}  // namespace batten::core
