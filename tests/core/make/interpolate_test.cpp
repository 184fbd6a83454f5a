#include "core/make/interpolate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

std::vector<Point> random_points(RandomCurves& random, std::size_t count) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = random.number(-8.0, 8.0);
        points.emplace_back(x, random.number(-8.0, 8.0));
    }
    return points;
}

// A walk without reversals, so that all curves through it are tame.
std::vector<Point> spiral(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double t = static_cast<double>(k) + 0.3 * std::sin(static_cast<double>(k * k));
        points.emplace_back((10.0 + 0.1 * t) * std::cos(0.05 * t), (10.0 + 0.1 * t) * std::sin(0.05 * t));
    }
    return points;
}

double largest_miss(const Interpolation& result, std::span<const Point> points) {
    double largest = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k)
        largest = std::max(largest, distance(point_at(result.curve, result.parameters[k]), points[k]));
    return largest;
}

double largest_difference(std::span<const Point> a, std::span<const Point> b) {
    double largest = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, distance(a[i], b[i]));
    return largest;
}

InterpolationRequest with(int degree, Ends ends = FreeEnds{}, Parametrization way = Parametrization::chordal) {
    return {degree, way, std::move(ends), {}};
}

}  // namespace

TEST(Parametrize, divides_the_domain_as_the_points_lie) {
    const Point points[] = {{0, 0}, {3, 4}, {3, 13}};  // chords 5 and 9
    EXPECT_EQ(parametrize(points, Parametrization::uniform).value(), (std::vector{0.0, 0.5, 1.0}));
    EXPECT_EQ(parametrize(points, Parametrization::chordal).value(), (std::vector{0.0, 5.0 / 14.0, 1.0}));
    const double roots = std::sqrt(5.0) + 3.0;
    EXPECT_DOUBLE_EQ(parametrize(points, Parametrization::centripetal).value()[1], std::sqrt(5.0) / roots);
    const Point square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_EQ(parametrize(square, Parametrization::chordal, true).value(), (std::vector{0.0, 0.25, 0.5, 0.75, 1.0}));
}

// sqrt(2) / (2 sqrt(2) + sqrt(5)) and twice that, rounded once; of rounded chords one would get others.
TEST(Parametrize, is_right_to_the_last_bit) {
    const Point points[] = {{0, 1}, {1, 0}, {2, 1}, {3, 3}};
    EXPECT_EQ(parametrize(points, Parametrization::chordal).value(),
              (std::vector{0.0, 0.27924077994387353, 0.5584815598877471, 1.0}));
}

// In more digits than doubles have.
std::vector<double> shares_by_long_double(std::span<const Point> points, bool is_centripetal, bool is_closed) {
    std::vector<long double> sums{0.0L};
    for (std::size_t k = 1; k < points.size() + (is_closed ? 1 : 0); ++k) {
        const Point from = points[k - 1];
        const Point to = points[k % points.size()];
        const long double chord =
            std::hypot(static_cast<long double>(to.x) - from.x, static_cast<long double>(to.y) - from.y);
        sums.push_back(sums.back() + (is_centripetal ? std::sqrt(chord) : chord));
    }
    std::vector<double> shares;
    for (const long double sum : sums) shares.push_back(static_cast<double>(sum / sums.back()));
    return shares;
}

TEST(Parametrize, agrees_with_sums_of_more_digits) {
    RandomCurves random(71);
    for (const std::size_t count : {3U, 128U, 129U, 1000U})
        for (const double scale : {1e-130, 1e-8, 1.0, 1e80, 1e120})
            for (const bool is_centripetal : {false, true})
                for (const bool is_closed : {false, true}) {
                    std::vector<Point> points;
                    for (std::size_t k = 0; k < count; ++k) {
                        const double x = random.number(-8.0, 8.0);
                        points.emplace_back(scale * x, scale * random.number(-8.0, 8.0));
                    }
                    const auto kind = is_centripetal ? Parametrization::centripetal : Parametrization::chordal;
                    const auto found = parametrize(points, kind, is_closed).value();
                    const auto expected = shares_by_long_double(points, is_centripetal, is_closed);
                    ASSERT_EQ(found.size(), expected.size());
                    for (std::size_t k = 0; k < found.size(); ++k)
                        EXPECT_NEAR(found[k], expected[k], 2.3e-16 * expected[k]) << count << ' ' << scale << ' ' << k;
                }
}

