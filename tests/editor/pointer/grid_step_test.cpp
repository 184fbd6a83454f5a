#include "app/editor/pointer/grid_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::editor {
namespace {

TEST(GridStep, takes_the_least_step_of_eighty_pixels) {
    EXPECT_EQ(major_grid_step(64.0), 2.0);
    EXPECT_EQ(minor_grid_step(64.0), 0.5);
    EXPECT_EQ(major_grid_step(80.0), 1.0);
    EXPECT_EQ(minor_grid_step(80.0), 0.2);
    EXPECT_EQ(major_grid_step(79.0), 2.0);
    EXPECT_EQ(major_grid_step(39.0), 5.0);
    EXPECT_EQ(minor_grid_step(39.0), 1.0);
    EXPECT_EQ(major_grid_step(1000.0), 0.1);
    EXPECT_EQ(minor_grid_step(1000.0), 0.02);
    EXPECT_EQ(major_grid_step(0.1), 1000.0);
}

TEST(GridStep, keeps_lines_apart_at_every_scale) {
    for (double exponent = -9.0; exponent <= 15.0; exponent += 0.013) {
        const double scale = std::pow(10.0, exponent);
        const double major_px = major_grid_step(scale) * scale;
        EXPECT_GE(major_px, 80.0) << scale;
        EXPECT_LT(major_px, 200.0 + 1e-9) << scale;
        const double minor_px = minor_grid_step(scale) * scale;
        EXPECT_GE(minor_px, 16.0 - 1e-9) << scale;
        EXPECT_LT(minor_px, 40.0 + 1e-9) << scale;
    }
}

TEST(GridStep, is_one_two_or_five_times_a_power_of_ten) {
    for (double exponent = -9.0; exponent <= 15.0; exponent += 0.017) {
        const double scale = std::pow(10.0, exponent);
        for (const double step : {major_grid_step(scale), minor_grid_step(scale)}) {
            const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
            EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9) << step;
        }
    }
}

}  // namespace
}  // namespace batten::editor
