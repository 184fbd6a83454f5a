/// An OpenGL context without a visible window, a framebuffer to paint into, and its pixels to read back.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "render/color.h"
#include "render/gl_painter.h"

namespace batten::test {

/// Pixels from the upper left corner.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<render::Color> pixels;

    [[nodiscard]] render::Color at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    /// The red component in 0..1: the coverage of white on black.
    [[nodiscard]] double red(int x, int y) const { return at(x, y).red / 255.0; }
    [[nodiscard]] double red_of_column(int x) const;
    [[nodiscard]] double red_of_all() const;
};

/// Writes the image as a portable pixmap.
void write_ppm(const Image& image, const std::string& path);

/// Makes a context of OpenGL 3.3 current as long as it lives; throws std::runtime_error with a sentence where there is
/// none.
class OffscreenContext {
  public:
    OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;
    ~OffscreenContext();

  private:
    void* window_ = nullptr;
};

/// A framebuffer of 8-bit colors and 24-bit depth, bound as long as it lives.
class OffscreenTarget {
  public:
    explicit OffscreenTarget(glm::ivec2 size_px);
    OffscreenTarget(const OffscreenTarget&) = delete;
    OffscreenTarget& operator=(const OffscreenTarget&) = delete;
    ~OffscreenTarget();

    /// A viewport that fills the framebuffer.
    [[nodiscard]] render::Viewport viewport() const { return {{0, 0}, size_px_, size_px_}; }
    [[nodiscard]] Image read() const;

  private:
    glm::ivec2 size_px_;
    unsigned framebuffer_ = 0;
    unsigned color_ = 0;
    unsigned depth_ = 0;
};

}  // namespace batten::test
