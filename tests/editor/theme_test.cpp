#include "app/editor/theme.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

using render::rgb;

TEST(Theme, has_the_colors_of_the_look) {
    const Theme dark = theme_of(ThemeName::dark);
    EXPECT_EQ(dark.canvas, rgb(0x14161B));
    EXPECT_EQ(dark.field, rgb(0x22262F));
    EXPECT_EQ(dark.accent, rgb(0x5AA9FF));
    EXPECT_EQ(dark.parameter, rgb(0xFFD166));
    const Theme light = theme_of(ThemeName::light);
    EXPECT_EQ(light.canvas, rgb(0xFBFBFD));
    EXPECT_EQ(light.text, rgb(0x1B2130));
    EXPECT_EQ(light.grid_major, rgb(0xE3E7EE));
    EXPECT_EQ(light.parameter, rgb(0xB45309));
}

TEST(Theme, cycles_levels_from_one_and_points_from_zero) {
    const Theme theme = theme_of(ThemeName::dark);
    EXPECT_EQ(theme.level(1), rgb(0x4FC3A1));
    EXPECT_EQ(theme.level(3), rgb(0xEF6F8E));
    EXPECT_EQ(theme.level(4), theme.level(1));
    EXPECT_EQ(theme.point(0), rgb(0xE69F00));
    EXPECT_EQ(theme.point(5), rgb(0xE8743B));
    EXPECT_EQ(theme.point(8), theme.point(0));
}

}  // namespace
}  // namespace batten::editor
