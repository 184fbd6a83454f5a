#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "tests/render/painted.h"

namespace batten::test {
namespace {

using namespace render;
using std::numbers::pi;

class Strokes : public Painted {};

std::vector<Pixel> sampled(int count, double from, double to, auto point_at) {
    std::vector<Pixel> points;
    for (int i = 0; i < count; ++i) points.push_back(Pixel(point_at(from + (to - from) * i / (count - 1))));
    return points;
}

/// What a pixel should show: the distance from its center to the nearest segment, put through the edge's ramp.
double ideal_coverage(const Polyline& stroke, glm::dvec2 pixel) {
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t count = stroke.points.size();
    for (std::size_t i = 0; i + 1 < count + (stroke.is_closed ? 1 : 0); ++i) {
        const glm::dvec2 a(stroke.points[i]);
        const glm::dvec2 leg = glm::dvec2(stroke.points[(i + 1) % count]) - a;
        const double length_squared = glm::dot(leg, leg);
        const double t = length_squared > 0.0 ? std::clamp(glm::dot(pixel - a, leg) / length_squared, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(pixel, a + leg * t));
    }
    const double half = 0.5 * std::max(1.0F, stroke.width_px);
    return std::clamp(half + 0.5 - nearest, 0.0, 1.0) * std::min(1.0F, stroke.width_px);
}

/// The translucent stroke shows its own alpha times the ideal coverage: nowhere more, nowhere less, within 2/255 and
/// the tenth of a pixel by which a mitre may differ from a round joint.
void expect_ideal(const Image& image, const Polyline& stroke) {
    const double alpha = stroke.color.alpha / 255.0;
    double worst = 0.0;
    double most = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double ideal = alpha * ideal_coverage(stroke, {x + 0.5, y + 0.5});
            worst = std::max(worst, std::abs(image.red(x, y) - ideal));
            most = std::max(most, image.red(x, y));
        }
    }
    EXPECT_LE(most, alpha + 2.0 / 255.0);
    EXPECT_LE(worst, 0.11 * alpha + 2.0 / 255.0);
}

TEST_F(Strokes, width_is_the_sum_of_the_coverage_across) {
    for (const float width : {0.25F, 0.5F, 1.0F, 1.5F, 3.0F, 10.0F}) {
        for (const float y : {60.0F, 60.3F, 60.5F}) {
            const Image image = paint({line({{10, y}, {190, y}}, width)});
            EXPECT_NEAR(image.red_of_column(100), width, 0.02) << width << " at " << y;
        }
    }
    EXPECT_NEAR(paint({line({{10, 20}, {190, 80}}, 3)}).red_of_column(100), 3.0 * std::hypot(180, 60) / 180, 0.05);
}

TEST_F(Strokes, has_round_ends) {
    const Image image = paint({line({{60, 60}, {120, 75}}, 12)});
    const double area = 12.0 * std::hypot(60.0, 15.0) + pi * 36.0;
    EXPECT_NEAR(image.red_of_all(), area, 0.01 * area);
}

TEST_F(Strokes, point_is_a_dot) {
    EXPECT_NEAR(paint({line({{60, 60}, {60, 60}}, 12)}).red_of_all(), pi * 36.0, 1.5);
    EXPECT_NEAR(paint({line({{60, 60}}, 12)}).red_of_all(), pi * 36.0, 1.5);
}

TEST_F(Strokes, dashes_have_their_share) {
    Polyline dashed = line({{10, 60}, {190, 60}}, 2);
    dashed.dash_px = 6.0F;
    dashed.gap_px = 4.0F;
    const Image image = paint({dashed});
    double sum = 0.0;
    for (int x = 20; x < 180; ++x) sum += image.red_of_column(x);
    EXPECT_NEAR(sum, 160.0 * 2.0 * 0.6, 0.5);
    for (int x = 20; x < 180; ++x) {
        const double phase = std::fmod(x + 0.5 - 10.0, 10.0);
        EXPECT_NEAR(image.red(x, 60), phase < 6.0 ? 1.0 : 0.0, 0.01) << x;
    }
}

