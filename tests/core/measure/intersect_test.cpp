#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/measure/intersect_curves.h"
#include "core/measure/intersect_line.h"
#include "core/refine/degree.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

Curve reversed(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    std::reverse(definition.points.begin(), definition.points.end());
    std::reverse(definition.weights.begin(), definition.weights.end());
    std::reverse(definition.knots.begin(), definition.knots.end());
    for (double& knot : definition.knots) knot = -knot;
    return Curve::make(std::move(definition)).value();
}

// (t^2, t^3 - t) for t from -3/2 to 3/2 has its double point at t = -1 and 1, u = 1/6 and 5/6.
Curve loop() {
    return bezier({{2.25, -1.875}, {-0.75, 3.875}, {-0.75, -3.875}, {2.25, 1.875}});
}

// Crossings of two polylines that follow the curves, each once.
std::size_t polyline_crossings(const std::vector<Point>& a, const std::vector<Point>& b) {
    const auto side = [](Point p, Point q, Point r) { return cross(q - p, r - p); };
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
        for (std::size_t j = 0; j + 1 < b.size(); ++j)
            if (side(a[i], a[i + 1], b[j]) * side(a[i], a[i + 1], b[j + 1]) < 0 &&
                side(b[j], b[j + 1], a[i]) * side(b[j], b[j + 1], a[i + 1]) < 0)
                ++count;
    return count;
}

// `count` points in every span, corners among them.
std::vector<Point> samples_of(const Curve& curve, int count) {
    const auto knots = curve.knots().values();
    std::vector<Point> points{point_at(curve, curve.domain().lower)};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        if (knots[i] < curve.domain().lower || knots[i + 1] > curve.domain().upper || knots[i] == knots[i + 1])
            continue;
        for (int k = 1; k <= count; ++k)
            points.push_back(point_at(curve, knots[i] + (knots[i + 1] - knots[i]) * k / count,
                                      k == count ? Side::left : Side::right));
    }
    return points;
}

TEST(Intersect, progress_is_told_and_may_stop_it) {
    RandomCurves random(205);
    const Curve a = random.curve();
    const Curve b = random.curve();
    struct Stopped {};
    const auto stop = [](double) { throw Stopped{}; };
    EXPECT_THROW(static_cast<void>(intersect_curves(a, b, stop)), Stopped);
    EXPECT_THROW(static_cast<void>(self_intersections(a, stop)), Stopped);
    std::vector<double> shares;
    static_cast<void>(intersect_curves(a, b, [&](double share) { shares.push_back(share); }));
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.front(), 0.0);
}

TEST(IntersectLine, circle_crossed_touched_and_missed) {
    for (const Vector offset : {Vector(0, 0), Vector(1e6, -3e6)}) {
        const Curve circle = moved(ellipse(1, 1), offset);
        const double rounding = offset.x == 0 ? 1e-14 : 1e-8;
        const auto two = intersect_line(circle, Point(-2, 0.6) + offset, Point(3, 0.6) + offset).value();
        ASSERT_EQ(two.contacts.size(), 2U);
        EXPECT_EQ(two.crossings, 2U);
        EXPECT_NEAR(two.contacts[0].point.x - offset.x, 0.8, rounding);
        EXPECT_NEAR(two.contacts[1].point.x - offset.x, -0.8, rounding);
        EXPECT_NEAR(two.contacts[0].along, 2.8 / 5, rounding);
        EXPECT_EQ(two.contacts[0].kind, ContactKind::crossing);
        const auto one = intersect_line(circle, Point(-2, 1) + offset, Point(3, 1) + offset).value();
        ASSERT_EQ(one.contacts.size(), 1U);
        EXPECT_EQ(one.contacts[0].kind, ContactKind::touching);
        EXPECT_NEAR(one.contacts[0].u, 0.25, 1e-9);
        EXPECT_EQ(one.crossings, 0U);
        EXPECT_TRUE(intersect_line(circle, Point(-2, 1.01) + offset, Point(3, 1.01) + offset)->contacts.empty());
    }
    // An oblique tangent at 45 degrees, in the middle of a piece.
    const double root = std::sqrt(2.0);
    const auto oblique = intersect_line(ellipse(1, 1), {root, 0}, {0, root}).value();
    ASSERT_EQ(oblique.contacts.size(), 1U);
    EXPECT_EQ(oblique.contacts[0].kind, ContactKind::touching);
    EXPECT_NEAR(oblique.contacts[0].u, 0.125, 1e-12);
}

