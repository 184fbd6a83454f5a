#include "app/picture/image_file.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/editor/sample_editor.h"

namespace batten::picture {
namespace {

const std::filesystem::path pictures = std::filesystem::path(BATTEN_TEST_DATA) / "pictures";

using Rgba = std::array<int, 4>;

Rgba pixel(const render::Image& image, int x, int y) {
    const std::uint8_t* at = image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
    return {at[0], at[1], at[2], at[3]};
}

render::Image image_of(const char* name) {
    auto image = read_image(pictures / name);
    EXPECT_TRUE(image) << (image ? "" : image.error());
    return image ? *std::move(image) : render::Image{};
}

std::string refusal_of(const std::filesystem::path& path) {
    const auto image = read_image(path);
    return image ? "" : image.error();
}

TEST(ImageFile, gray_becomes_three_colors_alike) {
    const render::Image image = image_of("ring_gray.png");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 64);
    ASSERT_EQ(image.rgba.size(), 4U * 64 * 64);
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(pixel(image, 32, 13), (Rgba{0, 0, 0, 255}));  // in the ring
    EXPECT_EQ(pixel(image, 32, 31), (Rgba{255, 255, 255, 255}));
}

TEST(ImageFile, sixteen_bits_are_rounded_to_eight) {
    const render::Image image = image_of("shades_16bit.png");
    ASSERT_EQ(image.width, 4);
    for (int x = 0; x < 4; ++x) {
        EXPECT_EQ(pixel(image, x, 0), (Rgba{85 * x, 85 * x, 85 * x, 255}));
        EXPECT_EQ(pixel(image, 3 - x, 1), (Rgba{85 * x, 85 * x, 85 * x, 255}));
    }
}

TEST(ImageFile, transparency_is_kept) {
    const render::Image image = image_of("gray_alpha.png");
    EXPECT_EQ(pixel(image, 0, 0), (Rgba{100, 100, 100, 255}));
    EXPECT_EQ(pixel(image, 1, 0)[3], 0);
    EXPECT_EQ(pixel(image_of("ring_alpha.png"), 0, 0)[3], 0);
}

TEST(ImageFile, jpeg_in_light_and_in_inks) {
    for (const char* name : {"red.jpg", "red_cmyk.jpg"}) {
        const Rgba red = pixel(image_of(name), 4, 4);
        EXPECT_GE(red[0], 240) << name;
        EXPECT_LE(red[1], 15) << name;
        EXPECT_LE(red[2], 15) << name;
        EXPECT_EQ(red[3], 255) << name;
    }
}

TEST(ImageFile, refusals_say_what_is_wrong) {
    EXPECT_EQ(refusal_of(pictures / "none.png"), "none.png: there is no such file");
    EXPECT_EQ(refusal_of(pictures), "pictures: this is not an ordinary file");
    EXPECT_EQ(refusal_of(pictures / "cut_off.png"),
              "cut_off.png: the picture is damaged or cut off and cannot be read");
    EXPECT_EQ(refusal_of(pictures / "too_large.png"),
              "too_large.png: the picture has 20000 × 20000 pixels; at most 100000000 pixels are allowed");
    EXPECT_NE(refusal_of(pictures / "no_pixels.png"), "");
    const editor::TemporaryFolder folder;
    const char* wrong_kind = ": this is not a picture that can be read; PNG and JPEG are";
    EXPECT_EQ(refusal_of(folder.write("a.png", "GIF89a")), std::string("a.png") + wrong_kind);
    EXPECT_EQ(refusal_of(folder.write("b.jpg", "")), std::string("b.jpg") + wrong_kind);
    EXPECT_NE(refusal_of(folder.write("c.png", "\x89PNG\r\n")), "");
    EXPECT_NE(refusal_of(folder.write("d.jpg", "\xFF\xD8\xFF\xE0 nothing")), "");
}

TEST(ImageFile, names_of_images) {
    for (const char* name : {"a.png", "b.JPG", "c.Jpeg", "/x/y.PNG"}) EXPECT_TRUE(is_named_as_image(name)) << name;
    for (const char* name : {"a.json", "png", "b.gif", ""}) EXPECT_FALSE(is_named_as_image(name)) << name;
}

}  // namespace
}  // namespace batten::picture