TEST_F(Strokes, dashes_continue_around_corners) {
    Polyline dashed = line({{10, 20}, {53, 20}, {53, 100}, {150, 100}}, 2);
    dashed.dash_px = 6.0F;
    dashed.gap_px = 4.0F;
    const Image image = paint({dashed});
    for (int y = 25; y < 95; ++y) {
        const double phase = std::fmod(43.0 + y + 0.5 - 20.0, 10.0);
        EXPECT_NEAR(image.red(53, y), phase < 6.0 ? 1.0 : 0.0, 0.01) << y;
    }
    for (int x = 58; x < 145; ++x) {
        const double phase = std::fmod(43.0 + 80.0 + x + 0.5 - 53.0, 10.0);
        EXPECT_NEAR(image.red(x, 100), phase < 6.0 ? 1.0 : 0.0, 0.01) << x;
    }
}

TEST_F(Strokes, closed_line_closes) {
    Polyline triangle = line({{30, 20}, {170, 20}, {100, 100}}, 4);
    EXPECT_EQ(paint({triangle}).at(65, 60), black);
    triangle.is_closed = true;
    EXPECT_EQ(paint({triangle}).at(65, 60), white);
    Polyline circle = line(sampled(60, 0.0, 2.0 * pi * 59 / 60,
                                   [](double u) { return glm::dvec2(100 + 40 * std::cos(u), 60 + 40 * std::sin(u)); }),
                           3, {255, 255, 255, 128});
    circle.is_closed = true;
    expect_ideal(paint({circle}), circle);
}

TEST_F(Strokes, translucent_smooth_curve_keeps_its_alpha) {
    const auto wave = sampled(100, 10, 190, [](double x) { return glm::dvec2(x, 60 + 40 * std::sin(x / 15.0)); });
    for (const float width : {0.6F, 1.5F, 3.0F, 9.0F}) {
        const Polyline stroke = line(wave, width, {255, 255, 255, 128});
        expect_ideal(paint({stroke}), stroke);
    }
}

TEST_F(Strokes, translucent_line_keeps_its_alpha_at_sharp_corners) {
    std::vector<Pixel> zigzag;
    for (int i = 0; i < 9; ++i) zigzag.push_back({10.0F + 20.0F * static_cast<float>(i), i % 2 == 0 ? 20.0F : 94.6F});
    for (const float width : {1.0F, 3.0F, 11.0F}) {
        const Polyline stroke = line(zigzag, width, {255, 255, 255, 90});
        expect_ideal(paint({stroke}), stroke);
    }
}

TEST_F(Strokes, translucent_line_keeps_its_alpha_at_hairpins) {
    const std::vector<Pixel> back_and_forth{{20, 30}, {170, 30}, {30, 30},    {160, 35},
                                            {40, 36}, {150, 90}, {150.5F, 20}};
    for (const float width : {1.0F, 3.0F, 11.0F}) {
        const Polyline stroke = line(back_and_forth, width, {255, 255, 255, 128});
        expect_ideal(paint({stroke}), stroke);
    }
}

TEST_F(Strokes, translucent_line_keeps_its_alpha_where_segments_are_shorter_than_its_width) {
    const auto cusp = sampled(100, -1, 1, [](double t) { return glm::dvec2(100 + 80 * t * t * t, 20 + 80 * t * t); });
    const auto spiral = sampled(
        300, 0, 20, [](double u) { return glm::dvec2(100 + 2.5 * u * std::cos(u), 60 + 2.5 * u * std::sin(u)); });
    for (const float width : {3.0F, 10.0F}) {
        for (const auto& points : {cusp, spiral}) {
            const Polyline stroke = line(points, width, {255, 255, 255, 128});
            expect_ideal(paint({stroke}), stroke);
        }
    }
}

TEST_F(Strokes, translucent_line_keeps_its_alpha_where_it_crosses_itself) {
    const auto loops = sampled(100, 0, 2 * pi, [](double u) {
        return glm::dvec2(100 + 80 * std::sin(2 * u), 60 + 50 * std::sin(3 * u + 0.4));
    });
    Polyline stroke = line(loops, 5, {255, 255, 255, 128});
    expect_ideal(paint({stroke}), stroke);
    stroke.is_closed = true;
    expect_ideal(paint({stroke}), stroke);
}

