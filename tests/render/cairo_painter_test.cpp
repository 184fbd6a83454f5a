#include "render/cairo_painter.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <array>

#include "render/figure_file.h"
#include "tests/render/plain_colors.h"

namespace batten::render {
namespace {

/// A PNG that is read back: red, green, blue and alpha of its pixels, not premultiplied where they are opaque.
class ReadBack {
  public:
    explicit ReadBack(const std::string& png) : rest_(png) {
        surface_ = cairo_image_surface_create_from_png_stream(read, &rest_);
        EXPECT_EQ(cairo_surface_status(surface_), CAIRO_STATUS_SUCCESS);
    }
    ~ReadBack() { cairo_surface_destroy(surface_); }
    ReadBack(const ReadBack&) = delete;
    ReadBack& operator=(const ReadBack&) = delete;

    glm::ivec2 size() const {
        return {cairo_image_surface_get_width(surface_), cairo_image_surface_get_height(surface_)};
    }

    std::array<int, 4> at(int x, int y) const {
        const unsigned char* pixel =
            cairo_image_surface_get_data(surface_) + y * cairo_image_surface_get_stride(surface_) + 4 * x;
        return {pixel[2], pixel[1], pixel[0], pixel[3]};
    }

  private:
    static cairo_status_t read(void* rest, unsigned char* data, unsigned int length) {
        auto& text = *static_cast<std::string_view*>(rest);
        if (text.size() < length) return CAIRO_STATUS_READ_ERROR;
        std::copy_n(text.begin(), length, data);
        text.remove_prefix(length);
        return CAIRO_STATUS_SUCCESS;
    }

