#include "render/clip.h"

#include <algorithm>
#include <utility>

namespace batten::render {
namespace {

/// Keeps the side of `polygon` where sign * (coordinate - limit) >= 0.
std::vector<glm::dvec2> clip_side(const std::vector<glm::dvec2>& polygon, int axis, double limit, double sign) {
    std::vector<glm::dvec2> kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        const double depth_a = sign * (a[axis] - limit);
        const double depth_b = sign * (b[axis] - limit);
        if (depth_a >= 0.0) kept.push_back(a);
        if ((depth_a >= 0.0) == (depth_b >= 0.0)) continue;
        // Exactly on the side, however far away the ends are.
        glm::dvec2 crossing = a + (b - a) * (depth_a / (depth_a - depth_b));
        crossing[axis] = limit;
        kept.push_back(crossing);
    }
    return kept;
}

}  // namespace

std::optional<SegmentPart> clip_segment(const PixelBox& box, glm::dvec2 a, glm::dvec2 b) {
    SegmentPart part;
    for (int axis = 0; axis < 2; ++axis) {
        const double delta = b[axis] - a[axis];
        if (delta == 0.0) {
            if (a[axis] < box.lower_px[axis] || a[axis] > box.upper_px[axis]) return std::nullopt;
            continue;
        }
        double enter = (box.lower_px[axis] - a[axis]) / delta;
        double leave = (box.upper_px[axis] - a[axis]) / delta;
        if (enter > leave) std::swap(enter, leave);
        part.first = std::max(part.first, enter);
        part.last = std::min(part.last, leave);
    }
    if (part.first > part.last) return std::nullopt;
    return part;
}

std::vector<glm::dvec2> clip_polygon(const PixelBox& box, std::vector<glm::dvec2> polygon) {
    const bool is_inside =
        std::all_of(polygon.begin(), polygon.end(), [&](glm::dvec2 point) { return box.contains(point); });
    if (is_inside) return polygon;
    for (int axis = 0; axis < 2; ++axis) {
        polygon = clip_side(polygon, axis, box.lower_px[axis], 1.0);
        polygon = clip_side(polygon, axis, box.upper_px[axis], -1.0);
    }
    return polygon;
}

}  // namespace batten::render
