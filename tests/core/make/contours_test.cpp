#include "core/make/contours.h"

#include <gtest/gtest.h>

#include "tests/core/painted_image.h"

namespace batten::core {
namespace {

TEST(Contours, one_dark_pixel_has_one_outline) {
    GrayImage image{3, 3, std::vector<std::uint8_t>(9, 255)};
    image.values[3 * 1 + 1] = 0;  // the middle
    const auto found = contours(image, 127.5);
    ASSERT_EQ(found.size(), 1U);
    // Half way to the four neighbors: a square on its corner, counterclockwise.
    ASSERT_EQ(found[0].size(), 4U);
    EXPECT_NEAR(area_of(found[0]), 0.5, 1e-12);
    for (const Point p : found[0]) EXPECT_NEAR(distance(p, {1.5, 1.5}), 0.5, 1e-12);
}

TEST(Contours, y_runs_upward) {
    GrayImage image{2, 3, std::vector<std::uint8_t>(6, 255)};
    image.values[0] = 0;  // upper left
    const auto found = contours(image, 127.5);
    ASSERT_EQ(found.size(), 1U);
    for (const Point p : found[0]) EXPECT_NEAR(distance(p, {0.5, 2.5}), 0.5, 1e-12);
}

TEST(Contours, shades_between_pixels_are_linear) {
    // The edge x = 4.25: a quarter of the fifth column is dark.
    const GrayImage image = painted(8, 6, {{{0, 0}, {4.25, 0}, {4.25, 6}, {0, 6}}});
    const auto found = contours(image, 127.5);
    ASSERT_EQ(found.size(), 1U);
    double most = 0.0;
    for (const Point p : found[0])
        if (p.y > 1.0 && p.y < 5.0) most = std::max(most, p.x);
    // The threshold lies between column 4 (0) and column 5 (191): at 3.5 + 127.5 / 191.
    EXPECT_NEAR(most, 3.5 + 127.5 / 191.0, 1e-12);
}

TEST(Contours, a_dark_image_is_outlined_along_its_edge) {
    const GrayImage image{5, 4, std::vector<std::uint8_t>(20, 0)};
    const auto found = contours(image, 127.5);
    ASSERT_EQ(found.size(), 1U);
    // But for its corners, which are cut by half a pixel.
    EXPECT_NEAR(area_of(found[0]), 20.0 - 4 * 0.125, 1e-12);
}

TEST(Contours, holes_run_the_other_way) {
    const GrayImage image = painted(40, 40, {circle_outline({20, 20}, 15), reversed(circle_outline({20, 20}, 7))});
    auto found = contours(image, 127.5);
    ASSERT_EQ(found.size(), 2U);
    if (area_of(found[0]) < 0.0) std::swap(found[0], found[1]);
    EXPECT_NEAR(area_of(found[0]), 225 * std::numbers::pi, 2.0);
    EXPECT_NEAR(area_of(found[1]), -49 * std::numbers::pi, 1.0);
    for (const Contour& contour : found)
        for (const Point p : contour) EXPECT_NEAR(distance(p, {20, 20}), area_of(contour) > 0.0 ? 15.0 : 7.0, 0.12);
}

TEST(Contours, crosswise_cells_are_decided_by_their_mean) {
    // Two dark pixels that touch at a corner: apart where the other two are white, joined where they are gray.
    const auto count_with = [](std::uint8_t other) {
        GrayImage image{4, 4, std::vector<std::uint8_t>(16, 255)};
        image.values[4 * 1 + 1] = image.values[4 * 2 + 2] = 0;
        image.values[4 * 1 + 2] = image.values[4 * 2 + 1] = other;
        return contours(image, 127.5).size();
    };
    EXPECT_EQ(count_with(255), 2U);  // a mean of 127.5 is not dark
    EXPECT_EQ(count_with(253), 1U);
    EXPECT_EQ(count_with(129), 1U);
    GrayImage image{4, 4, std::vector<std::uint8_t>(16, 255)};
    image.values[4 * 1 + 1] = image.values[4 * 2 + 2] = 60;
    EXPECT_EQ(contours(image, 127.5).size(), 2U);
    image.values[4 * 1 + 1] = image.values[4 * 2 + 2] = 255;
    image.values[4 * 1 + 2] = image.values[4 * 2 + 1] = 60;
    EXPECT_EQ(contours(image, 127.5).size(), 2U);
    image.values[4 * 1 + 1] = image.values[4 * 2 + 2] = 140;
    EXPECT_EQ(contours(image, 127.5).size(), 1U);
}

TEST(Contours, all_outlines_are_closed_in_noise) {
    GrayImage image{97, 61, {}};
    unsigned seed = 12345;
    for (int k = 0; k < 97 * 61; ++k)
        image.values.push_back(static_cast<std::uint8_t>((seed = seed * 1664525 + 1013904223) >> 24));
    double sum = 0.0;
    for (const Contour& contour : contours(image, 127.5)) {
        sum += area_of(contour);
        ASSERT_GE(contour.size(), 3U);
        for (std::size_t k = 0; k < contour.size(); ++k)
            ASSERT_LT(distance(contour[k], contour[(k + 1) % contour.size()]), 1.5);
    }
    // About half of it is dark.
    EXPECT_NEAR(sum, 97 * 61 / 2.0, 97 * 61 * 0.05);
}

TEST(Contours, the_middle_shade_is_between_paper_and_ink) {
    EXPECT_NEAR(middle_shade(painted(60, 60, {circle_outline({30, 30}, 12)}, 40, 220)), 130.0, 0.5);
    EXPECT_NEAR(middle_shade(painted(60, 60, {circle_outline({30, 30}, 3)}, 0, 255)), 127.5, 0.5);
    EXPECT_EQ(middle_shade(GrayImage{2, 2, {7, 7, 7, 7}}), 127.5);
}

}  // namespace
}  // namespace batten::core