TEST(IntersectLine, at_a_joint_once_and_at_the_closing_point_once) {
    const auto found = intersect_line(ellipse(1, 1), {-1, -1}, {1, 1}).value();
    EXPECT_EQ(found.crossings, 2U);
    const auto axis = intersect_line(ellipse(1, 1), {0, 0}, {1, 0}).value();
    ASSERT_EQ(axis.contacts.size(), 2U);
    EXPECT_EQ(axis.contacts[0].u, 0.0);
    EXPECT_EQ(axis.contacts[0].kind, ContactKind::crossing);
    EXPECT_EQ(axis.contacts[1].u, 0.5);
    EXPECT_EQ(axis.crossings, 2U);
    EXPECT_EQ(axis.polygon_crossings, 2U);
    const auto corner = intersect_line(polygon({{0, 0}, {1, 1}, {2, 0}}), {0, 1}, {1, 1}).value();
    ASSERT_EQ(corner.contacts.size(), 1U);
    EXPECT_EQ(corner.contacts[0].kind, ContactKind::touching);
    EXPECT_EQ(corner.contacts[0].u, 1.0);
}

TEST(IntersectLine, multiple_contacts_of_a_cubic_graph) {
    // y = x^3 for x from -1 to 2 touches its tangent at the inflection and crosses it.
    const Curve cubic = bezier({{-1, -1}, {0, 2}, {1, -4}, {2, 8}});
    const auto flat = intersect_line(cubic, {0, 0}, {1, 0}).value();
    ASSERT_EQ(flat.contacts.size(), 1U);
    EXPECT_EQ(flat.contacts[0].kind, ContactKind::crossing);
    EXPECT_NEAR(flat.contacts[0].u, 1.0 / 3.0, 1e-12);
    const auto three = intersect_line(cubic, {-1, -0.25}, {1, 0.25}).value();
    ASSERT_EQ(three.contacts.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(three.contacts[k].point.x, 0.5 * (static_cast<double>(k) - 1.0), 1e-15);
    EXPECT_EQ(three.polygon_crossings, 3U);
}

TEST(IntersectLine, piece_in_the_line_is_an_interval) {
    const Curve hook = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                    .points = {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 4}, {1, 5}, {2, 5}}})
                           .value();
    const auto found = intersect_line(hook, {1, 0}, {1, 10}).value();
    ASSERT_EQ(found.contacts.size(), 1U);
    EXPECT_EQ(found.contacts[0].where, (Interval{1, 2}));
    EXPECT_EQ(found.contacts[0].kind, ContactKind::crossing);
    const Curve square =
        Curve::make(
            {.degree = 1, .knots = {0, 1, 2, 3, 4}, .points = {{1, 1}, {0, 1}, {0, 0}, {1, 0}}, .periodic = true})
            .value();
    const auto side = intersect_line(square, {0, 0}, {0, 1}).value();
    ASSERT_EQ(side.contacts.size(), 1U);
    EXPECT_EQ(side.contacts[0].where.length(), 1.0);
    EXPECT_EQ(side.contacts[0].kind, ContactKind::touching);
}

TEST(IntersectLine, gaps_are_no_contacts_and_a_line_needs_two_points) {
    const Curve torn = Curve::make({.degree = 1,
                                    .knots = {0, 0, 1, 1, 2, 2},
                                    .points = {{0, -1}, {1, -1}, {1, 3}, {2, 3}},
                                    .tears = Tears::allow})
                           .value();
    EXPECT_TRUE(intersect_line(torn, {0, 0}, {1, 0})->contacts.empty());
    EXPECT_EQ(intersect_line(torn, {1, 1}, {1, 1}).error().code, CurveErrorCode::points_coincide);
}

// Over 10^9 seconds a parameter is no better than 10^-7 of them: the point at it is off the line, but not by a gap.
TEST(IntersectLine, far_domains_lose_no_contact) {
    const auto line = [](double begin, double length) {
        return Curve::make(
                   {.degree = 1, .knots = {begin, begin, begin + length, begin + length}, .points = {{0, 0}, {3, 1}}})
            .value();
    };
    for (const auto& [begin, length] : {std::pair(1e9, 1000.0), {1e6, 1.0}, {-1e6, 1.0}, {1e15, 7.0}}) {
        const auto found = intersect_line(line(begin, length), {0, 1}, {1, 0}).value();
        ASSERT_EQ(found.contacts.size(), 1U) << begin;
        EXPECT_EQ(found.contacts[0].kind, ContactKind::crossing);
        EXPECT_EQ(found.crossings, 1U);
        // x + y = 1 at (3/4, 1/4), a quarter of the way.
        EXPECT_NEAR(found.contacts[0].u, begin + 0.25 * length, 4e-16 * std::abs(begin));
        EXPECT_EQ(intersect_segment(line(begin, length), {0, 1}, {1, 0})->contacts.size(), 1U);
    }
}

