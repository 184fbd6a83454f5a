/// Paints draw lists with OpenGL 3.3.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "render/draw_list.h"

namespace batten::render {

/// The part of the window that a picture fills, in framebuffer pixels from the upper left corner.
struct Viewport {
    glm::ivec2 origin_px{};
    glm::ivec2 size_px{};
    glm::ivec2 framebuffer_px{};  ///< size of the whole framebuffer
};

/// Holds shaders and buffers; needs the OpenGL context that was current when it was made, also to be destroyed.
/// Labels are left to the interface, which owns the fonts.
class GlPainter {
  public:
    /// Compiles the shaders. The error is one sentence with the driver's message.
    [[nodiscard]] static tl::expected<GlPainter, std::string> make();

    GlPainter(GlPainter&&) noexcept;
    GlPainter& operator=(GlPainter&&) noexcept;
    ~GlPainter();

    /// Fills the viewport with `background` and paints `list` over it. `scale` is framebuffer pixels per pixel of the
    /// list. Sets all OpenGL state that it needs, and afterward puts back what a new context has. The framebuffer
    /// should have a depth buffer of 24 bits: it keeps translucent lines from darkening where they turn sharply or
    /// cross themselves; only then is it cleared. Cost: one upload for each kind of command, one draw call for each run
    /// of commands of one kind, and two for each such translucent line.
    void paint(const DrawList& list, const Viewport& viewport, Color background, float scale);

    /// The two halves of paint(): upload() makes the triangles of `list` and hands them to OpenGL, draw() paints what
    /// was uploaded last, into a viewport of the same size.
    void upload(const DrawList& list, const Viewport& viewport, float scale);
    void draw(const Viewport& viewport, Color background);

    /// The vertices that were uploaded last.
    std::size_t vertex_count() const;

  private:
    struct Resources;
    explicit GlPainter(std::unique_ptr<Resources> resources);

    std::unique_ptr<Resources> resources_;
};

/// Loads the OpenGL functions through `load` (as given by the windowing library), once for the current context. The
/// error is one sentence: what version was found and that 3.3 is needed.
using GlFunctionLoader = void (*(*)(const char*))();
[[nodiscard]] tl::expected<void, std::string> load_gl(GlFunctionLoader load);

/// What pending_gl_error tells where the driver gave up the context; nothing that was made on it is left.
inline constexpr const char* context_lost_error = "GL_CONTEXT_LOST";

/// The first pending OpenGL error by its name, or an empty string.
std::string pending_gl_error();

}  // namespace batten::render