TEST(Parametrize, refuses_points_that_cannot_be_told_apart_and_names_them) {
    const Point repeated[] = {{0, 0}, {1, 0}, {1, 0}, {2, 0}};
    const auto error = parametrize(repeated, Parametrization::centripetal).error();
    EXPECT_EQ(describe(error), "point 2 lies on point 1; the two must differ");
    EXPECT_EQ(parametrize(repeated, Parametrization::uniform).value()[2], 2.0 / 3.0);
    const Point one_place[] = {{1, 1}, {1, 1}, {1, 1}};
    EXPECT_EQ(parametrize(one_place, Parametrization::chordal).error().code, CurveErrorCode::points_coincide);
    const Point meeting[] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
    EXPECT_EQ(describe(parametrize(meeting, Parametrization::chordal, true).error()),
              "point 0 lies on point 3; the two must differ");
    const Point nearly[] = {{0, 0}, {1e-30, 0}, {1, 0}, {1 + 1e-30, 0}};
    EXPECT_EQ(parametrize(nearly, Parametrization::chordal).error().index, 3U);
    const Point undefined[] = {{0, 0}, {1, NAN}};
    EXPECT_EQ(parametrize(undefined, Parametrization::chordal).error(),
              (CurveError{.code = CurveErrorCode::data_point_not_finite, .index = 1}));
}

TEST(AveragedKnots, are_the_means_of_p_parameters) {
    const double sites[] = {0, 1, 2, 6, 7, 10};
    EXPECT_EQ(averaged_knots(sites, 3), (std::vector<double>{0, 0, 0, 0, 3, 5, 10, 10, 10, 10}));
    EXPECT_EQ(averaged_knots(sites, 1), (std::vector<double>{0, 0, 1, 2, 6, 7, 10, 10}));
}

TEST(Interpolate, passes_the_points_at_every_degree) {
    RandomCurves random(71);
    for (int degree = 1; degree <= max_degree; ++degree)
        for (const auto way : {Parametrization::uniform, Parametrization::chordal, Parametrization::centripetal}) {
            const auto points = random_points(random, static_cast<std::size_t>(degree + random.whole(1, 12)));
            const auto result = interpolate(points, with(degree, FreeEnds{}, way)).value();
            EXPECT_EQ(result.curve.control_points().size(), points.size());
            EXPECT_EQ(result.curve.degree(), degree);
            EXPECT_EQ(result.curve.control_points().front(), points.front());
            EXPECT_EQ(result.curve.control_points().back(), points.back());
            double size = 0.0;
            for (const Point& point : result.curve.control_points()) size = std::max(size, distance(point, {}));
            EXPECT_LT(largest_miss(result, points), 1e-14 * size) << degree;
        }
}

TEST(Interpolate, a_polyline_passes_its_points_exactly) {
    const Point points[] = {{0, 0}, {3, 4}, {7, 1}, {8, 8}};
    const auto result = interpolate(points, with(1)).value();
    EXPECT_TRUE(std::ranges::equal(result.curve.control_points(), points));
}

// The points of a polynomial curve at given parameters lead back to this curve.
TEST(Interpolate, reproduces_a_polynomial) {
    const auto cubic = [](double t) { return Point(t * t * t - 2 * t, 4 * t * t + t); };
    std::vector<Point> points;
    std::vector<double> parameters;
    for (const double t : {-1.0, -0.25, 0.5, 1.0, 2.0, 3.0, 3.5}) {
        parameters.push_back(t);
        points.push_back(cubic(t));
    }
    const auto result = interpolate(points, {3, {}, FreeEnds{}, parameters}).value();
    EXPECT_EQ(result.curve.domain(), (Interval{-1.0, 3.5}));
    for (const double t : {-0.9, 0.0, 1.7, 3.2}) EXPECT_LT(distance(point_at(result.curve, t), cubic(t)), 1e-13);
    // With both tangents the quadratic part comes back too, from fewer points.
    const EndTangents tangents{Vector(1, -7), Vector(34.75, 29)};
    const auto hermite =
        interpolate(std::vector{points.front(), points.back()}, {3, {}, tangents, {-1.0, 3.5}}).value();
    for (const double t : {-0.9, 0.0, 1.7, 3.2}) EXPECT_LT(distance(point_at(hermite.curve, t), cubic(t)), 1e-13);
}

