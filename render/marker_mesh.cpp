#include "render/marker_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace batten::render {

void append_marker(Mesh<MarkerVertex>& mesh, const Marker& marker, const PixelBox& visible, double scale) {
    const glm::dvec2 center = glm::dvec2(marker.center) * scale;
    const bool is_diamond = marker.shape == MarkerShape::diamond;
    const double radius = marker.radius_px * scale * (is_diamond ? 0.5 * std::numbers::sqrt2 : 1.0);
    const double half_outline = marker.outline.alpha > 0 ? 0.5 * marker.outline_px * scale : 0.0;
    const double reach = radius + half_outline + 0.5;
    const double margin = reach * std::numbers::sqrt2;
    if (!PixelBox{visible.lower_px - margin, visible.upper_px + margin}.contains(center)) return;

    const glm::dvec2 x_axis =
        is_diamond ? glm::dvec2(0.5 * std::numbers::sqrt2, 0.5 * std::numbers::sqrt2) : glm::dvec2(1.0, 0.0);
    const glm::dvec2 y_axis{-x_axis.y, x_axis.x};
    const std::uint32_t first = mesh.next_index();
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
        const glm::dvec2 local = corner * reach;
        mesh.vertices.push_back({glm::vec2(center + x_axis * local.x + y_axis * local.y), glm::vec2(local),
                                 marker.shape == MarkerShape::disc ? 1.0F : 0.0F, static_cast<float>(radius),
                                 static_cast<float>(half_outline), marker.fill, marker.outline});
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 3U, 0U}) mesh.indices.push_back(first + corner);
}

bool has_dashed_ring(const Marker& marker) {
    return marker.shape == MarkerShape::disc && marker.dash_px > 0.0F && marker.radius_px > 0.0F &&
           marker.outline_px > 0.0F && marker.outline.alpha > 0;
}

Polyline dashed_ring(const Marker& marker, double scale) {
    const double radius = marker.radius_px;
    const double dashes = std::max(1.0, std::round(std::numbers::pi * radius / marker.dash_px));
    // A chord of angle a stays within radius * a^2 / 8 of its arc: here within 1/12 of a framebuffer pixel.
    const double corners =
        std::clamp(std::ceil(2.0 * std::numbers::pi * std::sqrt(radius * scale * 12.0 / 8.0)), 12.0, 720.0);
    const double chord = 2.0 * radius * std::sin(std::numbers::pi / corners);

    Polyline ring;
    ring.color = marker.outline;
    ring.width_px = marker.outline_px;
    ring.dash_px = static_cast<float>(0.5 * corners * chord / dashes);
    ring.gap_px = ring.dash_px;
    ring.is_closed = true;
    for (int i = 0; i < static_cast<int>(corners); ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        ring.points.emplace_back(glm::dvec2(marker.center) + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

}  // namespace batten::render