// C(u).y is 1 - u less w u over positive weights, and the line y = 0 is passed where u = 1 / (1 + w).
TEST(IntersectLine, extreme_weights_lose_no_crossing) {
    for (const double w : {1e-300, 1e-200, 1.0, 1e100, 1e200, 1e300}) {
        const Curve curve =
            Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 1}, {0, -1}}, .weights = {1.0, w}}).value();
        const LineContacts found = intersect_line(curve, {-1, 0}, {1, 0}).value();
        ASSERT_EQ(found.contacts.size(), 1U) << w;
        EXPECT_EQ(found.crossings, 1U) << w;
        EXPECT_NEAR(found.contacts[0].u, 1.0 / (1.0 + w), 1e-15) << w;
    }
}

TEST(IntersectLine, never_more_crossings_than_the_polygon_and_as_many_as_samples_show) {
    RandomCurves random(341);
    for (int i = 0; i < 300; ++i) {
        CurveDefinition definition = random.curve().definition();
        if (i % 3 == 0)
            for (Point& point : definition.points) point += Vector(1e6, 1e6);
        const Curve curve = Curve::make(definition).value();
        const Vector offset = i % 3 == 0 ? Vector(1e6, 1e6) : Vector(0, 0);
        const double x = random.number(-4, 4);
        const double y = random.number(-4, 4);
        const Point a = Point(x, random.number(-4, 4)) + offset;
        const Point b = a + Vector(random.number(0.1, 3), y);
        const auto found = intersect_line(curve, a, b).value();
        EXPECT_LE(found.crossings, found.polygon_crossings) << i;
        const auto side = [&](Point p) { return cross(b - a, p - a); };
        for (const LineContact& contact : found.contacts) {
            EXPECT_LE(std::abs(side(contact.point)), i % 3 == 0 ? 1e-7 : 1e-12) << i;
            EXPECT_NEAR(distance(a + contact.along * (b - a), contact.point), 0.0, i % 3 == 0 ? 1e-7 : 1e-12);
        }
        std::size_t sampled = 0;
        const auto points = samples_of(curve, 500);
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            if (side(points[k]) * side(points[k + 1]) < 0) ++sampled;
        EXPECT_EQ(found.crossings, sampled) << i;
    }
}

// By hand: one corner in the line between different sides counts once, one between equal sides not, and a leg in the
// line counts at its middle.
TEST(IntersectLine, corners_and_legs_of_the_polygon_in_the_line) {
    const Curve curve =
        polygon({{0, 1}, {1, 0}, {2, -1}, {3, 0}, {4, -2}, {5, 0}, {7, 0}, {8, 1}, {9, 0}, {10, 0}, {11, 3}, {12, -1}});
    const LineContacts found = intersect_line(curve, {0, 0}, {2, 0}).value();
    ASSERT_EQ(found.on_polygon.size(), 3U);
    EXPECT_EQ(found.polygon_crossings, 3U);
    EXPECT_EQ(found.on_polygon[0].leg, 0U);
    EXPECT_EQ(found.on_polygon[0].point, Point(1, 0));
    EXPECT_EQ(found.on_polygon[0].along, 0.5);
    EXPECT_EQ(found.on_polygon[1].leg, 4U);
    EXPECT_EQ(found.on_polygon[1].point, Point(6, 0));
    EXPECT_EQ(found.on_polygon[2].leg, 10U);
    EXPECT_EQ(found.on_polygon[2].point, Point(11.75, 0));
    EXPECT_EQ(found.crossings, 3U);  // a polygon is its own curve
    // All in the line, and all but the ends.
    EXPECT_TRUE(intersect_line(polygon({{0, 0}, {1, 0}, {2, 0}}), {0, 0}, {1, 0})->on_polygon.empty());
    EXPECT_TRUE(intersect_line(polygon({{0, 1}, {1, 0}, {2, 1}}), {0, 0}, {1, 0})->on_polygon.empty());
}

TEST(IntersectLine, the_polygon_of_a_periodic_curve_closes) {
    // The first control point is in the line, between the last and the second, on different sides.
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{1, 0}, {2, 2}, {-1, 1}, {3, -1}}, .periodic = true})
            .value();
    const LineContacts found = intersect_line(curve, {0, 0}, {1, 0}).value();
    ASSERT_EQ(found.on_polygon.size(), 2U);
    EXPECT_EQ(found.on_polygon[0].leg, 2U);
    EXPECT_EQ(found.on_polygon[0].point, Point(1, 0));
    EXPECT_EQ(found.on_polygon[1].leg, 3U);
    EXPECT_EQ(found.on_polygon[1].point, Point(1, 0));
    EXPECT_EQ(found.crossings, 2U);
}