TEST(Interpolate, keeps_end_tangents_of_either_end) {
    RandomCurves random(72);
    for (int degree = 2; degree <= 9; ++degree) {
        const auto points = random_points(random, static_cast<std::size_t>(degree + 5));
        const Vector start(3, -7);
        const Vector end(-11, 2);
        for (const EndTangents& tangents : {EndTangents{start, end}, EndTangents{start, {}}, EndTangents{{}, end}}) {
            const auto result = interpolate(points, with(degree, tangents)).value();
            EXPECT_LT(largest_miss(result, points), 1e-11);
            const std::size_t added = (tangents.start ? 1U : 0U) + (tangents.end ? 1U : 0U);
            EXPECT_EQ(result.curve.control_points().size(), points.size() + added);
            const double at_start = length(derivatives_at(result.curve, 0.0, 1)[1] - start);
            const double at_end = length(derivatives_at(result.curve, 1.0, 1)[1] - end);
            EXPECT_EQ(at_start < 1e-11, tangents.start.has_value()) << degree;
            EXPECT_EQ(at_end < 1e-11, tangents.end.has_value()) << degree;
        }
    }
}

TEST(Interpolate, natural_ends_have_no_second_derivative) {
    RandomCurves random(73);
    for (int degree = 3; degree <= 9; ++degree) {
        const auto points = random_points(random, static_cast<std::size_t>(degree + 4));
        const auto result = interpolate(points, with(degree, NaturalEnds{})).value();
        EXPECT_LT(largest_miss(result, points), 1e-12);
        EXPECT_EQ(result.curve.control_points().size(), points.size() + 2);
        const double scale = length(derivatives_at(result.curve, 0.4, 2)[2]);
        EXPECT_LT(length(derivatives_at(result.curve, 0.0, 2)[2]), 1e-11 * scale) << degree;
        EXPECT_LT(length(derivatives_at(result.curve, 1.0, 2)[2]), 1e-11 * scale) << degree;
    }
    EXPECT_EQ(describe(interpolate(random_points(random, 8), with(2, NaturalEnds{})).error()),
              "the degree is 2; it must be at least 3 here");
}

// The natural cubic spline through (0, 0), (1, 1), (2, 0) has the second derivatives 0, -3, 0.
TEST(Interpolate, natural_cubic_of_three_points_is_the_one_of_the_textbooks) {
    const Point points[] = {{0, 0}, {1, 1}, {2, 0}};
    const auto result = interpolate(points, {3, {}, NaturalEnds{}, {0.0, 1.0, 2.0}}).value();
    EXPECT_NEAR(derivatives_at(result.curve, 1.0, 2)[2].y, -3.0, 1e-14);
    EXPECT_NEAR(point_at(result.curve, 0.5).y, 0.5 + 0.1875, 1e-15);
    EXPECT_NEAR(point_at(result.curve, 0.5).x, 0.5, 1e-15);
}

TEST(Interpolate, closed_curves_pass_the_points_at_every_degree) {
    RandomCurves random(74);
    for (int degree = 1; degree <= max_degree; ++degree)
        for (const std::size_t count : {3U, 4U, 5U, 8U, 15U, 30U}) {
            const auto points = random_points(random, count);
            const auto result = interpolate(points, with(degree, ClosedEnds{}, Parametrization::uniform)).value();
            EXPECT_TRUE(result.curve.is_periodic());
            EXPECT_EQ(result.curve.control_points().size(), count);
            double size = 0.0;
            for (const Point& point : result.curve.control_points()) size = std::max(size, distance(point, {}));
            EXPECT_LT(largest_miss(result, points), 1e-14 * size) << degree << " " << count;
        }
}

TEST(Interpolate, closed_curves_of_uneven_steps_pass_the_points) {
    RandomCurves random(75);
    for (int degree = 1; degree <= 12; ++degree)
        for (int trial = 0; trial < 20; ++trial) {
            const auto points = random_points(random, static_cast<std::size_t>(random.whole(3, 14)));
            const auto result = interpolate(points, with(degree, ClosedEnds{}, Parametrization::centripetal));
            ASSERT_TRUE(result) << degree << ' ' << points.size();
            double size = 0.0;
            for (const Point& point : result->curve.control_points()) size = std::max(size, distance(point, {}));
            EXPECT_LT(largest_miss(*result, points), 1e-13 * size) << degree << ' ' << points.size();
        }
}

TEST(Interpolate, rotating_the_points_of_a_closed_curve_keeps_it) {
    RandomCurves random(76);
    for (const int degree : {2, 3, 4, 5}) {
        const auto points = random_points(random, 9);
        auto rotated = points;
        std::rotate(rotated.begin(), rotated.begin() + 4, rotated.end());
        const auto a = interpolate(points, with(degree, ClosedEnds{})).value();
        const auto b = interpolate(rotated, with(degree, ClosedEnds{})).value();
        for (double u = 0.0; u < 1.0; u += 1.0 / 64) {
            const Point on_a = point_at(a.curve, a.parameters[4] + u);
            EXPECT_LT(distance(on_a, point_at(b.curve, b.parameters[0] + u)), 1e-11) << degree << ' ' << u;
        }
    }
}

