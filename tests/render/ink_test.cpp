#include <numbers>

#include "tests/render/painted.h"

namespace batten::test {
namespace {

using namespace render;

class Inks : public Painted {};

std::shared_ptr<const CoverageMap> blot() {
    auto map = std::make_shared<CoverageMap>(glm::ivec2(200, 120));
    map->stroke({80.3, 60.2}, {110.0, 50.0}, {.width_px = 71.0});
    map->stroke({5.0, 110.0}, {190.0, 8.0}, {.width_px = 3.0});
    return map;
}

TEST_F(Inks, paint_each_pixel_as_far_as_it_is_covered) {
    const auto map = blot();
    const Image image = paint({Ink{map, white}});
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 200; ++x) EXPECT_NEAR(255.0 * image.red(x, y), map->coverage({x, y}), 1.0) << x << " " << y;
}

TEST_F(Inks, grow_with_the_density_of_the_screen) {
    const auto map = blot();
    const Image once = paint({Ink{map, white}});
    const Image twice = paint({Ink{map, white}}, {400, 240}, 2.0F);
    EXPECT_NEAR(twice.red_of_all(), 4.0 * once.red_of_all(), 0.001 * twice.red_of_all());
}

TEST_F(Inks, keep_their_order_and_colors) {
    auto above = std::make_shared<CoverageMap>(glm::ivec2(200, 120));
    above->stroke({0.0, 60.0}, {200.0, 60.0}, {.width_px = 20.0});
    const Image image = paint({Ink{blot(), rgb(0xFF0000)}, Ink{above, rgb(0x00FF00)}});
    EXPECT_EQ(image.at(90, 60), rgb(0x00FF00));
    EXPECT_EQ(image.at(90, 40), rgb(0xFF0000));
    EXPECT_EQ(image.at(5, 5), black);
    const Image swapped = paint({Ink{above, rgb(0x00FF00)}, Ink{blot(), rgb(0xFF0000)}});
    EXPECT_EQ(swapped.at(90, 60), rgb(0xFF0000));
}

}  // namespace
}  // namespace batten::test
