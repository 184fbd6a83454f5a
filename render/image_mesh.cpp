#include "render/image_mesh.h"

#include "render/clip.h"

namespace batten::render {

namespace {

double signed_area(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

void append_image(Mesh<ImageVertex>& mesh, const ImageQuad& quad, const PixelBox& visible, double scale) {
    const glm::dvec2 corner = scale * quad.upper_left;
    const glm::dvec2 along = scale * (quad.upper_right - quad.upper_left);
    const glm::dvec2 down = scale * (quad.lower_left - quad.upper_left);
    const double area = signed_area(along, down);
    if (!(area != 0.0) || quad.opacity <= 0.0) return;
    const std::vector<glm::dvec2> polygon =
        clip_polygon(visible, {corner, corner + along, corner + along + down, corner + down});
    const std::uint32_t first = mesh.next_index();
    for (const glm::dvec2 place : polygon) {
        const glm::dvec2 share =
            glm::dvec2(signed_area(place - corner, down), signed_area(along, place - corner)) / area;
        mesh.vertices.push_back({glm::vec2(place), glm::vec2(share), static_cast<float>(quad.opacity)});
    }
    for (std::uint32_t i = 2; i < polygon.size(); ++i)
        for (const std::uint32_t corner_index : {0U, i - 1, i}) mesh.indices.push_back(first + corner_index);
}

}  // namespace batten::render
