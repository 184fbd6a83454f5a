#include "render/image.h"

#include <gtest/gtest.h>

namespace batten::render {
namespace {

TEST(Image, halving_takes_means) {
    const Image image{3, 2, {0,   0, 0, 255, 100, 20, 0, 255, 7, 7, 7, 255,  // an edge pixel counts twice
                             200, 0, 0, 255, 100, 20, 0, 255, 9, 9, 9, 255}};
    const Image half = halved(image, 1);
    EXPECT_EQ(half.width, 2);
    EXPECT_EQ(half.height, 1);
    EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{100, 10, 0, 255, 8, 8, 8, 255}));
    EXPECT_EQ(halved(image, 2).width, 1);
    EXPECT_EQ(halved(image, 0).rgba, image.rgba);
}

TEST(Image, what_is_transparent_gives_no_color) {
    const Image image{2, 1, {250, 10, 0, 255, 0, 0, 0, 0}};
    EXPECT_EQ(halved(image, 1).rgba, (std::vector<std::uint8_t>{250, 10, 0, 128}));
}

}  // namespace
}  // namespace batten::render
