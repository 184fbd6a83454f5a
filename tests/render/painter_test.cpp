#include <glad/gl.h>

#include "render/gl_painter.h"
#include "tests/render/painted.h"

namespace batten::test {
namespace {

using namespace render;

constexpr Color red = rgb(0xFF0000);
constexpr Color green = rgb(0x00FF00);
constexpr Color blue = rgb(0x0000FF);

class Painter : public Painted {};

Marker disc(Pixel center, float radius_px, Color fill) {
    return {center, MarkerShape::disc, radius_px, fill, {}, 0.0F, 0.0F};
}

Fill rectangle(float left, float top, float right, float bottom, Color color) {
    return {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}, color};
}

TEST_F(Painter, empty_list_only_clears) {
    const OffscreenTarget target({40, 30});
    painter().paint({}, target.viewport(), {10, 20, 30, 255}, 1.0F);
    for (const Color& pixel : target.read().pixels) ASSERT_EQ(pixel, (Color{10, 20, 30, 255}));
}

TEST_F(Painter, paints_only_its_viewport_counted_from_the_upper_left) {
    const OffscreenTarget target({100, 80});
    painter().paint({}, target.viewport(), blue, 1.0F);
    const Viewport part{{10, 5}, {40, 30}, {100, 80}};
    painter().paint({{rectangle(-500, -500, 500, 10, white), line({{20, -50}, {20, 200}}, 4, red)}}, part, black, 1.0F);
    const Image image = target.read();
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool is_inside = x >= 10 && x < 50 && y >= 5 && y < 35;
            const bool is_line = x >= 28 && x < 32;
            const Color expected = !is_inside ? blue : is_line ? red : y < 15 ? white : black;
            ASSERT_EQ(image.at(x, y), expected) << x << ", " << y;
        }
    }
}

TEST_F(Painter, viewport_without_area_paints_nothing) {
    const OffscreenTarget target({20, 20});
    painter().paint({}, target.viewport(), blue, 1.0F);
    painter().paint({}, {{5, 5}, {0, 10}, {20, 20}}, red, 1.0F);
    for (const Color& pixel : target.read().pixels) ASSERT_EQ(pixel, blue);
}

TEST_F(Painter, later_commands_cover_earlier_ones) {
    const std::vector<DrawCommand> commands{rectangle(0, 0, 100, 100, red), line({{0, 50}, {100, 50}}, 20, green),
                                            disc({50, 50}, 15, blue), line({{50, 0}, {50, 100}}, 6, white),
                                            rectangle(0, 40, 20, 60, red)};
    const Image image = paint(commands, {100, 100});
    EXPECT_EQ(image.at(30, 20), red);
    EXPECT_EQ(image.at(30, 50), green);
    EXPECT_EQ(image.at(42, 50), blue);
    EXPECT_EQ(image.at(50, 50), white);
    EXPECT_EQ(image.at(10, 50), red);
}

TEST_F(Painter, colors_are_blended_as_they_are) {
    const Image image = paint({rectangle(0, 0, 50, 50, {200, 100, 40, 255}), rectangle(0, 0, 50, 50, {0, 200, 240, 51}),
                               line({{0, 25}, {50, 25}}, 4, {100, 0, 40, 128})},
                              {50, 50});
    const auto near = [](Color actual, double r, double g, double b) {
        EXPECT_NEAR(actual.red, r, 1.0);
        EXPECT_NEAR(actual.green, g, 1.0);
        EXPECT_NEAR(actual.blue, b, 1.0);
        EXPECT_EQ(actual.alpha, 255);
    };
    near(image.at(10, 10), 160.0, 120.0, 80.0);
    near(image.at(25, 25), 160.0 + (100.0 - 160.0) * 128 / 255, 120.0 - 120.0 * 128 / 255, 80.0 - 40.0 * 128 / 255);
}

TEST_F(Painter, scale_enlarges_everything) {
    const Image image = paint({line({{10, 30}, {90, 30}}, 3), disc({50, 30}, 10, white)}, {200, 120}, 2.0F);
    EXPECT_NEAR(image.red_of_column(40), 6.0, 0.05);
    EXPECT_NEAR(image.red_of_column(100), 40.0, 1.0);
    EXPECT_EQ(image.at(100, 60), white);
    EXPECT_EQ(image.at(100, 20), black);
}

