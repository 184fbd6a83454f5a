#include <cmath>
#include <numbers>

#include "tests/render/painted.h"

namespace batten::test {
namespace {

using namespace render;
using std::numbers::pi;

constexpr Color none{0, 0, 0, 0};

class Markers : public Painted {};
class Fills : public Painted {};

TEST_F(Markers, disc_has_its_area) {
    for (const float radius : {6.5F, 20.0F}) {
        for (const float offset : {0.0F, 0.3F, 0.5F}) {
            const Image image =
                paint({Marker{{60.0F + offset, 50.0F - offset}, MarkerShape::disc, radius, white, none, 0.0F, 0.0F}});
            const double area = pi * radius * radius;
            EXPECT_NEAR(image.red_of_all(), area, 0.01 * area);
        }
    }
}

TEST_F(Markers, diamond_has_twice_its_radius_squared) {
    for (const float radius : {7.0F, 20.0F}) {
        const Image image = paint({Marker{{60, 50}, MarkerShape::diamond, radius, white, none, 0.0F, 0.0F}});
        EXPECT_NEAR(image.red_of_all(), 2.0 * radius * radius, 0.02 * radius * radius);
        const int reach = static_cast<int>(radius);
        EXPECT_GT(image.red(60, 50 - reach + 2), 0.9);
        EXPECT_GT(image.red(60 + reach - 3, 50), 0.9);
        EXPECT_EQ(image.at(60 + reach - 3, 50 - reach + 2), black);
    }
}

TEST_F(Markers, square_has_four_times_its_radius_squared) {
    const Image image = paint({Marker{{60.25F, 50.5F}, MarkerShape::square, 6.25F, white, none, 0.0F, 0.0F}});
    EXPECT_NEAR(image.red_of_all(), 4.0 * 6.25 * 6.25, 0.5);
}

TEST_F(Markers, outline_is_centered_on_the_edge) {
    const Image ring = paint({Marker{{60, 50}, MarkerShape::disc, 15.0F, none, white, 3.0F, 0.0F}});
    EXPECT_NEAR(ring.red_of_all(), 2.0 * pi * 15.0 * 3.0, 3.0);
    EXPECT_EQ(ring.at(60, 50), black);
    EXPECT_GT(ring.red(74, 50), 0.99);
    const Image frame = paint({Marker{{60, 50}, MarkerShape::square, 10.0F, none, white, 2.0F, 0.0F}});
    EXPECT_NEAR(frame.red_of_all(), 22.0 * 22.0 - 18.0 * 18.0, 0.1);
    const Image diamond = paint({Marker{{60.2F, 50.3F}, MarkerShape::diamond, 14.0F, none, white, 2.0F, 0.0F}});
    EXPECT_NEAR(diamond.red_of_all(), 4.0 * 14.0 * std::sqrt(2.0) * 2.0, 2.0);
}

TEST_F(Markers, outline_covers_the_fill) {
    const Image image = paint({Marker{{60, 50}, MarkerShape::square, 10.0F, rgb(0xFF0000), rgb(0x0000FF), 4.0F, 0.0F}});
    EXPECT_EQ(image.at(60, 50), rgb(0xFF0000));
    EXPECT_EQ(image.at(51, 50), rgb(0x0000FF));
    EXPECT_EQ(image.at(48, 50), rgb(0x0000FF));
    EXPECT_EQ(image.at(47, 50), black);
    EXPECT_EQ(image.at(52, 50), rgb(0xFF0000));
}

TEST_F(Markers, dashed_ring_is_half_a_ring_with_as_many_dashes_as_fit) {
    const Marker marker{{60, 50}, MarkerShape::disc, 20.0F, none, white, 2.0F, 5.0F};
    const Image image = paint({marker});
    EXPECT_NEAR(image.red_of_all(), 0.5 * 2.0 * pi * 20.0 * 2.0, 3.0);
    int changes = 0;
    bool was_on = false;
    for (int step = 0; step <= 720; ++step) {
        const double angle = step * pi / 360.0 + 0.01;
        const int x = static_cast<int>(std::floor(60.0 + 20.0 * std::cos(angle)));
        const int y = static_cast<int>(std::floor(50.0 + 20.0 * std::sin(angle)));
        const bool is_on = image.red(x, y) > 0.4;
        if (step > 0 && is_on != was_on) ++changes;
        was_on = is_on;
    }
    EXPECT_EQ(changes, 2 * 13);  // pi * 20 / 5 = 12.6
}

TEST_F(Fills, polygon_has_its_area_whichever_way_around) {
    const std::vector<Pixel> corners{{20.3F, 15.8F}, {150.2F, 30.1F}, {120.9F, 100.4F}, {40.0F, 90.0F}};
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Pixel a = corners[i];
        const Pixel b = corners[(i + 1) % corners.size()];
        area += 0.5 * (static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x);
    }
    EXPECT_NEAR(paint({Fill{corners, white}}).red_of_all(), area, 0.002 * area);
    const std::vector<Pixel> reversed(corners.rbegin(), corners.rend());
    EXPECT_NEAR(paint({Fill{reversed, white}}).red_of_all(), area, 0.002 * area);
}

TEST_F(Fills, rectangle_on_pixel_borders_is_crisp) {
    const Image image = paint({Fill{{{10, 10}, {20, 10}, {20, 15}, {10, 15}}, white}}, {40, 30});
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool is_inside = x >= 10 && x < 20 && y >= 10 && y < 15;
            ASSERT_EQ(image.at(x, y), is_inside ? white : black) << x << ", " << y;
        }
    }
}

TEST_F(Fills, translucent_polygon_has_no_seams) {
    const Image image = paint({Fill{{{10, 10}, {180, 20}, {190, 100}, {90, 115}, {5, 70}}, {255, 255, 255, 128}}});
    int inside = 0;
    for (const Color& pixel : image.pixels) {
        ASSERT_LE(pixel.red, 130);
        inside += pixel.red > 126 ? 1 : 0;
    }
    EXPECT_GT(inside, 12000);
    for (int x = 20; x < 170; ++x) ASSERT_NEAR(image.at(x, 60).red, 128, 2);
}

TEST_F(Fills, far_polygon_covers_its_part_of_the_screen) {
    const Image image = paint({Fill{{{50, -1e7F}, {1e7F, -1e7F}, {1e7F, 1e7F}, {50, 1e7F}}, white}});
    EXPECT_NEAR(image.red_of_all(), 150.0 * 120.0, 1.0);
    EXPECT_EQ(image.at(49, 60), black);
    EXPECT_EQ(image.at(50, 60), white);
}

TEST_F(Fills, sliver_is_faint_and_harmless) {
    const Image image = paint({Fill{{{10, 50}, {190, 50.4F}, {100, 50.3F}}, white}});
    for (const Color& pixel : image.pixels) ASSERT_LE(pixel.red, 200);
    EXPECT_LT(image.red_of_all(), 120.0);
}

}  // namespace
}  // namespace batten::test
