/// Move-only owners of OpenGL objects.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace batten::render {

/// Owns the object named `id` and deletes it with `destroy`, while its context is still current. Zero owns nothing.
template <void (*destroy)(GLuint)>
class GlObject {
  public:
    GlObject() = default;
    explicit GlObject(GLuint id) : id_(id) {}
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    ~GlObject() {
        if (id_ != 0) destroy(id_);
    }

    [[nodiscard]] GLuint id() const { return id_; }

  private:
    GLuint id_ = 0;
};

inline void delete_gl_buffer(GLuint id) {
    glDeleteBuffers(1, &id);
}
inline void delete_gl_vertex_array(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
inline void delete_gl_texture(GLuint id) {
    glDeleteTextures(1, &id);
}
inline void delete_gl_shader(GLuint id) {
    glDeleteShader(id);
}
inline void delete_gl_program(GLuint id) {
    glDeleteProgram(id);
}

using GlBuffer = GlObject<delete_gl_buffer>;
using GlVertexArray = GlObject<delete_gl_vertex_array>;
using GlTexture = GlObject<delete_gl_texture>;
using GlShader = GlObject<delete_gl_shader>;
using GlProgram = GlObject<delete_gl_program>;

/// New, empty objects.
inline GlBuffer make_gl_buffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return GlBuffer(id);
}
inline GlVertexArray make_gl_vertex_array() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return GlVertexArray(id);
}
inline GlTexture make_gl_texture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return GlTexture(id);
}

}  // namespace batten::render
