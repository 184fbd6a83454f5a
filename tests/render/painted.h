/// What the tests of the painter share: one context for all, and pictures of white on black.
#pragma once

#include <gtest/gtest.h>

#include "tests/render/offscreen.h"

namespace batten::test {

inline constexpr render::Color white = render::rgb(0xFFFFFF);
inline constexpr render::Color black = render::rgb(0x000000);

/// Paints in a context that all tests share and checks that none leaves an OpenGL error.
class Painted : public testing::Test {
  protected:
    void TearDown() override { EXPECT_EQ(render::pending_gl_error(), ""); }

    static render::GlPainter& painter();

    /// The picture of the commands on black.
    static Image paint(const std::vector<render::DrawCommand>& commands, glm::ivec2 size_px = {200, 120},
                       float scale = 1.0F);
};

/// A solid line.
render::Polyline line(std::vector<render::Pixel> points, float width_px, render::Color color = white);

}  // namespace batten::test