TEST_F(Painter, does_not_depend_on_the_state_it_finds) {
    const std::vector<DrawCommand> commands{rectangle(0, 0, 60, 60, red), disc({100, 60}, 20, green),
                                            line({{10, 10}, {150, 20}, {20, 30}}, 8, {255, 255, 255, 128})};
    const Image expected = paint(commands);
    for (const GLenum state : std::initializer_list<GLenum>{GL_CULL_FACE, GL_STENCIL_TEST, GL_DEPTH_TEST,
                                                            GL_FRAMEBUFFER_SRGB, GL_PRIMITIVE_RESTART}) {
        glEnable(state);
    }
    glFrontFace(GL_CW);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_NEVER);
    glDepthRange(1.0, 0.0);
    glClearDepth(0.0);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
    glScissor(0, 0, 1, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const Image actual = paint(commands);
    glFrontFace(GL_CCW);
    EXPECT_TRUE(actual.pixels == expected.pixels);
}

TEST_F(Painter, leaves_the_state_of_a_new_context) {
    paint({line({{10, 10}, {150, 20}, {20, 30}}, 8, {255, 255, 255, 128}), disc({50, 50}, 4, red)});
    for (const GLenum state :
         std::initializer_list<GLenum>{GL_SCISSOR_TEST, GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE}) {
        EXPECT_EQ(glIsEnabled(state), GL_FALSE);
    }
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING}) {
        GLint value = -1;
        glGetIntegerv(name, &value);
        EXPECT_EQ(value, 0);
    }
    GLboolean mask[4] = {};
    glGetBooleanv(GL_COLOR_WRITEMASK, mask);
    for (const GLboolean channel : mask) EXPECT_EQ(channel, GL_TRUE);
}

TEST_F(Painter, can_be_moved) {
    auto first = GlPainter::make();
    ASSERT_TRUE(first) << first.error();
    GlPainter moved = std::move(*first);
    const OffscreenTarget target({20, 20});
    moved.paint({{disc({10, 10}, 5, red)}}, target.viewport(), black, 1.0F);
    EXPECT_EQ(target.read().at(10, 10), red);
}

TEST_F(Painter, names_pending_errors) {
    glEnable(GL_RGBA);
    EXPECT_EQ(pending_gl_error(), "GL_INVALID_ENUM");
    EXPECT_EQ(pending_gl_error(), "");
}

// Red and green above, blue and half of white below.
std::shared_ptr<const render::Image> four_pixels() {
    return std::make_shared<const render::Image>(
        render::Image{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 128}});
}

TEST_F(Painter, images_are_stretched_to_their_corners) {
    const Image image = paint({ImageQuad{four_pixels(), {20, 10}, {60, 10}, {20, 50}}}, {100, 80});
    // Far from where colors run into each other.
    EXPECT_EQ(image.at(23, 13), red);
    EXPECT_EQ(image.at(57, 13), green);
    EXPECT_EQ(image.at(23, 47), blue);
    EXPECT_EQ(image.at(57, 47), (Color{128, 128, 128, 255}));
    EXPECT_EQ(image.at(18, 13), black);
    EXPECT_EQ(image.at(62, 47), black);
    EXPECT_EQ(image.at(40, 8), black);
    EXPECT_EQ(image.at(40, 52), black);
}

TEST_F(Painter, images_are_turned_and_dimmed) {
    // A quarter turn: what was above is to the left.
    const Image image = paint({ImageQuad{four_pixels(), {20, 50}, {20, 10}, {60, 50}, 0.5}}, {100, 80});
    EXPECT_EQ(image.at(23, 47), (Color{128, 0, 0, 255}));
    EXPECT_EQ(image.at(23, 13), (Color{0, 128, 0, 255}));
    EXPECT_EQ(image.at(57, 47), (Color{0, 0, 128, 255}));
}

TEST_F(Painter, images_far_larger_than_the_picture_stay_in_place) {
    // The middle of the image, where its four pixels meet, is at (50, 40).
    const Image image =
        paint({ImageQuad{four_pixels(), {50 - 1e9, 40 - 1e9}, {50 + 1e9, 40 - 1e9}, {50 - 1e9, 40 + 1e9}}}, {100, 80});
    const Color middle = image.at(50, 40);
    EXPECT_NEAR(middle.red, 96, 4);  // a quarter each of red and of half of white
    EXPECT_EQ(image.at(2, 2), middle);
    const Image none = paint({ImageQuad{four_pixels(), {10, 10}, {10, 10}, {10, 50}}}, {100, 80});
    for (const Color& pixel : none.pixels) ASSERT_EQ(pixel, black);
}

TEST_F(Painter, images_stay_under_what_comes_later) {
    const auto shared = four_pixels();
    const Image image = paint({ImageQuad{shared, {0, 0}, {50, 0}, {0, 50}}, rectangle(10, 10, 20, 20, white),
                               ImageQuad{shared, {50, 0}, {100, 0}, {50, 50}}},
                              {100, 80});
    EXPECT_EQ(image.at(15, 15), white);
    EXPECT_EQ(image.at(3, 3), red);
    EXPECT_EQ(image.at(53, 3), red);
}

}  // namespace
}  // namespace batten::test
