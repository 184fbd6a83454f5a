#include "app/platform/picture_viewport.h"

#include <gtest/gtest.h>

#include "render/camera.h"

namespace batten::platform {

namespace {

constexpr ui::Rectangle canvas{{52.0, 34.0}, {1048.0, 566.0}};
constexpr ui::Rectangle plot{{52.0, 600.0}, {1048.0, 260.0}};
constexpr glm::ivec2 window{1440, 900};

// What is painted for the world point under the pointer must lie under the pointer, in framebuffer pixels.
void expect_painted_under_the_pointer(glm::ivec2 framebuffer, double density) {
    const render::Camera camera{{3.0, -2.0}, 77.0, canvas.size_px};
    const glm::dvec2 pointer{700.0, 300.0};
    const glm::dvec2 world = render::world_from_screen(camera, pointer - canvas.origin_px);
    const render::Viewport viewport = picture_viewport(canvas, window, framebuffer);
    const glm::dvec2 painted = glm::dvec2(viewport.origin_px) +
                               render::screen_from_world(camera, world) * framebuffer_density(window, framebuffer);
    EXPECT_NEAR(painted.x, pointer.x * density, 0.5 + 1e-9);
    EXPECT_NEAR(painted.y, pointer.y * density, 0.5 + 1e-9);
}

TEST(Pitfalls, p15_points_are_painted_under_the_pointer_where_the_framebuffer_is_denser_than_the_window) {
    expect_painted_under_the_pointer({1440, 900}, 1.0);
    expect_painted_under_the_pointer({2160, 1350}, 1.5);
    expect_painted_under_the_pointer({2880, 1800}, 2.0);
}

TEST(PictureViewport, covers_the_framebuffer_pixels_of_its_place) {
    const render::Viewport viewport = picture_viewport(canvas, window, {2880, 1800});
    EXPECT_EQ(viewport.origin_px, glm::ivec2(104, 68));
    EXPECT_EQ(viewport.size_px, glm::ivec2(2096, 1132));
    EXPECT_EQ(viewport.framebuffer_px, glm::ivec2(2880, 1800));
}

TEST(PictureViewport, neighbors_meet_at_fractional_densities) {
    const glm::ivec2 framebuffer{1801, 1126};
    const render::Viewport above = picture_viewport(canvas, window, framebuffer);
    const render::Viewport below = picture_viewport(plot, window, framebuffer);
    EXPECT_EQ(above.origin_px.y + above.size_px.y, below.origin_px.y);
}

TEST(PictureViewport, of_a_minimized_window_is_harmless) {
    EXPECT_EQ(framebuffer_density({0, 0}, {0, 0}), 1.0);
}

}  // namespace

}  // namespace batten::platform