    std::string_view rest_;
    cairo_surface_t* surface_ = nullptr;
};

Figure square(std::optional<Color> ground) {
    DrawList list;
    list.add(Fill{{{10, 20}, {40, 20}, {40, 50}, {10, 50}}, red});
    return page_of(std::move(list), {100.0, 80.0}, ground);
}

TEST(CairoPainter, paints_pixels_where_they_belong) {
    const auto png = png_bytes(square(Color{1, 2, 3, 255}));
    ASSERT_TRUE(png);
    const ReadBack image(*png);
    EXPECT_EQ(image.size(), glm::ivec2(100, 80));
    EXPECT_EQ(image.at(0, 0), (std::array{1, 2, 3, 255}));
    EXPECT_EQ(image.at(10, 20), (std::array{255, 0, 0, 255}));
    EXPECT_EQ(image.at(39, 49), (std::array{255, 0, 0, 255}));
    EXPECT_EQ(image.at(40, 50), (std::array{1, 2, 3, 255}));
}

TEST(CairoPainter, leaves_clear_what_has_no_ground) {
    const auto png = png_bytes(square(std::nullopt));
    ASSERT_TRUE(png);
    const ReadBack image(*png);
    EXPECT_EQ(image.at(0, 0)[3], 0);
    EXPECT_EQ(image.at(20, 30), (std::array{255, 0, 0, 255}));
}

TEST(CairoPainter, cuts_parts_to_their_boxes) {
    Figure figure = square(std::nullopt);
    figure.parts.front().box = {{5, 30}, {30, 60}};  // 25 x 30: the square from (15, 50) on is cut at x = 30, y = 60
    const auto png = png_bytes(figure);
    ASSERT_TRUE(png);
    const ReadBack image(*png);
    EXPECT_EQ(image.at(15, 50)[3], 255);
    EXPECT_EQ(image.at(29, 59)[3], 255);
    EXPECT_EQ(image.at(30, 55)[3], 0);
    EXPECT_EQ(image.at(20, 60)[3], 0);
    EXPECT_EQ(image.at(14, 50)[3], 0);
}

TEST(CairoPainter, paints_ink_at_its_place) {
    auto map = std::make_shared<CoverageMap>(glm::ivec2(100, 80));
    map->stroke({50.0, 10.0}, {50.0, 70.0}, {.width_px = 10.0});
    DrawList list;
    list.add(Ink{map, red});
    const auto png = png_bytes(page_of(list, {100.0, 80.0}, std::nullopt));
    ASSERT_TRUE(png);
    const ReadBack image(*png);
    EXPECT_EQ(image.at(50, 40), (std::array{255, 0, 0, 255}));
    EXPECT_EQ(image.at(60, 40)[3], 0);
    const auto part = png_bytes(Ink{map, red});
    ASSERT_TRUE(part);
    EXPECT_LE(ReadBack(*part).size().x, 12) << "what is touched alone";
}

TEST(CairoPainter, writes_pages_in_points_with_a_title) {
    Figure figure = square(std::nullopt);
    figure.title = "a wave";
    const auto pdf = pdf_bytes(figure);
    ASSERT_TRUE(pdf);
    EXPECT_TRUE(pdf->starts_with("%PDF-"));
    EXPECT_NE(pdf->find("/MediaBox [ 0 0 75 60 ]"), std::string::npos) << "96 pixels are 72 points";
}

TEST(CairoPainter, measures_text) {
    const double width = text_width("nn", 20.0, LabelFont::text);
    EXPECT_NEAR(text_width("nnnn", 20.0, LabelFont::text), 2.0 * width, 0.1);
    EXPECT_NEAR(text_width("nn", 40.0, LabelFont::text), 2.0 * width, 0.1);
    EXPECT_EQ(text_width("", 20.0, LabelFont::text), 0.0);
}

TEST(CairoPainter, has_signs_that_the_font_of_the_interface_lacks) {
    const auto png_of = [](const char* text) {
        DrawList list;
        list.add(Label{.position = {20, 40}, .text = text, .color = red, .size_px = 30.0F, .font = LabelFont::bold});
        return png_bytes(page_of(list, {100.0, 80.0}, std::nullopt)).value();
    };
    // Signs without a glyph are the same box.
    EXPECT_NE(png_of("ℝ"), png_of("ℂ"));
    EXPECT_NE(png_of("∈"), png_of("∇"));
    EXPECT_NEAR(text_width("aℝ", 20.0, LabelFont::bold),
                text_width("a", 20.0, LabelFont::bold) + text_width("ℝ", 20.0, LabelFont::bold), 0.01);
}

TEST(FigureFile, is_known_by_its_ending) {
    EXPECT_EQ(figure_format("a.b/wave.SVG"), FigureFormat::svg);
    EXPECT_EQ(figure_format("wave.pdf"), FigureFormat::pdf);
    EXPECT_EQ(figure_format("wave.Png"), FigureFormat::png);
    EXPECT_EQ(figure_format("wave.tex"), FigureFormat::tikz);
    EXPECT_EQ(figure_format("wave.tikz"), FigureFormat::tikz);
    for (const char* other : {"wave", "wave.json", ".svg", "svg", "wave.svgz", ""})
        EXPECT_EQ(figure_format(other), std::nullopt) << other;
}

TEST(CairoPainter, stretches_an_image_to_its_corners) {
    // Red and green above, blue and clear below.
    auto image =
        std::make_shared<Image>(Image{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0}});
    DrawList list;
    // Turned by a quarter: its upper left corner is below on the left.
    list.add(ImageQuad{image, {20, 100}, {20, 20}, {100, 100}, 1.0});
    const ReadBack picture(*png_bytes(page_of(list, {120.0, 120.0}, Color{255, 255, 255, 255})));
    EXPECT_EQ(picture.at(30, 90), (std::array{255, 0, 0, 255}));
    EXPECT_EQ(picture.at(30, 30), (std::array{0, 255, 0, 255}));
    EXPECT_EQ(picture.at(90, 90), (std::array{0, 0, 255, 255}));
    EXPECT_EQ(picture.at(90, 30), (std::array{255, 255, 255, 255})) << "clear";
    EXPECT_EQ(picture.at(10, 60), (std::array{255, 255, 255, 255})) << "beside it";
}

}  // namespace
}  // namespace batten::render
