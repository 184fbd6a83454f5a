#include "render/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace batten::render {
namespace {

void expect_near(glm::dvec2 actual, glm::dvec2 expected, double tolerance) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
}

/// The distance from the larger coordinate to the next double: no world point can be told more finely.
double spacing_at(glm::dvec2 point) {
    const double largest = std::max(std::abs(point.x), std::abs(point.y));
    return std::nextafter(largest, 2.0 * largest + 1.0) - largest;
}

const Camera example{{3.0, -2.0}, 50.0, {800.0, 600.0}};

TEST(Camera, center_of_view_is_center_of_picture) {
    expect_near(screen_from_world(example, {3, -2}), {400, 300}, 0.0);
}

TEST(Camera, world_y_points_up) {
    expect_near(screen_from_world(example, {4, -1}), {450, 250}, 0.0);
    expect_near(world_from_screen(example, {450, 250}), {4, -1}, 1e-15);
    expect_near(world_from_screen(example, {0, 0}), {-5, 4}, 1e-14);
}

TEST(Camera, size_of_picture_moves_the_center_only) {
    Camera doubled = example;
    doubled.size_px = {1600.0, 900.0};
    expect_near(screen_from_world(doubled, {4, -1}), {850, 400}, 0.0);
    expect_near(world_from_screen(doubled, {850, 400}), {4, -1}, 1e-15);
}

TEST(Camera, round_trip_at_all_scales_far_from_the_origin) {
    const glm::dvec2 pixel{123.25, 456.75};
    for (double scale = 1e-6; scale <= 1.001e12; scale *= 10.0) {
        for (const double far : {0.0, 1.0, 1e6, 1e9}) {
            const Camera camera{{far, -0.7 * far}, scale, {1440.0, 900.0}};
            const glm::dvec2 world = world_from_screen(camera, pixel);
            const double tolerance = 1e-9 + 2.0 * spacing_at(world) * scale;
            expect_near(screen_from_world(camera, world), pixel, tolerance);
        }
    }
}

TEST(Camera, neighboring_doubles_are_told_apart_at_any_scale) {
    const double far = 1e6;
    const double step = std::nextafter(far, 2e6) - far;
    const Camera camera{{far, far}, 1e12, {1440.0, 900.0}};
    const double shift = screen_from_world(camera, {far + step, far}).x - screen_from_world(camera, {far, far}).x;
    EXPECT_NEAR(shift, step * 1e12, 1e-9);
}

TEST(Camera, panning_shifts_the_content) {
    const Camera moved = panned(example, {30.0, -12.0});
    expect_near(screen_from_world(moved, {4, -1}), {480, 238}, 1e-10);
    EXPECT_EQ(moved.scale, example.scale);
}

TEST(Camera, zoom_keeps_the_anchor) {
    const glm::dvec2 anchor{700.0, 20.0};
    for (const double factor : {1e-3, 0.8, 1.25, 1e4}) {
        const Camera closer = zoomed(example, factor, anchor);
        EXPECT_NEAR(closer.scale, 50.0 * factor, 1e-9 * factor);
        expect_near(screen_from_world(closer, world_from_screen(example, anchor)), anchor, 1e-9);
    }
}

TEST(Camera, zooming_by_steps_over_twelve_decades_keeps_the_anchor) {
    const glm::dvec2 anchor{700.0, 20.0};
    Camera camera{{0.0, 0.0}, 1e-6, {800.0, 600.0}};
    const glm::dvec2 world = world_from_screen(camera, anchor);
    for (int step = 0; step < 120; ++step) {
        camera = zoomed(camera, std::pow(10.0, 0.1), anchor);
        const double tolerance = 1e-9 + 2.0 * (step + 1) * spacing_at(world) * camera.scale;
        expect_near(screen_from_world(camera, world), anchor, tolerance);
    }
    EXPECT_NEAR(camera.scale, 1e6, 1e-6);
}

TEST(Camera, zoom_stops_at_the_limits_and_still_keeps_the_anchor) {
    const glm::dvec2 anchor{100.0, 500.0};
    EXPECT_EQ(zoomed(example, 1e300, anchor).scale, Camera::max_scale);
    const Camera far = zoomed(example, 1e-300, anchor);
    EXPECT_EQ(far.scale, Camera::min_scale);
    expect_near(screen_from_world(far, world_from_screen(example, anchor)), anchor, 1e-9);
}

TEST(Camera, fit_fills_the_narrower_direction) {
    const Camera wide = fitted(example, {-1, 10}, {9, 12}, 50.0);
    expect_near(wide.center, {4, 11}, 0.0);
    EXPECT_DOUBLE_EQ(wide.scale, 70.0);
    expect_near(screen_from_world(wide, {-1, 11}), {50, 300}, 1e-12);
    const Camera tall = fitted(example, {0, 0}, {1, 10}, 50.0);
    EXPECT_DOUBLE_EQ(tall.scale, 50.0);
    expect_near(screen_from_world(tall, {0.5, 10}), {400, 50}, 1e-12);
}

TEST(Camera, fit_of_a_line_uses_its_length) {
    EXPECT_DOUBLE_EQ(fitted(example, {0, 5}, {10, 5}, 0.0).scale, 80.0);
    EXPECT_DOUBLE_EQ(fitted(example, {2, 0}, {2, 10}, 0.0).scale, 60.0);
}

TEST(Camera, fit_of_a_point_only_centers) {
    const Camera camera = fitted(example, {7, 8}, {7, 8}, 20.0);
    expect_near(camera.center, {7, 8}, 0.0);
    EXPECT_EQ(camera.scale, 50.0);
}

TEST(Camera, fit_with_margins_wider_than_the_picture_stays_usable) {
    const Camera camera = fitted(example, {0, 0}, {1, 1}, 1000.0);
    EXPECT_DOUBLE_EQ(camera.scale, 1.0);
    EXPECT_EQ(fitted(example, {-1e308, -1e308}, {1e308, 1e308}, 0.0).scale, Camera::min_scale);
}

}  // namespace
}  // namespace batten::render
