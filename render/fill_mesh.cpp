#include "render/fill_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/clip.h"

namespace batten::render {
namespace {

constexpr double shortest_side_px = 0.01;
constexpr double least_area_px = 1e-3;
constexpr double fringe_px = 0.5;
constexpr double longest_spike_px = 2.0;  // of the fringe at a sharp corner

std::vector<glm::dvec2> distinct_corners(const std::vector<glm::dvec2>& polygon) {
    std::vector<glm::dvec2> corners;
    for (const glm::dvec2 point : polygon) {
        if (corners.empty() || glm::distance(corners.back(), point) >= shortest_side_px) corners.push_back(point);
    }
    while (corners.size() > 1 && glm::distance(corners.back(), corners.front()) < shortest_side_px) corners.pop_back();
    return corners;
}

double signed_area(const std::vector<glm::dvec2>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // Relative to a corner: far from the origin the products of the coordinates would cancel.
        const glm::dvec2 a = corners[i] - corners[0];
        const glm::dvec2 b = corners[(i + 1) % corners.size()] - corners[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

glm::dvec2 mean_of(const std::vector<glm::dvec2>& corners) {
    glm::dvec2 sum{};
    for (const glm::dvec2 corner : corners) sum += corner;
    return sum / static_cast<double>(corners.size());
}

/// The unit normals of the sides, outwards; side i runs from corner i to the next one.
std::vector<glm::dvec2> outward_normals(const std::vector<glm::dvec2>& corners, double area) {
    std::vector<glm::dvec2> normals;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 direction = glm::normalize(corners[(i + 1) % corners.size()] - corners[i]);
        normals.push_back(glm::dvec2(direction.y, -direction.x) * (area > 0.0 ? 1.0 : -1.0));
    }
    return normals;
}

/// From a corner to where the outer edges of the fringe along its two sides meet, or not quite at a very sharp corner.
glm::dvec2 fringe_corner(glm::dvec2 normal_before, glm::dvec2 normal_after) {
    const glm::dvec2 sum = normal_before + normal_after;
    const double length = glm::length(sum);
    if (length < 1e-9) return {0.0, 0.0};
    return sum / length * std::min(2.0 * fringe_px / length, longest_spike_px);
}

}  // namespace

void append_fill(Mesh<FillVertex>& mesh, const Fill& fill, const PixelBox& visible, double scale) {
    std::vector<glm::dvec2> polygon;
    polygon.reserve(fill.points.size());
    for (const Pixel point : fill.points) polygon.push_back(glm::dvec2(point) * scale);
    constexpr double margin = fringe_px + 1.0;
    const PixelBox seen{visible.lower_px - margin, visible.upper_px + margin};
    const std::vector<glm::dvec2> corners = distinct_corners(clip_polygon(seen, std::move(polygon)));
    if (corners.size() < 3 || fill.color.alpha == 0) return;
    const double area = signed_area(corners);
    if (std::abs(area) < least_area_px) return;

    const std::vector<glm::dvec2> normals = outward_normals(corners, area);
    const glm::dvec2 middle = mean_of(corners);
    const std::uint32_t first = mesh.next_index();
    const auto count = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 outer = corners[i] + fringe_corner(normals[(i + count - 1) % count], normals[i]);
        const double inside = glm::dot(corners[i] - middle, normals[i]);
        mesh.vertices.push_back({glm::vec2(outer), static_cast<float>(-fringe_px), fill.color});
        mesh.vertices.push_back({glm::vec2(middle), static_cast<float>(inside), fill.color});
        for (const std::uint32_t corner : {2 * i, 2 * i + 1, 2 * ((i + 1) % count)})
            mesh.indices.push_back(first + corner);
    }
}

}  // namespace batten::render
