#include "render/ink_mesh.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

namespace batten::render {

namespace {

constexpr int tile_px = 32;
constexpr float far_inside_px = 1e3F;

enum class Cover { none, mixed, full };

Cover cover_of(const CoverageMap& map, const PixelRange& range) {
    const auto width = static_cast<std::size_t>(map.size_px().x);
    bool has_any = false;
    bool has_all = true;
    for (int y = range.lower.y; y < range.upper.y; ++y) {
        const auto first = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(range.lower.x);
        const auto row = map.values().subspan(first, static_cast<std::size_t>(range.upper.x - range.lower.x));
        has_any = has_any || std::any_of(row.begin(), row.end(), [](std::uint8_t value) { return value != 0; });
        has_all = has_all && std::all_of(row.begin(), row.end(), [](std::uint8_t value) { return value == 255; });
    }
    if (!has_any) return Cover::none;
    return has_all ? Cover::full : Cover::mixed;
}

/// The corners of a rectangle, as fractions of it.
constexpr std::array corners{glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), glm::dvec2(1.0, 1.0)};

template <class Vertex, class MakeVertex>
void append_rectangle(Mesh<Vertex>& mesh, const PixelRange& range, MakeVertex make_vertex) {
    const std::uint32_t first = mesh.next_index();
    for (const glm::dvec2 corner : corners)
        mesh.vertices.push_back(make_vertex(glm::dvec2(range.lower) + corner * glm::dvec2(range.upper - range.lower)));
    for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) mesh.indices.push_back(first + corner);
}

}  // namespace

void append_ink(Mesh<FillVertex>& covered, Mesh<InkVertex>& mixed, const Ink& ink, double scale) {
    const PixelRange all = ink.map->touched();
    if (all.is_empty() || ink.color.alpha == 0) return;
    const glm::dvec2 extent(all.upper - all.lower);
    const auto append = [&](const PixelRange& range, Cover cover) {
        if (cover == Cover::full)
            append_rectangle(covered, range, [&](glm::dvec2 place) {
                return FillVertex{glm::vec2(scale * place), far_inside_px, ink.color};
            });
        if (cover == Cover::mixed)
            append_rectangle(mixed, range, [&](glm::dvec2 place) {
                const glm::dvec2 share = (place - glm::dvec2(all.lower)) / extent;
                return InkVertex{glm::vec2(scale * place), glm::vec2(share), ink.color};
            });
    };
    // Neighbors in a row that are covered alike become one rectangle.
    for (int y = all.lower.y; y < all.upper.y; y += tile_px) {
        PixelRange run{{all.lower.x, y}, {all.lower.x, std::min(y + tile_px, all.upper.y)}};
        Cover cover = Cover::none;
        while (run.upper.x < all.upper.x) {
            const PixelRange tile{{run.upper.x, y}, {std::min(run.upper.x + tile_px, all.upper.x), run.upper.y}};
            const Cover next = cover_of(*ink.map, tile);
            if (next != cover) {
                append(run, cover);
                run.lower.x = tile.lower.x;
                cover = next;
            }
            run.upper.x = tile.upper.x;
        }
        append(run, cover);
    }
}

}  // namespace batten::render
