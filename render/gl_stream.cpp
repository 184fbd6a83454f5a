#include "render/gl_stream.h"

namespace batten::render {
namespace {

/// OpenGL takes offsets into buffers as pointers.
const void* buffer_offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

GlStream::GlStream(std::size_t vertex_size, std::initializer_list<GlInput> inputs)
    : array_(make_gl_vertex_array()), vertices_(make_gl_buffer()), indices_(make_gl_buffer()) {
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    GLuint location = 0;
    for (const GlInput& input : inputs) {
        const bool is_color = input.type == GlInput::Type::color;
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, input.components, is_color ? GL_UNSIGNED_BYTE : GL_FLOAT,
                              is_color ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(vertex_size),
                              buffer_offset(input.offset));
        ++location;
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void GlStream::upload(const void* vertices, std::size_t vertex_bytes, const std::vector<std::uint32_t>& indices) {
    if (indices.empty()) return;
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertex_bytes), vertices, GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                 indices.data(), GL_STREAM_DRAW);
}

void GlStream::draw(std::uint32_t first, std::uint32_t count) const {
    glBindVertexArray(array_.id());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   buffer_offset(first * sizeof(std::uint32_t)));
}

}  // namespace batten::render
