#include "core/make/fit_stroke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "core/evaluate/evaluate.h"
#include "core/measure/curvature.h"
#include "core/measure/nearest.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

struct StoredStroke {
    std::string name{};
    std::size_t corners = 0;
    std::size_t inflections = 0;
    bool is_closed = false;
    std::vector<Point> samples{};
    std::vector<Point> truth{};
};

std::vector<Point> points_of(const std::string& name) {
    std::ifstream file(std::string(BATTEN_STROKES) + "/" + name + ".csv");
    std::vector<Point> points;
    for (double x, y; file >> x && file.ignore(1) && file >> y;) points.emplace_back(x, y);
    return points;
}

std::vector<StoredStroke> stored_strokes() {
    std::ifstream file(std::string(BATTEN_STROKES) + "/strokes.csv");
    std::vector<StoredStroke> strokes;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::ranges::replace(line, ',', ' ');
        std::istringstream fields(line);
        StoredStroke stroke;
        fields >> stroke.name >> stroke.corners >> stroke.inflections >> stroke.is_closed;
        stroke.samples = points_of(stroke.name);
        stroke.truth = points_of(stroke.name + "_truth");
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

double distance_to(std::span<const Point> polyline, Point query) {
    double least = distance(query, polyline.front());
    for (std::size_t k = 1; k < polyline.size(); ++k) {
        const Vector leg = polyline[k] - polyline[k - 1];
        const double share = std::clamp(dot(query - polyline[k - 1], leg) / dot(leg, leg), 0.0, 1.0);
        least = std::min(least, distance(query, polyline[k - 1] + share * leg));
    }
    return least;
}

// Both ways: no part of one is far from the other.
double distance_between(const Curve& curve, std::span<const Point> truth) {
    const NearestFinder finder(curve);
    double largest = 0.0;
    for (const Point& point : truth) largest = std::max(largest, distance(point, finder.nearest(point).point));
    const Interval domain = curve.domain();
    for (int k = 0; k <= 1000; ++k)
        largest = std::max(largest, distance_to(truth, point_at(curve, domain.lower + domain.length() * k / 1000.0)));
    return largest;
}

std::size_t corners_of(const Curve& curve) {
    const auto knots = curve.knots().stored();
    const Interval domain = curve.domain();
    std::size_t count = 0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const bool is_first = i == 0 || knots[i - 1] != knots[i];
        const bool is_end = knots[i] == domain.upper || (!curve.is_periodic() && knots[i] == domain.lower);
        if (is_first && !is_end && curve.knots().multiplicity(knots[i]) == 3) ++count;
    }
    return count;
}

// Samples of an arc of 200 degrees, with noise.
std::vector<Point> noisy_arc(std::size_t count, double noise, double radius = 150.0) {
    RandomCurves random(5);
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double angle = 3.5 * static_cast<double>(k) / static_cast<double>(count - 1);
        points.emplace_back(radius * std::cos(angle) + random.number(-noise, noise),
                            radius * std::sin(angle) + random.number(-noise, noise));
    }
    return points;
}

}  // namespace

TEST(FitStroke, finds_what_a_hand_meant) {
    const auto strokes = stored_strokes();
    ASSERT_EQ(strokes.size(), 20U);
    for (const StoredStroke& stroke : strokes) {
        SCOPED_TRACE(stroke.name);
        const auto curve = fit_stroke(stroke.samples);
        ASSERT_TRUE(curve);
        EXPECT_LE(distance_between(*curve, stroke.truth), 1.8);
        EXPECT_LE(curve->control_points().size(), 60U);
        EXPECT_LE(inflections(*curve).size(), stroke.inflections + 3);
        EXPECT_EQ(corners_of(*curve), stroke.corners);
        EXPECT_EQ(curve->is_periodic(), stroke.is_closed);
        EXPECT_EQ(curve->degree(), 3);
        EXPECT_EQ(curve->domain(), (Interval{0.0, 1.0}));
    }
}

