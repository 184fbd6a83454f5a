/// Buffers on the graphics side for meshes that change with every frame.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "render/gl_object.h"
#include "render/mesh.h"

namespace batten::render {

/// A shader input: `components` floats, or four bytes in 0..1, at `offset` in the vertex. Locations count from 0.
struct GlInput {
    enum class Type { floats, color };
    Type type{};
    int components = 0;
    std::size_t offset = 0;
};

/// A vertex array with its buffers.
class GlStream {
  public:
    GlStream(std::size_t vertex_size, std::initializer_list<GlInput> inputs);

    /// Replaces the contents. The storage is new each time, so that a frame still being painted is not waited for.
    template <typename Vertex>
    void upload(const Mesh<Vertex>& mesh) {
        upload(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex), mesh.indices);
    }

    /// Paints the triangles of `count` indices from `first`.
    void draw(std::uint32_t first, std::uint32_t count) const;

  private:
    void upload(const void* vertices, std::size_t vertex_bytes, const std::vector<std::uint32_t>& indices);

    GlVertexArray array_;
    GlBuffer vertices_;
    GlBuffer indices_;
};

}  // namespace batten::render