// Waves lower than any tolerance for drawing, a line whose points are far apart, control points in the line within
// rounding: what is told never contradicts the theorem.
TEST(IntersectLine, the_polygon_is_crossed_as_often_however_flat_and_far) {
    RandomCurves random(343);
    for (int i = 0; i < 400; ++i) {
        CurveDefinition definition = random.curve().definition();
        const double height = std::pow(10.0, random.whole(-16, 0));
        const Vector offset = i % 2 == 0 ? Vector{} : Vector(1e6, -2e6);
        for (Point& point : definition.points) point = Point(point.x, height * std::round(point.y)) + offset;
        const Curve curve = Curve::make(definition).value();
        const double reach = std::pow(10.0, random.whole(-3, 6));
        const Point a = Point(0, height * random.whole(-1, 1)) + offset;
        const LineContacts found = intersect_line(curve, a, a + Vector(reach, 0)).value();
        EXPECT_LE(found.crossings, found.polygon_crossings) << i;
        EXPECT_EQ(found.on_polygon.size(), found.polygon_crossings) << i;
        EXPECT_TRUE(std::ranges::is_sorted(found.on_polygon, {}, &LegCrossing::leg)) << i;
    }
    const Curve flat = bezier({{0, 1e-13}, {1, -1e-13}, {2, 1e-13}, {3, -1e-13}});
    EXPECT_EQ(intersect_line(flat, {0, 0}, {1, 0})->polygon_crossings, 3U);
}

TEST(IntersectLine, lines_through_two_control_points_keep_the_theorem) {
    RandomCurves random(344);
    for (int i = 0; i < 400; ++i) {
        const Curve curve = random.curve();
        const auto points = curve.control_points();
        const Point a = points[static_cast<std::size_t>(random.whole(0, static_cast<int>(points.size()) - 1))];
        const Point b = points[static_cast<std::size_t>(random.whole(0, static_cast<int>(points.size()) - 1))];
        if (a == b) continue;
        const LineContacts found = intersect_line(curve, a, b).value();
        EXPECT_LE(found.crossings, found.polygon_crossings) << i;
    }
}

// The wave of n points about the line y = 0, whose polygon crosses it in each leg.
Curve wave_of(std::size_t n) {
    CurveDefinition definition{.degree = 3};
    for (std::size_t i = 0; i < n; ++i) definition.points.emplace_back(static_cast<double>(i), i % 2 == 0 ? 1.0 : -1.0);
    for (std::size_t i = 0; i < n + 4; ++i) definition.knots.push_back(static_cast<double>(i));
    return Curve::make(std::move(definition)).value();
}