TEST(FitStroke, never_has_more_control_points_when_it_is_smoother) {
    for (const StoredStroke& stroke : stored_strokes()) {
        std::size_t last = 1000;
        for (int smoothness = least_smoothness; smoothness <= most_smoothness; ++smoothness) {
            const auto curve = fit_stroke(stroke.samples, {.smoothness = smoothness});
            ASSERT_TRUE(curve) << stroke.name;
            EXPECT_LE(curve->control_points().size(), last) << stroke.name << smoothness;
            last = curve->control_points().size();
        }
    }
}

TEST(FitStroke, is_nearer_to_the_samples_when_it_is_truer) {
    // A hand that means waves of two pixels' height.
    std::vector<Point> waves;
    for (int k = 0; k <= 300; ++k) waves.emplace_back(k, 2.0 * std::sin(0.14 * k));
    const auto error = [&](int smoothness) {
        return distance_between(fit_stroke(waves, {.smoothness = smoothness}).value(), waves);
    };
    EXPECT_LT(error(least_smoothness), 0.3);
    EXPECT_LT(error(usual_smoothness), 1.0);
    EXPECT_GT(error(most_smoothness), 1.2);
}

TEST(FitStroke, is_the_reversed_curve_for_the_reversed_stroke) {
    for (const StoredStroke& stroke : stored_strokes()) {
        const auto there = fit_stroke(stroke.samples);
        std::vector<Point> samples = stroke.samples;
        std::ranges::reverse(samples);
        const auto back = fit_stroke(samples);
        ASSERT_TRUE(there && back);
        ASSERT_EQ(there->control_points().size(), back->control_points().size());
        for (const double u : {0.0, 0.1, 0.37, 0.5, 0.93})
            EXPECT_LT(distance(point_at(*there, u), point_at(*back, 1.0 - u)), 1e-9) << stroke.name;
        if (there->is_periodic()) continue;
        EXPECT_TRUE(std::ranges::equal(there->control_points(), std::vector<Point>(back->control_points().rbegin(),
                                                                                   back->control_points().rend())));
    }
}

TEST(FitStroke, does_not_depend_on_place_and_size) {
    const std::vector<Point> samples = noisy_arc(200, 0.7);
    const Curve curve = fit_stroke(samples).value();
    for (const double scale : {0x1p-30, 0x1p40}) {
        std::vector<Point> scaled = samples;
        for (Point& point : scaled) point = tip_of(scale * vector_to(point));
        const Curve other = fit_stroke(scaled, {.pixel = scale}).value();
        ASSERT_EQ(other.knots(), curve.knots());
        EXPECT_LT(distance(tip_of(vector_to(point_at(other, 0.3)) / scale), point_at(curve, 0.3)), 1e-9);
    }
    std::vector<Point> far = samples;
    for (Point& point : far) point += Vector{1e6, -1e6};
    EXPECT_LT(distance(point_at(fit_stroke(far).value(), 0.6), point_at(curve, 0.6) + Vector{1e6, -1e6}), 1e-3);
}

TEST(FitStroke, keeps_a_corner_and_rounds_a_round_one) {
    std::vector<Point> sharp;
    for (int k = 0; k <= 80; ++k) sharp.emplace_back(k, 0);
    for (int k = 1; k <= 80; ++k) sharp.emplace_back(80, k);
    const Curve corner = fit_stroke(sharp).value();
    EXPECT_EQ(corners_of(corner), 1U);
    EXPECT_LT(distance(nearest_point(corner, {80, 0}).point, {80, 0}), 0.5);
    std::vector<Point> round;
    for (int k = 0; k <= 70; ++k) round.emplace_back(k, 0);
    for (int k = 1; k < 16; ++k)
        round.emplace_back(70 + 10 * std::sin(k * std::numbers::pi / 32),
                           10 - 10 * std::cos(k * std::numbers::pi / 32));
    for (int k = 10; k <= 80; ++k) round.emplace_back(80, k);
    EXPECT_EQ(corners_of(fit_stroke(round).value()), 0U);
}

TEST(FitStroke, makes_straight_what_is_straight) {
    std::vector<Point> line;
    for (int k = 0; k <= 100; ++k) line.emplace_back(3.0 * k, std::round(1.2 * k));
    const Curve curve = fit_stroke(line).value();
    EXPECT_EQ(curve.control_points().size(), 4U);
    EXPECT_LT(distance_between(curve, std::vector<Point>{{0, 0}, {300, 120}}), 0.6);
}

