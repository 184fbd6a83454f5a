#include "app/editor/derived/measured.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/point_edit.h"

namespace batten::editor {

namespace {

core::Curve cubic() {
    return core::Curve::make({.degree = 3,
                              .knots = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3},
                              .points = {{0, 0}, {1, 3}, {3, -2}, {5, 2}, {6, 0}, {8, 1}}})
        .value();
}

core::Curve long_wave(int count) {
    core::CurveDefinition definition{.degree = 3};
    for (int i = 0; i < count; ++i) definition.points.emplace_back(i, i % 2);
    for (int i = 0; i < count + 4; ++i) definition.knots.push_back(i);
    return core::Curve::make(std::move(definition)).value();
}

TEST(Measured, is_kept_beside_curve_and_question) {
    const Measured measured;
    const core::Curve curve = cubic();
    const core::Curve copy = curve;
    const core::Curve dragged = core::set_control_point(curve, 2, {3.0, -1.0}).value();
    const ProbeLine line{{0, 0.5}, {1, 0.5}};
    const auto crossings = measured.crossings(curve, line);
    EXPECT_EQ(measured.crossings(copy, line), crossings);
    EXPECT_NE(measured.crossings(dragged, line), crossings);
    EXPECT_NE(measured.crossings(curve, {{0, 0.25}, {1, 0.5}}), crossings);
    EXPECT_EQ(measured.equal_lengths(curve, 7), measured.equal_lengths(copy, 7));
    EXPECT_NE(measured.equal_lengths(curve, 7), measured.equal_lengths(curve, 8));
    EXPECT_EQ(measured.bends(curve, {{0, 3}}), measured.bends(copy, {{0, 3}}));
}

TEST(Measured, crossings_never_exceed_those_of_the_polygon) {
    const Measured measured;
    const auto crossings = measured.crossings(cubic(), {{0, 0.5}, {1, 0.5}});
    ASSERT_NE(crossings, nullptr);
    EXPECT_EQ(crossings->polygon_crossings, 5U);
    EXPECT_LE(crossings->crossings, 5U);
    EXPECT_TRUE(crossings->is_complete);
    EXPECT_EQ(measured.crossings(cubic(), {{1, 1}, {1, 1}}), nullptr);
    const auto many = measured.crossings(long_wave(10'000), {{0, 0.5}, {1, 0.5}});
    EXPECT_FALSE(many->is_complete);
    EXPECT_EQ(many->polygon_crossings, 9'999U);
}

TEST(Measured, equal_steps_and_equal_lengths_of_a_quarter_circle) {
    const Measured measured;
    const double w = std::sqrt(0.5);
    const core::Curve arc =
        core::Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{2, 0}, {2, 2}, {0, 2}}, .weights = {1, w, 1}})
            .value();
    const auto lengths = measured.equal_lengths(arc, 6);
    ASSERT_EQ(lengths->ends.size(), 7U);
    EXPECT_NEAR(lengths->length, std::acos(-1.0) / 6.0, 1e-14);
    for (std::size_t k = 0; k < 7; ++k) {
        const double angle = std::acos(-1.0) / 12.0 * static_cast<double>(k);
        EXPECT_NEAR(lengths->ends[k].point.x, 2.0 * std::cos(angle), 1e-13);
        EXPECT_NEAR(lengths->ends[k].point.y, 2.0 * std::sin(angle), 1e-13);
    }
    const auto steps = measured.equal_steps(arc, 4);
    ASSERT_EQ(steps->ends.size(), 5U);
    EXPECT_EQ(steps->ends[1].u, 0.25);
    EXPECT_GT(std::abs(steps->ends[1].point.x - 2.0 * std::cos(std::acos(-1.0) / 8.0)), 1e-3);
    EXPECT_EQ(steps->ends[4].point, core::Point(0, 2));
}

TEST(Measured, what_has_no_length_or_is_too_long_has_no_equal_lengths) {
    const Measured measured;
    const core::Curve still =
        core::Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {1, 1}}}).value();
    EXPECT_TRUE(measured.equal_lengths(still, 5)->ends.empty());
    EXPECT_TRUE(measured.equal_lengths(long_wave(20'001), 5)->ends.empty());
    EXPECT_EQ(measured.equal_lengths(long_wave(10'000), 64)->ends.size(), 65U);
}

TEST(ProbeLine, begins_level_through_the_middle_whatever_the_curve) {
    const ProbeLine line = level_line_through(cubic());
    EXPECT_EQ(line.first.y, 0.5);
    EXPECT_EQ(line.second.y, 0.5);
    EXPECT_NEAR(line.first.x, 0.8, 1e-15);
    EXPECT_NEAR(line.second.x, 7.2, 1e-15);
    for (const double size : {0.0, 1e-300, 1e-9, 1e9, 1e300, 1.7e308})
        for (const double far : {0.0, 1e6}) {
            const core::Curve curve =
                core::Curve::make(
                    {.degree = 1, .knots = {0, 0, 1, 1}, .points = {{far, far - size}, {far, far + size}}})
                    .value();
            EXPECT_TRUE(is_line(level_line_through(curve))) << size << " " << far;
        }
    EXPECT_FALSE(is_line({{1, 2}, {1, 2}}));
    EXPECT_FALSE(is_line({{1, 2}, {std::nan(""), 2}}));
}

}  // namespace

}  // namespace batten::editor
