#include <fmt/core.h>
#include <glad/gl.h>

#include "render/gl_painter.h"

namespace batten::render {

tl::expected<void, std::string> load_gl(GlFunctionLoader load) {
    const int version = gladLoadGL(load);
    if (version >= GLAD_MAKE_VERSION(3, 3)) return {};
    if (version == 0) return tl::unexpected(std::string("No OpenGL was found here; version 3.3 is needed."));
    return tl::unexpected(fmt::format("OpenGL {}.{} was found here; version 3.3 is needed.",
                                      GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)));
}

std::string pending_gl_error() {
    constexpr GLenum context_lost = 0x0507;  // of the extension KHR_robustness
    switch (const GLenum error = glGetError()) {
        case GL_NO_ERROR:
            return {};
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        case context_lost:
            return context_lost_error;
        default:
            return fmt::format("OpenGL error {}", error);
    }
}

}  // namespace batten::render