TEST(IntersectLine, too_many_spans_are_counted_on_the_polygon_only) {
    const Curve wave = wave_of(10'000);
    const LineContacts stopped = intersect_line(wave, {0, 0}, {1, 0}, 100).value();
    EXPECT_FALSE(stopped.is_complete);
    EXPECT_TRUE(stopped.contacts.empty());
    EXPECT_EQ(stopped.polygon_crossings, 9'999U);
    EXPECT_EQ(stopped.on_polygon.size(), 100U);
    const LineContacts all = intersect_line(wave, {0, 0}, {1, 0}).value();
    EXPECT_TRUE(all.is_complete);
    // The sum of alternating basis functions alternates, too: once over each of the 9997 spans.
    EXPECT_EQ(all.crossings, 9'997U);
    EXPECT_EQ(intersect_line(wave, {4, -1}, {4, 1}, 10)->crossings, 1U);
}

TEST(IntersectSegment, takes_what_lies_between_its_ends) {
    const auto one = intersect_segment(ellipse(1, 1), {0, 0}, {5, 0}).value();
    ASSERT_EQ(one.contacts.size(), 1U);
    EXPECT_EQ(one.contacts[0].point.x, 1.0);
    EXPECT_EQ(one.polygon_crossings, 1U);
    EXPECT_EQ(intersect_segment(ellipse(1, 1), {-1, 0}, {1, 0})->contacts.size(), 2U);
    EXPECT_TRUE(intersect_segment(ellipse(1, 1), {-0.5, 0}, {0.5, 0})->contacts.empty());
    const auto part = intersect_segment(polygon({{0, 0}, {4, 0}, {4, 1}}), {1, 0}, {3, 0}).value();
    ASSERT_EQ(part.contacts.size(), 1U);
    EXPECT_NEAR(part.contacts[0].where.lower, 0.25, 1e-15);
    EXPECT_NEAR(part.contacts[0].where.upper, 0.75, 1e-15);
}

TEST(IntersectCurves, circles_in_closed_form) {
    for (const Vector offset : {Vector(0, 0), Vector(1e6, -3e6)}) {
        const Curve a = moved(ellipse(1, 1), offset);
        const double rounding = offset.x == 0 ? 1e-14 : 1e-8;
        const auto two = intersect_curves(a, ellipse(1, 1, Point(1.2, 0) + offset)).contacts;
        ASSERT_EQ(two.size(), 2U);
        for (const CurveContact& contact : two) {
            EXPECT_NEAR(contact.point.x - offset.x, 0.6, rounding);
            EXPECT_NEAR(std::abs(contact.point.y - offset.y), 0.8, rounding);
            EXPECT_FALSE(contact.is_tangent);
        }
        // From outside, from inside, and not at all.
        for (const auto& [radius, x] : {std::pair(1.0, 2.0), std::pair(0.5, 0.5), std::pair(0.25, 1.25)}) {
            const auto one = intersect_curves(a, ellipse(radius, radius, Point(x, 0) + offset)).contacts;
            ASSERT_EQ(one.size(), 1U) << radius;
            EXPECT_TRUE(one[0].is_tangent);
            EXPECT_NEAR(one[0].point.x - offset.x, 1.0, 1e-8);
            EXPECT_NEAR(one[0].point.y - offset.y, 0.0, 1e-3);
        }
        EXPECT_TRUE(intersect_curves(a, ellipse(1, 1, Point(2.001, 0) + offset)).contacts.empty());
        EXPECT_TRUE(intersect_curves(a, ellipse(0.5, 0.5, tip_of(offset))).contacts.empty());
    }
    // Tangent in the middle of pieces, at 3-4-5.
    const auto oblique = intersect_curves(ellipse(1, 1), ellipse(2, 2, {1.8, 2.4})).contacts;
    ASSERT_EQ(oblique.size(), 1U);
    EXPECT_NEAR(oblique[0].point.x, 0.6, 1e-9);
    EXPECT_NEAR(oblique[0].point.y, 0.8, 1e-9);
}

// A quadratic whose control points lie on one line goes to the middle one's height halfway and back: (0, -1) at u =
// 1/2. With its own part from 1/4 to 1 it shares that part, and the way back once more.
TEST(IntersectCurves, folded_pieces_share_their_way_to_and_fro) {
    const Curve fold = bezier({{-1, 1}, {0, -3}, {-1, 1}});
    const Curve part = bezier({{-0.625, -0.5}, {-0.25, -2}, {-1, 1}});  // the blossom at (1/4, 1/4), (1/4, 1), (1, 1)
    const CurveContacts found =
        intersect_curves(fold, Curve::make({.degree = 2,
                                            .knots = {0.25, 0.25, 0.25, 1, 1, 1},
                                            .points = {part.control_points().begin(), part.control_points().end()}})
                                   .value());
    EXPECT_TRUE(found.is_complete);
    double covered = 0.25;
    for (const CurveContact& contact : found.contacts)
        if (contact.is_overlap() && contact.on_first.lower <= covered + 1e-9)
            covered = std::max(covered, contact.on_first.upper);
    EXPECT_NEAR(covered, 1.0, 1e-9);
    // Alone, it passes all of its way a second time.
    const auto alone = self_intersections(fold).contacts;
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_NEAR(alone[0].on_first.lower, 0.0, 1e-9);
    EXPECT_NEAR(alone[0].on_first.upper, 0.5, 1e-6);
    EXPECT_NEAR(alone[0].second_begin, 1.0, 1e-9);
}

// Around 10^15 doubles are an eighth apart: what the pieces share is anyone's guess, and the search would go on
// forever.
TEST(IntersectCurves, what_cannot_be_told_is_said_to_be_undecided) {
    const double far = 1e15;
    const Curve noise = Curve::make({.degree = 2,
                                     .knots = {0, 0.25, 0.875, 1.5, 1.75, 2.25, 2.5},
                                     .points = {{far - 0.5, 0.375},
                                                {far - 0.25, -0.25},
                                                {far + 0.25, -0.875},
                                                {far + 0.375, 0.75},
                                                {far + 0.75, -0.75},
                                                {far + 0.75, 0.75}},
                                     .periodic = true})
                            .value();
    EXPECT_FALSE(self_intersections(noise).is_complete);
    EXPECT_TRUE(self_intersections(loop()).is_complete);
}

TEST(IntersectCurves, crossed_ellipses_meet_four_times) {
    const auto found = intersect_curves(ellipse(2, 1), ellipse(1, 2)).contacts;
    ASSERT_EQ(found.size(), 4U);
    // x^2 / 4 + y^2 = 1 and x^2 + y^2 / 4 = 1: both coordinates 2 / sqrt(5).
    for (const CurveContact& contact : found) {
        EXPECT_NEAR(std::abs(contact.point.x), 2 / std::sqrt(5.0), 1e-14);
        EXPECT_NEAR(std::abs(contact.point.y), 2 / std::sqrt(5.0), 1e-14);
    }
    for (const double factor : {1e-9, 1e9})
        EXPECT_EQ(intersect_curves(over(ellipse(2, 1), 0, factor), over(ellipse(1, 2), 5, 1 / factor)).contacts.size(),
                  4U);
}

TEST(IntersectCurves, two_cubics_meet_nine_times) {
    // Chebyshev's y = T3(x) and x = T3(y), so T9(x) = x.
    const Curve a = bezier({{-1, -1}, {-1.0 / 3, 5}, {1.0 / 3, -5}, {1, 1}});
    CurveDefinition mirrored = a.definition();
    for (Point& point : mirrored.points) point = {point.y, point.x};
    const Curve b = Curve::make(mirrored).value();
    const auto found = intersect_curves(a, b).contacts;
    EXPECT_EQ(found.size(), 9U);
    for (const CurveContact& contact : found)
        EXPECT_LE(distance(point_at(a, contact.u), point_at(b, contact.v)), 1e-14);
}

TEST(IntersectCurves, common_ends_and_corners_once) {
    const auto joined = intersect_curves(bezier({{0, 0}, {1, 2}, {2, 0}}), bezier({{2, 0}, {3, 1}, {4, 4}})).contacts;
    ASSERT_EQ(joined.size(), 1U);
    EXPECT_EQ(joined[0].u, 1.0);
    EXPECT_EQ(joined[0].v, 0.0);
    const auto smooth = intersect_curves(bezier({{0, 0}, {1, 1}, {2, 1}}), bezier({{2, 1}, {3, 1}, {4, 4}})).contacts;
    ASSERT_EQ(smooth.size(), 1U);
    EXPECT_TRUE(smooth[0].is_tangent);
    const auto corner = intersect_curves(polygon({{0, 0}, {1, 1}, {2, 0}}), polygon({{0, 2}, {1, 1}, {2, 2}})).contacts;
    ASSERT_EQ(corner.size(), 1U);
    EXPECT_EQ(corner[0].u, 1.0);
    const Curve cusp = bezier({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}});
    const auto at_cusp = intersect_curves(cusp, bezier({{0, -1}, {0, 1}})).contacts;
    ASSERT_EQ(at_cusp.size(), 1U);
    EXPECT_NEAR(at_cusp[0].point.x, 0.0, 1e-12);
}

TEST(IntersectCurves, tangential_crossing_once) {
    // y = x^3 and its tangent at the origin as curves.
    const auto found =
        intersect_curves(bezier({{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}}), bezier({{-2, 0}, {1, 0}})).contacts;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].point.x, 0.0, 1e-4);
    EXPECT_TRUE(found[0].is_tangent);
}