TEST(Interpolate, the_reversed_points_give_the_reversed_curve) {
    RandomCurves random(77);
    for (int degree = 1; degree <= 8; ++degree) {
        const auto points = random_points(random, 14);
        const std::vector<Point> reversed(points.rbegin(), points.rend());
        const auto a = interpolate(points, with(degree)).value();
        const auto b = interpolate(reversed, with(degree)).value();
        const auto back = b.curve.control_points();
        EXPECT_LT(largest_difference(a.curve.control_points(), std::vector<Point>(back.rbegin(), back.rend())), 1e-8);
        const auto knots = a.curve.knots().values();
        for (std::size_t i = 0; i < knots.size(); ++i)
            EXPECT_NEAR(knots[i], 1.0 - b.curve.knots()[knots.size() - 1 - i], 1e-15);
    }
}

TEST(Interpolate, is_as_exact_far_from_the_origin) {
    RandomCurves random(78);
    auto points = random_points(random, 20);
    for (Point& point : points) point = Point(std::round(point.x * 1024) / 1024, std::round(point.y * 1024) / 1024);
    auto far = points;
    const Vector offset(1048576.0, -1048576.0);
    for (Point& point : far) point += offset;
    for (const Ends& ends : {Ends(FreeEnds{}), Ends(NaturalEnds{}), Ends(ClosedEnds{})}) {
        const auto near_curve = interpolate(points, with(3, ends)).value().curve;
        const auto far_curve = interpolate(far, with(3, ends)).value().curve;
        for (std::size_t i = 0; i < near_curve.control_points().size(); ++i)
            EXPECT_LT(distance(near_curve.control_points()[i] + offset, far_curve.control_points()[i]), 3e-10);
    }
}

TEST(Interpolate, takes_parameters_of_any_size) {
    RandomCurves random(79);
    const auto points = random_points(random, 9);
    for (const double scale : {1e-9, 1.0, 1e9}) {
        std::vector<double> parameters;
        for (int k = 0; k < 10; ++k) parameters.push_back(scale * (k + 0.25 * (k % 3)));
        auto open = parameters;
        open.pop_back();
        for (const Ends& ends : {Ends(FreeEnds{}), Ends(NaturalEnds{})})
            EXPECT_LT(largest_miss(interpolate(points, {4, {}, ends, open}).value(), points), 1e-12);
        EXPECT_LT(largest_miss(interpolate(points, {4, {}, ClosedEnds{}, parameters}).value(), points), 1e-12);
        EXPECT_EQ(interpolate(points, {4, {}, FreeEnds{}, open}).value().curve.domain().upper, open.back());
    }
    EXPECT_EQ(describe(interpolate(points, {3, {}, FreeEnds{}, {0, 1, 2}}).error()),
              "3 parameters were found; 9 are needed, one for each point, and one more for the way back to the first "
              "point of a closed curve");
    EXPECT_EQ(interpolate(points, {3, {}, FreeEnds{}, {0, 1, 2, 3, 3, 4, 5, 6, 7}}).error(),
              (CurveError{.code = CurveErrorCode::parameters_not_increasing, .index = 4}));
}

TEST(Interpolate, refuses_too_few_points) {
    const Point points[] = {{0, 0}, {1, 1}, {2, 0}};
    EXPECT_EQ(describe(interpolate(points, with(3)).error()), "3 points were found; at least 4 are needed");
    EXPECT_TRUE(interpolate(points, with(3, EndTangents{Vector(1, 0), {}})));
    EXPECT_EQ(interpolate(std::span(points, 1), with(3, NaturalEnds{})).error(),
              (CurveError{.code = CurveErrorCode::data_points_too_few, .value = 1, .lower = 2}));
    EXPECT_EQ(interpolate(std::span(points, 2), with(3, ClosedEnds{})).error(),
              (CurveError{.code = CurveErrorCode::data_points_too_few, .value = 2, .lower = 3}));
    EXPECT_EQ(interpolate(points, with(26)).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_EQ(interpolate(points, with(3, EndTangents{Vector(1, NAN), {}})).error().code,
              CurveErrorCode::vector_not_finite);
}

TEST(Interpolate, needs_no_more_work_for_each_of_many_points) {
    for (const Ends& ends : {Ends(FreeEnds{}), Ends(ClosedEnds{})}) {
        const auto points = spiral(100000);
        const auto result = interpolate(points, with(3, ends)).value();
        EXPECT_LT(largest_miss(result, points), 1e-10);
    }
}

}  // namespace batten::core
