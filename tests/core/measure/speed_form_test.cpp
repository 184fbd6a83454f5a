#include "core/measure/detail/speed_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

PieceMotion piece_of(RandomCurves& random, int degree, double weight_at_end = 1.0) {
    BezierPiece piece{.interval = {0.0, 1.0}, .points = {}};
    for (int i = 0; i <= degree; ++i) {
        const double x = random.number(-8.0, 8.0);
        piece.points.emplace_back(x, random.number(-8.0, 8.0), 1.0);
    }
    piece.points.back() *= weight_at_end;
    return PieceMotion(std::move(piece));
}

}  // namespace

TEST(SpeedForm, has_the_velocities_of_the_piece) {
    RandomCurves random(91);
    for (int degree = 1; degree <= 8; ++degree) {
        const PieceMotion piece = piece_of(random, degree);
        const SpeedForm form(piece);
        ASSERT_TRUE(form.is_plain());
        for (const double t : {0.0, 0.1, 0.5, 0.7, 1.0}) {
            const Vector expected = piece.at(t).velocity;
            EXPECT_NEAR(form.velocity(t - 0.5).x, expected.x, 1e-13) << degree << ' ' << t;
            EXPECT_NEAR(form.velocity(t - 0.5).y, expected.y, 1e-13) << degree << ' ' << t;
        }
    }
}

TEST(SpeedForm, has_the_velocities_of_a_rational_piece_and_its_rules) {
    RandomCurves random(94);
    for (int degree = 1; degree <= 7; ++degree)
        for (const double weight : {0.25, 15.0}) {
            const PieceMotion piece = piece_of(random, degree, weight);
            const SpeedForm form(piece);
            ASSERT_TRUE(form.is_plain() && form.is_rational());
            for (const double t : {0.0, 0.1, 0.5, 0.7, 1.0}) {
                const Vector expected = piece.at(t).velocity;
                EXPECT_NEAR(form.velocity(t - 0.5).x, expected.x, 2e-12) << degree << ' ' << t;
                EXPECT_NEAR(form.velocity(t - 0.5).y, expected.y, 2e-12) << degree << ' ' << t;
            }
            const Interval part{-0.4, 0.3};
            const auto found = form.rules(part);
            const auto expected =
                integrate_once<double>([&](double s) { return length(piece.at(s + 0.5).velocity); }, part);
            EXPECT_NEAR(found.kronrod, expected.kronrod, 2e-13 * expected.kronrod);
            EXPECT_NEAR(found.gauss, expected.gauss, 2e-13 * expected.gauss);
        }
}

// A quarter of the unit circle about (1e6, -1e6).
TEST(SpeedForm, sees_a_rational_piece_from_near) {
    const double w = std::sqrt(0.5);
    const PieceMotion piece(
        {{0.0, 1.0}, 0, {{1e6 + 1.0, -1e6, 1.0}, {(1e6 + 1.0) * w, (1.0 - 1e6) * w, w}, {1e6, 1.0 - 1e6, 1.0}}});
    const SpeedForm form(piece);
    ASSERT_TRUE(form.is_plain());
    EXPECT_TRUE(form.goes_onward());
    // At both ends twice the weight of the middle point; in the middle 4 (sqrt 2 - 1), by the derivative of the angle.
    EXPECT_NEAR(form.velocity(-0.5).y, 2.0 * w, 1e-9);
    EXPECT_NEAR(form.velocity(0.5).x, -2.0 * w, 1e-9);
    EXPECT_NEAR(form.speed(0.0), 4.0 * (std::sqrt(2.0) - 1.0), 1e-9);
}

// The parabola (0, 0), (1, 0), (1, 1) turns by a right angle; the cubic (0, 0), (3, 0), (-2, 0), (1, 0) goes back on
// its way.
TEST(SpeedForm, tells_whether_a_piece_goes_onward) {
    EXPECT_TRUE(SpeedForm(PieceMotion({{0.0, 1.0}, 0, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}}})).goes_onward());
    EXPECT_FALSE(SpeedForm(PieceMotion({{0.0, 1.0}, 0, {{0, 0, 1}, {3, 0, 1}, {-2, 0, 1}, {1, 0, 1}}})).goes_onward());
}

TEST(SpeedForm, has_the_rules_of_integrate_once) {
    RandomCurves random(92);
    for (int degree = 1; degree <= 8; ++degree) {
        const PieceMotion piece = piece_of(random, degree);
        const Interval part{-0.4, 0.3};
        const auto found = SpeedForm(piece).rules(part);
        const auto expected =
            integrate_once<double>([&](double s) { return length(piece.at(s + 0.5).velocity); }, part);
        EXPECT_NEAR(found.kronrod, expected.kronrod, 1e-13 * expected.kronrod);
        EXPECT_NEAR(found.gauss, expected.gauss, 1e-13 * expected.gauss);
        EXPECT_EQ(found.interval, part);
    }
}

TEST(SpeedForm, is_not_for_high_degrees_unlike_weights_and_huge_numbers) {
    RandomCurves random(93);
    EXPECT_FALSE(SpeedForm(piece_of(random, 9)).is_plain());
    EXPECT_FALSE(SpeedForm(piece_of(random, 8, 2.0)).is_plain());
    EXPECT_FALSE(SpeedForm(piece_of(random, 3, 17.0)).is_plain());
    EXPECT_FALSE(SpeedForm(PieceMotion({{0.0, 1.0}, 0, {{0, 0, 1}, {1e200, 0, 1}}})).is_plain());
    EXPECT_FALSE(SpeedForm(PieceMotion({{0.0, 1.0}, 0, {{0, 0, 1}, {1e-200, 0, 1}}})).is_plain());
}

}  // namespace batten::core
