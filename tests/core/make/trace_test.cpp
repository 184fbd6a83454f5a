#include "core/make/trace.h"

#include <gtest/gtest.h>

#include "core/evaluate/evaluator.h"
#include "tests/core/painted_image.h"

namespace batten::core {
namespace {

Trace trace_of(const GrayImage& image, const TraceRequest& request = {}) {
    auto found = trace(image, request);
    EXPECT_TRUE(found) << (found ? "" : describe(found.error()));
    return found ? *std::move(found) : Trace{};
}

std::vector<Point> points_on(const Curve& curve) {
    std::vector<Point> points;
    const Evaluator evaluator(curve);
    const Interval domain = curve.domain();
    constexpr int count = 2000;
    for (int k = 0; k < count; ++k) points.push_back(evaluator.point_at(domain.lower + domain.length() * k / count));
    return points;
}

// The largest distance between the curve and what was painted, measured both ways.
double deviation(const Curve& curve, const Outline& truth) {
    const std::vector<Point> points = points_on(curve);
    double most = 0.0;
    for (const Point point : points) most = std::max(most, distance_to(truth, point));
    for (std::size_t i = 0; i < truth.size(); i += std::max<std::size_t>(1, truth.size() / 200))
        most = std::max(most, distance_to(points, truth[i]));
    return most;
}

std::size_t count_of(const Curve& curve) {
    return curve.control_points().size();
}

Outline turned(const Outline& outline, Point center, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    Outline points;
    for (const Point p : outline) {
        const Vector v = p - center;
        points.push_back(center + std::cos(angle) * v + std::sin(angle) * turned_left(v));
    }
    return points;
}

TEST(Trace, circles_of_all_sizes_have_few_points) {
    for (const double radius : {2.0, 3.0, 5.0, 11.3, 40.0, 123.4, 300.0}) {
        const auto side = static_cast<int>(2 * radius + 12);
        const Outline truth = circle_outline({0.5 * side + 0.3, 0.5 * side - 0.2}, radius);
        const Trace found = trace_of(painted(side, side, {truth}));
        ASSERT_EQ(found.curves.size(), 1U) << radius;
        EXPECT_LE(count_of(found.curves[0]), 12U) << radius;
        EXPECT_LE(deviation(found.curves[0], truth), radius < 4.0 ? 0.5 : 0.4) << radius;
        EXPECT_TRUE(found.curves[0].is_periodic());
        EXPECT_LE(found.error, 0.3);
    }
}

TEST(Trace, circles_in_the_middle_of_pixels_have_neither_corners_nor_lines) {
    for (const double radius : {20.0, 33.0, 50.0, 75.0}) {
        const auto side = static_cast<int>(2 * radius + 20);
        const Trace found = trace_of(painted(side, side, {circle_outline({0.5 * side, 0.5 * side}, radius)}));
        EXPECT_LE(count_of(found.curves.at(0)), 12U) << radius;
        EXPECT_EQ(found.curves.at(0).degree(), 3) << radius;
    }
}

TEST(Trace, a_square_has_four_corners) {
    for (const double degrees : {0.0, 7.0, 30.0, 45.0, 81.0})
        for (const double size : {13.0, 60.0, 200.3}) {
            const auto side = static_cast<int>(1.5 * size + 8);
            const Point center{0.5 * side + 0.37, 0.5 * side + 0.11};
            const double h = 0.5 * size;
            const Outline truth =
                turned({center + Vector(-h, -h), center + Vector(h, -h), center + Vector(h, h), center + Vector(-h, h)},
                       center, degrees);
            const Trace found = trace_of(painted(side, side, {truth}));
            ASSERT_EQ(found.curves.size(), 1U);
            EXPECT_EQ(count_of(found.curves[0]), 4U) << size << " at " << degrees;
            EXPECT_EQ(found.curves[0].degree(), 1) << size << " at " << degrees;
            EXPECT_LE(deviation(found.curves[0], truth), 0.35) << size << " at " << degrees;
        }
}

TEST(Trace, polygons_keep_their_corners) {
    // A triangle, an L, a five-pointed star, and an octagon that is no circle.
    const Outline triangle{{10.2, 8.1}, {92.4, 20.7}, {40.3, 80.9}};
    const Outline corner{{10.5, 10.5}, {80.25, 10.5}, {80.25, 30.75}, {32.5, 30.75}, {32.5, 88.0}, {10.5, 88.0}};
    Outline star;
    for (int k = 0; k < 10; ++k) {
        const double angle = (18 + 36 * k) * std::numbers::pi / 180.0;
        star.push_back(Point(50.3, 49.8) + (k % 2 == 0 ? 45.0 : 19.0) * Vector(std::cos(angle), std::sin(angle)));
    }
    Outline octagon;
    for (int k = 0; k < 8; ++k) {
        const double angle = (10 + 45 * k) * std::numbers::pi / 180.0;
        octagon.push_back(Point(50, 50) + 42.0 * Vector(std::cos(angle), std::sin(angle)));
    }
    for (const Outline& truth : {triangle, corner, star, octagon}) {
        const Trace found = trace_of(painted(100, 100, {truth}));
        ASSERT_EQ(found.curves.size(), 1U);
        EXPECT_EQ(count_of(found.curves[0]), truth.size());
        EXPECT_LE(deviation(found.curves[0], truth), 0.4) << truth.size();
    }
}

// A half disc on the left side of which is a straight stem, as of a D: two corners.
TEST(Trace, lines_and_arcs_meet_in_corners) {
    Outline truth = arc({30.4, 50.2}, 38.0, -90.0, 90.0);
    const Trace found = trace_of(painted(100, 100, {truth}));
    ASSERT_EQ(found.curves.size(), 1U);
    const Curve& curve = found.curves[0];
    EXPECT_LE(deviation(curve, truth), 0.45);
    EXPECT_LE(count_of(curve), 14U);
    EXPECT_EQ(curve.degree(), 3);
    // Both corners are knots of multiplicity 3, near the true ones.
    double nearest_upper = 1e9;
    double nearest_lower = 1e9;
    for (const Point p : curve.control_points()) {
        nearest_upper = std::min(nearest_upper, distance(p, {30.4, 88.2}));
        nearest_lower = std::min(nearest_lower, distance(p, {30.4, 12.2}));
    }
    EXPECT_LE(nearest_upper, 0.4);
    EXPECT_LE(nearest_lower, 0.4);
}

// A slot: two straight sides that go over into half circles.
TEST(Trace, lines_go_over_into_arcs_smoothly) {
    Outline truth = arc({90.3, 40.6}, 20.0, -90.0, 90.0);
    const Outline other = arc({35.1, 40.6}, 20.0, 90.0, 270.0);
    truth.insert(truth.end(), other.begin(), other.end());
    const Trace found = trace_of(painted(130, 80, {truth}));
    ASSERT_EQ(found.curves.size(), 1U);
    EXPECT_LE(deviation(found.curves[0], truth), 0.45);
    EXPECT_LE(count_of(found.curves[0]), 30U);
}

// An O with its counter, an R-like stem with a bowl and a leg: what letters are made of.
TEST(Trace, letters_have_outlines_and_holes) {
    const Outline outer = circle_outline({50.2, 50.4}, 41.0);
    const Outline inner = reversed(circle_outline({50.2, 50.4}, 24.0));
    const Trace ring = trace_of(painted(100, 100, {outer, inner}));
    ASSERT_EQ(ring.curves.size(), 2U);
    EXPECT_LE(deviation(ring.curves[0], outer), 0.4);
    EXPECT_LE(deviation(ring.curves[1], inner), 0.4);

    Outline stem{{10.3, 8.6}, {26.3, 8.6}, {26.3, 40.6}, {38.3, 40.6}, {58.8, 8.6}, {78.8, 8.6}, {55.2, 43.4}};
    const Outline bowl = arc({46.3, 66.6}, 26.0, -52.0, 90.0);
    stem.insert(stem.end(), bowl.begin(), bowl.end());
    stem.push_back({10.3, 92.6});
    Outline counter = arc({44.3, 66.6}, 12.0, -90.0, 90.0);
    counter.push_back({26.3, 78.6});
    counter.push_back({26.3, 54.6});
    const Trace letter = trace_of(painted(100, 100, {stem, reversed(counter)}));
    ASSERT_EQ(letter.curves.size(), 2U);
    EXPECT_LE(deviation(letter.curves[0], stem), 0.5);
    EXPECT_LE(deviation(letter.curves[1], reversed(counter)), 0.5);
    EXPECT_LE(count_of(letter.curves[0]), 45U);
    EXPECT_LE(count_of(letter.curves[1]), 25U);
}

TEST(Trace, speckles_are_dropped_by_their_area) {
    const Outline disc = circle_outline({30, 30}, 15);
    const Outline dot = circle_outline({55, 55}, 2.0);  // of area 12.6
    const GrayImage image = painted(60, 60, {disc, dot});
    EXPECT_EQ(trace_of(image, {.speckle = 4.0}).curves.size(), 2U);
    EXPECT_EQ(trace_of(image, {.speckle = 20.0}).curves.size(), 1U);
    EXPECT_EQ(trace_of(image, {.speckle = 1000.0}).curves.size(), 0U);
}

TEST(Trace, light_on_dark_is_outlined_when_inverted) {
    const Outline truth = circle_outline({30.3, 28.1}, 15);
    const Trace found = trace_of(painted(60, 60, {truth}, 230, 20), {.is_inverted = true});
    ASSERT_EQ(found.curves.size(), 1U);
    EXPECT_LE(deviation(found.curves[0], truth), 0.4);
    EXPECT_NEAR(found.threshold, 125.0, 1.0);
}

TEST(Trace, shades_do_not_matter_without_a_threshold) {
    const Outline truth = circle_outline({30.3, 28.1}, 15);
    EXPECT_LE(deviation(trace_of(painted(60, 60, {truth}, 90, 170)).curves.at(0), truth), 0.4);
    // A threshold off the middle moves the outline, by less than half a pixel.
    const Curve darker = trace_of(painted(60, 60, {truth}), {.threshold = 40.0}).curves.at(0);
    const Curve lighter = trace_of(painted(60, 60, {truth}), {.threshold = 215.0}).curves.at(0);
    EXPECT_LT(distance(points_on(darker).front(), {30.3, 28.1}), distance(points_on(lighter).front(), {30.3, 28.1}));
}

TEST(Trace, tolerance_is_kept_and_saves_points) {
    Outline wave;
    for (int k = 0; k < 1440; ++k) {
        const double angle = k * std::numbers::pi / 720.0;
        wave.push_back(Point(100, 100) +
                       (70.0 + 12.0 * std::sin(7 * angle)) * Vector(std::cos(angle), std::sin(angle)));
    }
    const GrayImage image = painted(200, 200, {wave});
    const Trace fine = trace_of(image, {.tolerance = 0.15});
    const Trace coarse = trace_of(image, {.tolerance = 1.0});
    EXPECT_LE(fine.error, 0.15);
    EXPECT_LE(coarse.error, 1.0);
    EXPECT_LT(count_of(coarse.curves[0]), count_of(fine.curves[0]));
    EXPECT_LE(deviation(fine.curves[0], wave), 0.3);
}

TEST(Trace, bad_images_and_requests) {
    EXPECT_EQ(trace(GrayImage{2, 2, {0, 0, 0, 0}}, {.tolerance = 0.0}).error().code,
              CurveErrorCode::tolerance_not_positive);
    EXPECT_TRUE(trace_of(GrayImage{0, 0, {}}).curves.empty());
    EXPECT_TRUE(trace_of(GrayImage{3, 2, {255, 255, 255, 255, 255, 255}}).curves.empty());
    // One pixel and rows of one are outlined as well as they can be.
    EXPECT_EQ(trace_of(GrayImage{1, 1, {0}}, {.speckle = 0.0}).curves.size(), 1U);
    EXPECT_EQ(trace_of(GrayImage{20, 1, std::vector<std::uint8_t>(20, 0)}, {.speckle = 0.0}).curves.size(), 1U);
    GrayImage noise{120, 90, {}};
    unsigned seed = 1;
    for (int k = 0; k < 120 * 90; ++k)
        noise.values.push_back(static_cast<std::uint8_t>((seed = seed * 1664525 + 1013904223) >> 24));
    EXPECT_GT(trace_of(noise, {.speckle = 0.0}).curves.size(), 100U);
}

TEST(Trace, tells_how_far_it_is_and_stops) {
    const GrayImage image = painted(60, 60, {circle_outline({30, 30}, 15)});
    std::vector<double> shares;
    ASSERT_TRUE(trace(image, {}, [&](double share) { shares.push_back(share); }));
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
    struct Stop {};
    EXPECT_THROW((void)trace(image, {}, [](double) { throw Stop{}; }), Stop);
}

}  // namespace
}  // namespace batten::core