TEST_F(Strokes, opaque_line_is_full_within_and_never_too_thin) {
    const std::vector<Pixel> points{{20, 30}, {170, 40}, {30, 50}, {60, 100}, {64, 101}, {66, 104}, {180, 90}};
    for (const float width : {1.5F, 3.0F, 12.0F}) {
        const Polyline stroke = line(points, width);
        const Image image = paint({stroke});
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double ideal = ideal_coverage(stroke, {x + 0.5, y + 0.5});
                ASSERT_GE(image.red(x, y), ideal - 0.01) << x << ", " << y;
                ASSERT_LE(image.red(x, y), std::min(1.0, 1.8 * ideal + 0.11)) << x << ", " << y;
            }
        }
    }
}

TEST_F(Strokes, translucent_strokes_darken_one_another_however_many) {
    const Polyline first = line({{20, 30}, {170, 30}, {20, 31}}, 6, {255, 255, 255, 128});
    std::vector<DrawCommand> commands(2, first);
    EXPECT_NEAR(paint(commands).at(90, 30).red, 191.5, 2.0);
    commands.assign(16400, line({{20, 80}, {30, 80}, {20, 81}}, 2, {255, 255, 255, 1}));
    commands.emplace_back(first);
    EXPECT_NEAR(paint(commands).at(90, 30).red, 128.0, 2.0);
}

/// Where a nearly horizontal line crosses a column: the mean height of its coverage.
double height_in_column(const Image& image, int x) {
    double sum = 0.0;
    double weighted = 0.0;
    for (int y = 0; y < image.height; ++y) {
        sum += image.red(x, y);
        weighted += image.red(x, y) * (y + 0.5);
    }
    return weighted / sum;
}

TEST_F(Strokes, far_line_crosses_the_screen_at_the_right_pixels) {
    // Through (100, 60) with slope 1/2; both ends are whole numbers, exact as floats.
    const Polyline stroke = line({{-9999900, -4999940}, {10000100, 5000060}}, 3);
    const Image image = paint({stroke});
    double mean_error = 0.0;
    for (int x = 0; x < 200; ++x) {
        const double error = height_in_column(image, x) - (60.0 + 0.5 * (x + 0.5 - 100.0));
        EXPECT_NEAR(error, 0.0, 0.06) << x;  // what sampling the ramp of a sloping edge leaves
        mean_error += error / 200.0;
    }
    EXPECT_NEAR(mean_error, 0.0, 0.002);
}

TEST_F(Strokes, far_corners_leave_the_screen_alone) {
    const Image image = paint({line({{-1e7F, 1e7F}, {-300, 60}, {500, -1e7F}, {1e7F, 0}, {300, 1e7F}}, 3)});
    EXPECT_EQ(image.red_of_all(), 0.0);
}

TEST_F(Strokes, far_line_keeps_the_phase_of_its_dashes) {
    Polyline stroke = line({{-10000000, 60.5F}, {1000000, 60.5F}}, 3);
    stroke.dash_px = 12.0F;
    stroke.gap_px = 13.0F;
    const Image image = paint({stroke});
    for (int x = 0; x < 200; ++x) {
        const double phase = std::fmod(x + 0.5 + 1e7, 25.0);
        EXPECT_NEAR(image.red(x, 60), phase < 12.0 ? 1.0 : 0.0, 0.01) << x;
    }
}

TEST_F(Strokes, long_polyline_with_far_points_is_seen_where_it_returns) {
    const Polyline stroke = line({{20, 20}, {100, 20}, {100, -5e6F}, {150, -5e6F}, {150, 100}, {20, 100}}, 4);
    const Image image = paint({stroke});
    EXPECT_NEAR(image.red_of_column(60), 8.0, 0.05);
    for (const int y : {0, 10, 19}) EXPECT_EQ(image.at(100, y), white);
    for (const int y : {0, 50, 99}) EXPECT_EQ(image.at(150, y), white);
    EXPECT_EQ(image.at(100, 50), black);
}

}  // namespace
}  // namespace batten::test
