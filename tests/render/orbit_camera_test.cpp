#include "render/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::render {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

void expect_near(glm::dvec2 actual, glm::dvec2 expected, double tolerance = 1e-12) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
}

OrbitCamera camera(double yaw, double pitch) {
    return {.yaw = yaw, .pitch = pitch, .scale = 100.0, .target = {0, 0, 1}, .center_px = {300, 200}};
}

TEST(OrbitCamera, shows_its_target_in_the_center) {
    for (const double yaw : {-2.0, 0.0, 1.0})
        for (const double pitch : {-1.0, 0.0, right_angle})
            expect_near(screen_from_space(camera(yaw, pitch), {0, 0, 1}), {300, 200});
}

TEST(OrbitCamera, looks_along_y_at_first) {
    const OrbitCamera level = camera(0, 0);
    expect_near(screen_from_space(level, {1, 0, 1}), {400, 200});
    expect_near(screen_from_space(level, {0, 0, 2}), {300, 100});
    expect_near(screen_from_space(level, {0, 7, 1}), {300, 200});
    EXPECT_NEAR(nearness(level, {0, -2, 1}), 2, 1e-15);
}

TEST(OrbitCamera, from_above_sees_the_plane_as_it_is) {
    const OrbitCamera above = camera(0, right_angle);
    expect_near(screen_from_space(above, {1, 0, 1}), {400, 200});
    expect_near(screen_from_space(above, {0, 1, 1}), {300, 100});
    expect_near(screen_from_space(above, {0, 0, 9}), {300, 200});
    EXPECT_NEAR(nearness(above, {0, 0, 3}), 2, 1e-15);
}

TEST(OrbitCamera, goes_around_counterclockwise) {
    // From the side where x is positive, y is to the right.
    const OrbitCamera aside = camera(right_angle, 0);
    expect_near(screen_from_space(aside, {0, 1, 1}), {400, 200});
    EXPECT_NEAR(nearness(aside, {3, 0, 1}), 3, 1e-15);
}

TEST(OrbitCamera, sees_half_the_height_from_sixty_degrees) {
    const OrbitCamera high = camera(0, std::numbers::pi / 3);
    expect_near(screen_from_space(high, {0, 0, 2}), {300, 150});
    expect_near(screen_from_space(high, {0, 1, 1}), {300, 200 - 50 * std::sqrt(3.0)});
}

TEST(OrbitCamera, turns_what_is_in_front_with_the_pointer) {
    const OrbitCamera before = camera(0.3, 0.4);
    const glm::dvec3 in_front{std::sin(0.3), -std::cos(0.3), 1};
    const glm::dvec2 place = screen_from_space(before, in_front);
    EXPECT_GT(screen_from_space(turned(before, {10, 0}), in_front).x, place.x);
    EXPECT_GT(screen_from_space(turned(before, {0, 10}), in_front).y, place.y);
}

TEST(OrbitCamera, never_turns_over) {
    EXPECT_EQ(turned(camera(0, 0), {0, 1e5}).pitch, right_angle);
    EXPECT_EQ(turned(camera(0, 0), {0, -1e5}).pitch, -right_angle);
    const double around = turned(camera(3, 0), {-1e4, 0}).yaw;
    EXPECT_LE(std::abs(around), std::numbers::pi);
    EXPECT_NEAR(std::cos(around), std::cos(103.0), 1e-12);
}

TEST(OrbitCamera, finds_the_place_on_a_ray_under_the_pointer) {
    const OrbitCamera view = camera(0.7, 0.5);
    const glm::dvec3 direction{0.5, -1, 1};
    for (const double t : {-1.0, 0.25, 3.0}) {
        const glm::dvec2 place = screen_from_space(view, t * direction);
        EXPECT_NEAR(nearest_along(view, {0, 0, 0}, direction, place).value(), t, 1e-12);
        // Beside the ray, by its foot.
        const glm::dvec2 along = screen_from_space(view, direction) - screen_from_space(view, {0, 0, 0});
        EXPECT_NEAR(nearest_along(view, {0, 0, 0}, direction, place + glm::dvec2(-along.y, along.x)).value(), t, 1e-12);
    }
}

TEST(OrbitCamera, finds_none_on_a_ray_seen_from_its_end) {
    EXPECT_FALSE(nearest_along(camera(0, right_angle), {0, 0, 0}, {0, 0, 1}, {300, 200}));
    EXPECT_FALSE(nearest_along(camera(0, 0), {0, 0, 0}, {0, 5, 0}, {300, 200}));
    EXPECT_TRUE(nearest_along(camera(0, 0), {0, 0, 0}, {0.05, 5, 0}, {300, 200}));
}

}  // namespace
}  // namespace batten::render
