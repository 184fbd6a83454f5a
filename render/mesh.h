/// Triangles ready for upload: vertices of one kind and the indices that join them.
#pragma once

#include <cstdint>
#include <vector>

namespace batten::render {

template <typename Vertex>
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

    /// The index that the next vertex will get.
    [[nodiscard]] std::uint32_t next_index() const { return static_cast<std::uint32_t>(vertices.size()); }

    /// Empties the mesh and keeps its memory for the next frame.
    void clear() {
        vertices.clear();
        indices.clear();
    }
};

}  // namespace batten::render