TEST(FitStroke, takes_few_repeated_and_far_samples) {
    const Curve two = fit_stroke(std::vector<Point>{{0, 0}, {0, 0}, {100, 50}, {100, 50}}).value();
    EXPECT_LT(distance_between(two, std::vector<Point>{{0, 0}, {100, 50}}), 1e-3);
    const Curve three = fit_stroke(std::vector<Point>{{0, 0}, {50, 10}, {100, 0}}).value();
    EXPECT_LT(distance(nearest_point(three, {50, 10}).point, {50, 10}), 1.0);
    const auto apart = fit_stroke(std::vector<Point>{{0, 0}, {1e7, 1e6}, {2e7, 0}, {3e7, 1e6}});
    ASSERT_TRUE(apart);
    EXPECT_LE(apart->control_points().size(), 20U);
    EXPECT_EQ(fit_stroke(std::vector<Point>{{-1e300, 0}, {1e300, 5}}).error().code, CurveErrorCode::not_computable);
}

TEST(FitStroke, takes_very_many_samples) {
    const auto curve = fit_stroke(noisy_arc(100000, 0.7, 2000.0));
    ASSERT_TRUE(curve);
    EXPECT_LE(curve->control_points().size(), 60U);
    EXPECT_NEAR(distance(point_at(*curve, 0.5), {0, 0}), 2000.0, 1.0);
}

TEST(FitStroke, ignores_a_rest_of_the_pen) {
    std::vector<Point> samples = noisy_arc(150, 0.7);
    RandomCurves random(9);
    const Point rest = samples[70];
    for (int k = 0; k < 500; ++k)
        samples.insert(samples.begin() + 71, rest + Vector{random.number(-1, 1), random.number(-1, 1)});
    const Curve curve = fit_stroke(samples).value();
    EXPECT_LE(inflections(curve).size(), 2U);
    for (int k = 0; k <= 100; ++k) EXPECT_NEAR(distance(point_at(curve, k / 100.0), {0, 0}), 150.0, 1.5);
}

TEST(SmoothLine, ends_at_the_pen_and_goes_on_from_part_to_part) {
    const std::vector<Point> samples = noisy_arc(400, 0.7);
    for (const std::size_t count : {5UL, 50UL, 399UL}) {
        const auto line = smooth_line(std::span(samples).first(count), 1.0, 0, count - 1);
        ASSERT_FALSE(line.empty());
        EXPECT_EQ(line.back(), samples[count - 1]);
        EXPECT_LT(distance(line.front(), samples.front()), 3.0);
    }
    const auto before = smooth_line(samples, 1.0, 0, 200);
    const auto behind = smooth_line(std::span(samples).subspan(100), 1.0, 100, 299);
    EXPECT_LT(distance(before.back(), behind.front()), 2.0);
    EXPECT_LT(distance(before.back(), samples[200]), 3.0);
    for (const Point& point : before) EXPECT_NEAR(distance(point, {0, 0}), 150.0, 1.2);
    EXPECT_TRUE(smooth_line(std::vector<Point>{{1, 1}, {1, 1.5}}, 1.0, 0, 1).empty());
}

TEST(FitStroke, refuses_in_a_written_order) {
    using Code = CurveErrorCode;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refusal = [](std::vector<Point> points, double pixel = 1.0) {
        return fit_stroke(points, {.pixel = pixel}).error();
    };
    EXPECT_EQ(refusal({}, nan).code, Code::data_points_too_few);
    EXPECT_EQ(refusal({{1, 1}, {nan, 1}}, nan).code, Code::data_point_not_finite);
    EXPECT_EQ(refusal({{1, 1}, {nan, 1}}).index, 1U);
    EXPECT_EQ(refusal({{1, 1}}, nan).code, Code::length_not_positive);
    EXPECT_EQ(refusal({{1, 1}}, -1.0).code, Code::length_not_positive);
    EXPECT_EQ(refusal({{1, 1}}).code, Code::stroke_too_short);
    EXPECT_EQ(describe(refusal({{1, 1}, {2, 1.5}})),
              "the stroke is too short: it extends over 1 px and must extend over at least 2");
}

}  // namespace batten::core
