#include "render/lean_path.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

namespace batten::render {

std::vector<Pixel> lean_points(const std::vector<Pixel>& points) {
    constexpr float least_step = 0.05F;
    std::vector<Pixel> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_near = !kept.empty() && glm::distance(kept.back(), points[i]) < least_step;
        if (!is_near)
            kept.push_back(points[i]);
        else if (i + 1 == points.size() && kept.size() > 1)
            kept.back() = points[i];
    }
    return kept;
}

std::vector<Pixel> marker_corners(const Marker& marker) {
    const Pixel c = marker.center;
    const float r = marker.radius_px;
    if (marker.shape == MarkerShape::square)
        return {{c.x - r, c.y - r}, {c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}};
    return {{c.x - r, c.y}, {c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}};
}

std::string short_number(double number) {
    std::string text = fmt::format("{:.2f}", number);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string short_place(glm::dvec2 place, char between) {
    return short_number(place.x) + between + short_number(place.y);
}

}  // namespace batten::render