TEST(IntersectCurves, coinciding_pieces_are_intervals) {
    const Curve wave = Curve::make({.degree = 3,
                                    .knots = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3},
                                    .points = {{0, 0}, {1, 3}, {3, -2}, {5, 2}, {6, 0}, {8, 1}}})
                           .value();
    for (const Curve& other :
         {wave, elevate_degree(wave, 2).value(), insert_knot(wave, 0.7).value(), over(wave, 10, 1e9)}) {
        const auto found = intersect_curves(wave, other).contacts;
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR(found[0].on_first.lower, 0.0, 1e-9);
        EXPECT_NEAR(found[0].on_first.upper, 3.0, 1e-9);
        EXPECT_EQ(found[0].second_begin, other.domain().lower);
        EXPECT_EQ(found[0].second_end, other.domain().upper);
    }
    const auto against = intersect_curves(wave, reversed(wave)).contacts;
    ASSERT_EQ(against.size(), 1U);
    EXPECT_TRUE(against[0].is_overlap());
    EXPECT_EQ(against[0].second_begin, 0.0);
    EXPECT_EQ(against[0].second_end, -3.0);
}

TEST(IntersectCurves, coinciding_parts_of_lines_and_circles) {
    const auto lines = intersect_curves(polygon({{0, 0}, {4, 0}, {4, 3}}), polygon({{1, 0}, {9, 0}})).contacts;
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0].on_first.lower, 0.25, 1e-12);
    EXPECT_NEAR(lines[0].on_first.upper, 1.0, 1e-12);
    EXPECT_NEAR(lines[0].second_end, 0.375, 1e-12);
    // The quarter of the unit circle from 45 to 135 degrees.
    const double r = std::sqrt(0.5);
    const Curve quarter =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{r, r}, {0, 2 * r}, {-r, r}}, .weights = {1, r, 1}})
            .value();
    const auto arcs = intersect_curves(ellipse(1, 1), quarter).contacts;
    ASSERT_EQ(arcs.size(), 1U);
    EXPECT_NEAR(arcs[0].on_first.lower, 0.125, 1e-9);
    EXPECT_NEAR(arcs[0].on_first.upper, 0.375, 1e-9);
}

TEST(IntersectCurves, double_points_of_coinciding_curves_are_crossings_too) {
    const Curve eight =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{-2, -1}, {2, 1}, {2, -1}, {-2, 1}}, .periodic = true})
            .value();
    const auto found = intersect_curves(eight, elevate_degree(eight, 1).value()).contacts;
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(std::count_if(found.begin(), found.end(), [](const CurveContact& c) { return c.is_overlap(); }), 1);
    // A piece that closes, whose ends are the same point.
    const Curve drop = bezier({{0, 0}, {3, 0}, {0, 3}, {0, 0}});
    const auto whole = intersect_curves(drop, elevate_degree(drop, 1).value()).contacts;
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].on_first, (Interval{0, 1}));
    EXPECT_EQ(whole[0].second_end, 1.0);
    EXPECT_EQ(intersect_curves(drop, reversed(drop)).contacts[0].second_end, -1.0);
}

TEST(IntersectCurves, as_many_as_fine_polylines) {
    RandomCurves random(351);
    std::size_t all = 0;
    for (int i = 0; i < 60; ++i) {
        const Curve a = random.curve();
        const Curve b = random.curve();
        if (a.control_points().size() < 3 || b.control_points().size() < 3) continue;
        const auto found = intersect_curves(a, b).contacts;
        for (const CurveContact& contact : found)
            EXPECT_LE(distance(point_at(a, contact.u), point_at(b, contact.v)), 1e-11) << i;
        EXPECT_EQ(found.size(), polyline_crossings(samples_of(a, 150), samples_of(b, 150))) << i;
        EXPECT_EQ(intersect_curves(b, a).contacts.size(), found.size()) << i;
        const Vector offset(1e6, -2e6);
        EXPECT_EQ(intersect_curves(moved(a, offset), moved(b, offset)).contacts.size(), found.size()) << i;
        all += found.size();
    }
    EXPECT_GT(all, 100U);
}

TEST(SelfIntersections, double_point_of_a_cubic) {
    for (const Curve& curve :
         {loop(), moved(loop(), {1e6, 1e6}), insert_knot(loop(), 0.5).value(),
          insert_knot(loop(), 1.0 / 6.0, 3).value(), elevate_degree(loop(), 3).value(), over(loop(), 0, 1e-9)}) {
        const auto found = self_intersections(curve).contacts;
        ASSERT_EQ(found.size(), 1U);
        const double length = curve.domain().length();
        EXPECT_NEAR(found[0].u / length, 1.0 / 6.0, 1e-9);
        EXPECT_NEAR(found[0].v / length, 5.0 / 6.0, 1e-9);
        EXPECT_FALSE(found[0].is_tangent);
    }
    EXPECT_NEAR(self_intersections(loop()).contacts[0].u, 1.0 / 6.0, 1e-15);
}

TEST(SelfIntersections, none_of_arcs_closed_curves_cusps_and_corners) {
    EXPECT_TRUE(self_intersections(ellipse(3, 1)).contacts.empty());
    EXPECT_TRUE(self_intersections(bezier({{0, 0}, {1, 3}, {2, -3}, {3, 0}})).contacts.empty());
    EXPECT_TRUE(self_intersections(bezier({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}})).contacts.empty());
    EXPECT_TRUE(self_intersections(bezier({{1, -1}, {-1, 2}, {0, -4}, {4, 8}})).contacts.empty());
    EXPECT_TRUE(self_intersections(polygon({{0, 0}, {4, 0}, {0, 1}, {4, 2}})).contacts.empty());
    // Closed, of one piece and of two.
    EXPECT_TRUE(self_intersections(bezier({{0, 0}, {3, 0}, {0, 3}, {0, 0}})).contacts.empty());
    EXPECT_TRUE(self_intersections(Curve::make({.degree = 2,
                                                .knots = {0, 0, 0, 1, 1, 2, 2, 2},
                                                .points = {{0, 0}, {2, 2}, {2, 0}, {2, -2}, {0, 0}}})
                                       .value())
                    .contacts.empty());
}

TEST(SelfIntersections, figure_8_and_pentagram) {
    const Curve eight =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{-2, -1}, {2, 1}, {2, -1}, {-2, 1}}, .periodic = true})
            .value();
    const auto one = self_intersections(eight).contacts;
    ASSERT_EQ(one.size(), 1U);
    EXPECT_NEAR(distance(one[0].point, {}), 0.0, 1e-14);
    std::vector<Point> star;
    for (int k = 0; k <= 5; ++k)
        star.emplace_back(std::cos(4 * 3.141592653589793 * k / 5), std::sin(4 * 3.141592653589793 * k / 5));
    EXPECT_EQ(self_intersections(polygon(star)).contacts.size(), 5U);
}

TEST(SelfIntersections, way_there_and_back_is_an_interval) {
    const auto found = self_intersections(polygon({{0, 0}, {4, 0}, {1, 0}, {1, 3}})).contacts;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].is_overlap());
    EXPECT_NEAR(found[0].on_first.lower, 0.25, 1e-12);
    EXPECT_NEAR(found[0].on_first.upper, 1.0, 1e-12);
    EXPECT_NEAR(found[0].second_begin, 2.0, 1e-12);
    EXPECT_NEAR(found[0].second_end, 1.0, 1e-12);
}

TEST(SelfIntersections, rounds_of_a_square_are_one_interval_for_each_difference) {
    constexpr int rounds = 60;
    constexpr std::array<Point, 4> corners{Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}};
    std::vector<Point> points;
    std::vector<double> knots{0.0};
    for (int i = 0; i <= 4 * rounds; ++i) {
        points.push_back(corners[static_cast<std::size_t>(i % 4)]);
        knots.push_back(i);
    }
    knots.push_back(4 * rounds);
    const Curve curve = Curve::make({.degree = 1, .knots = knots, .points = points}).value();
    const auto found = self_intersections(curve).contacts;
    ASSERT_EQ(found.size(), static_cast<std::size_t>(rounds - 1));
    for (const CurveContact& contact : found) {
        const double later = contact.second_begin;
        EXPECT_EQ(std::fmod(later, 4.0), 0.0);
        EXPECT_EQ(contact.on_first.lower, 0.0);
        EXPECT_EQ(contact.on_first.upper, 4 * rounds - later);
        EXPECT_EQ(contact.second_end, 4.0 * rounds);
    }
}

TEST(SelfIntersections, as_many_as_fine_polylines) {
    RandomCurves random(352);
    std::size_t all = 0;
    for (int i = 0; i < 80; ++i) {
        const Curve curve = random.curve();
        if (curve.control_points().size() < 3) continue;
        const auto found = self_intersections(curve).contacts;
        for (const CurveContact& contact : found) {
            EXPECT_LT(contact.u, contact.v);
            EXPECT_LE(distance(point_at(curve, contact.u), point_at(curve, contact.v)), 1e-11) << i;
        }
        // Every crossing of the polyline with itself is met twice.
        const auto points = samples_of(curve, 150);
        EXPECT_EQ(2 * found.size(), polyline_crossings(points, points)) << i << " degree " << curve.degree();
        all += found.size();
    }
    EXPECT_GT(all, 50U);
}

// The square of a half of the largest double, whose diagonals are longer than that.
TEST(SelfIntersections, OfCurvesAsLargeAsDoublesAreFound) {
    const double r = 1e308;
    const auto polyline = [](std::vector<Point> points) {
        CurveDefinition definition{.degree = 1, .knots = {0}, .points = std::move(points)};
        for (std::size_t i = 0; i < definition.points.size(); ++i) definition.knots.push_back(static_cast<double>(i));
        definition.knots.push_back(definition.knots.back());
        return Curve::make(std::move(definition)).value();
    };
    EXPECT_TRUE(self_intersections(polyline({{-r, -r}, {r, -r}, {r, r}, {-r, r}, {-r, -r}})).contacts.empty());
    const auto [contacts, is_complete] = self_intersections(polyline({{-r, -r}, {r, r}, {r, -r}, {-r, r}}));
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_NEAR(contacts[0].u, 0.5, 1e-12);
    EXPECT_NEAR(contacts[0].v, 2.5, 1e-12);
    EXPECT_NEAR(contacts[0].point.x / r, 0.0, 1e-12);
    EXPECT_NEAR(contacts[0].point.y / r, 0.0, 1e-12);
    const auto crossed = intersect_curves(polyline({{-r, 0}, {r, 0}}), polyline({{r / 2, -r}, {r / 2, r}})).contacts;
    ASSERT_EQ(crossed.size(), 1U);
    EXPECT_NEAR(crossed[0].u, 0.75, 1e-12);
    EXPECT_NEAR(crossed[0].point.x / r, 0.5, 1e-12);
}

}  // namespace
}  // namespace batten::core
