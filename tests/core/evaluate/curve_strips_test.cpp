#include "core/evaluate/curve_strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/polygon_strips.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

constexpr std::size_t plenty = 1000000;
const Box everything{{-1e6, -1e6}, {1e6, 1e6}};

std::shared_ptr<const Curve> shared(Curve curve) {
    return std::make_shared<const Curve>(std::move(curve));
}

// A spiral of twenty turns around (0, 0), out to radius 4.
std::vector<Point> spiral_points(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = std::sqrt(static_cast<double>(i) / static_cast<double>(count - 1));
        const double angle = 40.0 * std::numbers::pi * share;
        points.emplace_back(4.0 * share * std::cos(angle), 4.0 * share * std::sin(angle));
    }
    return points;
}

// All over the unit square.
std::vector<Point> scattered_points(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
        points.emplace_back(std::fmod(static_cast<double>(i * i) * 0.618, 1.0),
                            std::fmod(static_cast<double>(i) * 0.414, 1.0));
    return points;
}

// Puts all chords into `chords`.
ChordRequest collecting(PointRuns& chords, double tolerance) {
    return {tolerance, everything, [](const Strip&) { return false; },
            [&chords](Point a, Point b) {
                chords.push_back({a, b});
            }};
}

std::shared_ptr<const Curve> cubic_through(std::vector<Point> points) {
    const std::size_t count = points.size();
    return shared(Curve::make(make_knots(KnotKind::clamped_uniform, 3, count).value(), std::move(points), {}).value());
}

double distance_to(const PointRuns& runs, Point point) {
    double least = Box::infinity;
    for (const auto& run : runs)
        for (std::size_t i = 0; i + 1 < run.size(); ++i)
            least = std::min(least, distance_to_segment(point, run[i], run[i + 1]));
    return least;
}

std::size_t place_count(const PointRuns& runs) {
    std::size_t count = 0;
    for (const auto& run : runs) count += run.size();
    return count;
}

// The farthest that places of the curve are from the polylines, by `samples` in each span.
double farthest(const Curve& curve, const PointRuns& runs, int samples) {
    double largest = 0.0;
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        for (int k = 0; k <= samples && knots[s] < knots[s + 1]; ++k) {
            const double u = k == samples ? knots[s + 1] : knots[s] + (knots[s + 1] - knots[s]) * k / samples;
            const Side side = k == samples ? Side::left : Side::right;
            largest = std::max(largest, distance_to(runs, point_at(curve, u, side)));
        }
    return largest;
}

TEST(CurveStrips, are_true_to_the_tolerance) {
    RandomCurves random(91);
    for (int k = 0; k < 150; ++k) {
        const auto curve = shared(random.curve());
        CurveStrips strips(curve);
        for (const double tolerance : {1.0, 0.1, 1e-3}) {
            const PointRuns runs = strips.runs({tolerance, everything, plenty}, curve->domain()).value();
            EXPECT_LE(farthest(*curve, runs, 9), tolerance * (1.0 + 1e-9)) << k;
        }
    }
}

TEST(CurveStrips, draw_many_spans_that_are_nearly_straight_with_few_places) {
    const auto curve = cubic_through(spiral_points(5000));
    CurveStrips strips(curve);
    const PointRuns runs = strips.runs({0.002, everything, plenty}, curve->domain()).value();
    EXPECT_EQ(runs.size(), 1U);
    EXPECT_LE(farthest(*curve, runs, 1), 0.002);
    // Chords of arcs of radius r are sqrt(8 r 0.002) long: some 1600 for the whole spiral.
    EXPECT_LT(place_count(runs), 4000U);
}

TEST(CurveStrips, give_nothing_where_it_takes_more_places_than_asked_for) {
    const auto curve = cubic_through(scattered_points(5000));
    CurveStrips strips(curve);
    const std::size_t count = place_count(strips.runs({1e-3, everything, plenty}, curve->domain()).value());
    EXPECT_GT(count, 5000U);
    EXPECT_TRUE(strips.runs({1e-3, everything, count}, curve->domain()));
    EXPECT_FALSE(strips.runs({1e-3, everything, count - 1}, curve->domain()));
    EXPECT_FALSE(PolygonStrips(curve).runs({1e-3, everything, 4999}));
    EXPECT_TRUE(PolygonStrips(curve).runs({1e-3, everything, 5000}));
}

// How often polylines, joined in order to one, run around a place.
int winding_of(const PointRuns& runs, Point place) {
    std::vector<Point> points;
    for (const auto& run : runs) points.insert(points.end(), run.begin(), run.end());
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += angle_between(points[i] - place, points[(i + 1) % points.size()] - place);
    return static_cast<int>(std::lround(sum / (2.0 * std::numbers::pi)));
}

// Wherever the view is, and though most of the curve lies outside of it.
TEST(CurveStrips, outline_runs_around_places_of_the_view_as_the_curve_does) {
    const auto curve = cubic_through(spiral_points(2000));
    CurveStrips strips(curve);
    const PointRuns whole = strips.outline({1e-4, everything, plenty}).value();
    for (const Point corner : {Point(-0.1, -0.1), Point(2, 1), Point(-3, 0.5), Point(0.3, -3.7)}) {
        const Box view{corner, corner + Vector(0.2, 0.2)};
        const PointRuns seen = strips.outline({1e-4, view, plenty}).value();
        std::size_t places = 0;
        for (const auto& run : seen) places += run.size();
        EXPECT_LT(places, 1500U);
        for (const Vector to : {Vector(0.01, 0.03), Vector(0.1, 0.1), Vector(0.17, 0.02)})
            EXPECT_EQ(winding_of(seen, corner + to), winding_of(whole, corner + to));
        EXPECT_EQ(seen.front().front(), curve->control_points().front());
        EXPECT_EQ(seen.back().back(), curve->control_points().back());
    }
    EXPECT_FALSE(strips.outline({1e-9, everything, 100}));
}

TEST(CurveStrips, hand_out_chords_of_the_whole_curve) {
    RandomCurves random(31);
    for (int k = 0; k < 150; ++k) {
        const auto curve = shared(random.curve());
        const CurveStrips strips(curve);
        PointRuns chords;
        strips.visit_chords(collecting(chords, 1e-3), curve->domain());
        EXPECT_LE(farthest(*curve, chords, 9), 1e-3 * (1.0 + 1e-9)) << k;
    }
}

TEST(CurveStrips, hand_out_what_is_not_hidden_or_left_out) {
    const auto curve = cubic_through(scattered_points(100));
    const CurveStrips strips(curve);
    PointRuns chords;
    ChordRequest request = collecting(chords, 1e-3);
    request.is_hidden = [](const Strip& strip) { return strip.box.upper.x < 0.5; };
    const std::vector<std::size_t> left_out{3, 40, 41, 90};
    strips.visit_chords(request, curve->domain(), left_out);
    for (const auto& chord : chords) EXPECT_TRUE(chord.front().x >= 0.5 || chord.back().x >= 0.5);
    const KnotVector& knots = curve->knots();
    std::size_t missing = 0;
    for (std::size_t s = 3; s + 4 < knots.size(); ++s) {
        const Point place = point_at(*curve, 0.5 * (knots[s] + knots[s + 1]));
        if (place.x < 0.501 || std::binary_search(left_out.begin(), left_out.end(), s)) continue;
        EXPECT_LE(distance_to(chords, place), 1e-3) << s;
    }
    for (const std::size_t s : left_out) {
        PointRuns own;
        strips.visit_span_chords(collecting(own, 1e-3), s);
        const Point place = point_at(*curve, 0.5 * (knots[s] + knots[s + 1]));
        EXPECT_LE(distance_to(own, place), 1e-3) << s;
        if (distance_to(chords, place) > 1e-3) ++missing;
    }
    EXPECT_GE(missing, 2U) << "others may pass there";
}

TEST(CurveStrips, follow_knots_that_are_inserted_and_removed_as_if_made_anew) {
    RandomCurves random(23);
    for (int k = 0; k < 60; ++k) {
        const Curve first = random.curve();
        CurveStrips strips(shared(first));
        PolygonStrips polygon(shared(first));
        const Interval domain = first.domain();
        for (const double share : {0.5, 0.1, 0.1, 0.97}) {
            const auto inserted = insert_knot(*strips.curve(), domain.lower + share * domain.length());
            if (!inserted) continue;
            const auto before = strips.curve();
            for (const auto& next : {shared(*inserted), before, shared(*inserted)}) {
                strips.follow(next);
                polygon.follow(next);
                const StripRequest request{1e-3, everything, plenty};
                EXPECT_EQ(strips.runs(request, domain), CurveStrips(next).runs(request, domain)) << k;
                EXPECT_EQ(polygon.runs(request)->runs, PolygonStrips(next).runs(request)->runs) << k;
            }
        }
    }
}

TEST(CurveStrips, take_apart_only_what_is_near_an_inserted_knot) {
    const auto curve = cubic_through(spiral_points(5000));
    CurveStrips strips(curve);
    PolygonStrips polygon(curve);
    const std::size_t stretches = strips.stretch_count();
    const std::size_t of_polygon = polygon.stretch_count();
    const double u = curve->domain().lower + 0.20007 * curve->domain().length();
    const auto inserted = shared(insert_knot(*curve, u).value());
    for (int k = 1; k <= 50; ++k) {
        for (const auto& next : {inserted, curve}) {
            const std::uint64_t number = strips.change().number;
            strips.follow(next);
            polygon.follow(next);
            EXPECT_EQ(strips.change().number, number + 1);
            EXPECT_TRUE(strips.change().is_renumbered);
            EXPECT_FALSE(strips.change().is_all);
        }
        EXPECT_LE(strips.stretch_count(), stretches + 4 * static_cast<std::size_t>(k));
        EXPECT_LE(polygon.stretch_count(), of_polygon + 4 * static_cast<std::size_t>(k));
    }
    // The spans that the three new points act on, and the one after them.
    strips.follow(inserted);
    const std::size_t span = inserted->knots().span_at(u);
    EXPECT_TRUE(std::binary_search(strips.change().parts.begin(), strips.change().parts.end(), span));
    EXPECT_TRUE(std::binary_search(strips.change().parts.begin(), strips.change().parts.end(), span - 3));
    EXPECT_LE(strips.change().parts.size(), 10U);
}

TEST(CurveStrips, show_the_extent_of_what_is_narrower_than_the_tolerance) {
    // A hundred thousand swings up and down on a width of 1.
    std::vector<Point> points;
    for (std::size_t i = 0; i < 100000; ++i)
        points.emplace_back(static_cast<double>(i) * 1e-5, i % 2 == 0 ? 0.0 : 1.0 + static_cast<double>(i % 7));
    const auto curve =
        shared(Curve::make(make_knots(KnotKind::clamped_uniform, 1, points.size()).value(), points, {}).value());
    CurveStrips strips(curve);
    const PointRuns runs = strips.runs({0.01, everything, 2000}, curve->domain()).value();
    EXPECT_LE(place_count(runs), 2000U);
    for (std::size_t i = 0; i < points.size(); i += 997) EXPECT_LE(distance_to(runs, points[i]), 0.01) << i;
}

TEST(CurveStrips, move_with_one_point_by_taking_apart_only_its_spans) {
    std::vector<Point> points = spiral_points(1000);
    const auto curve = cubic_through(points);
    CurveStrips strips(curve);
    strips.runs({1e-6, everything, plenty}, curve->domain()).value();
    const std::size_t spans = strips.span_count();
    const std::size_t stretches = strips.stretch_count();
    EXPECT_EQ(spans, 997U);
    points[500] += Vector(0.5, 0.25);
    const auto moved = cubic_through(points);
    strips.follow(moved);
    const PointRuns runs = strips.runs({1e-6, everything, plenty}, curve->domain()).value();
    EXPECT_EQ(strips.span_count(), spans + 4);
    EXPECT_LE(strips.stretch_count(), stretches + 2);
    EXPECT_EQ(runs, CurveStrips(moved).runs({1e-6, everything, plenty}, curve->domain()).value());
}

TEST(CurveStrips, move_as_a_whole_without_taking_apart_what_nobody_looks_at) {
    std::vector<Point> points = spiral_points(1000);
    CurveStrips strips(cubic_through(points));
    strips.runs({1e-6, everything, plenty}, strips.curve()->domain()).value();
    const std::size_t spans = strips.span_count();
    for (Point& point : points) point += Vector(0.5, 0.25);
    const auto moved = cubic_through(points);
    strips.follow(moved);
    EXPECT_EQ(strips.span_count(), spans);
    EXPECT_EQ(strips.runs({1e-6, everything, plenty}, moved->domain()).value(),
              CurveStrips(moved).runs({1e-6, everything, plenty}, moved->domain()).value());
    EXPECT_EQ(strips.span_count(), spans + 997);
}

TEST(CurveStrips, follow_random_changes_as_if_made_anew) {
    RandomCurves random(17);
    for (int k = 0; k < 300; ++k) {
        const Curve first = random.curve();
        CurveStrips strips(shared(first));
        strips.runs({1e-3, everything, plenty}, first.domain()).value();
        CurveDefinition definition = first.definition();
        const auto i = static_cast<std::size_t>(random.whole(0, static_cast<int>(definition.points.size()) - 1));
        if (k % 3 == 0) definition.points[i].x += 0.5;
        if (k % 3 == 1) definition.weights[i] *= 2.0;
        if (k % 3 == 2)
            for (double& knot : definition.knots)
                if (knot > first.domain().lower && knot < first.domain().upper)
                    knot += 1e-3 * (first.domain().upper - knot);
        auto changed = Curve::make(definition);
        if (!changed) continue;
        const auto other = shared(std::move(*changed));
        strips.follow(other);
        const PointRuns runs = strips.runs({1e-3, everything, plenty}, other->domain()).value();
        EXPECT_LE(farthest(*other, runs, 7), 1e-3 * (1.0 + 1e-9)) << k;
        EXPECT_EQ(runs.size(), CurveStrips(other).runs({1e-3, everything, plenty}, other->domain()).value().size())
            << k;
    }
}

TEST(CurveStrips, compute_nothing_again_while_the_view_moves) {
    const auto curve = cubic_through(spiral_points(1000));
    CurveStrips strips(curve);
    Box view{{0.0, 0.0}, {2.0, 2.0}};
    strips.runs({1e-4, view, plenty}, curve->domain()).value();
    const std::size_t seen = strips.span_count();
    EXPECT_LT(seen, 600U);
    // Back to where it was, and inwards.
    strips.runs({1e-4, {{0.5, 0.5}, {1.5, 1.5}}, plenty}, curve->domain()).value();
    strips.runs({1e-4, view, plenty}, curve->domain()).value();
    strips.runs({1e-3, view, plenty}, curve->domain()).value();
    EXPECT_EQ(strips.span_count(), seen);
    for (int k = 1; k <= 100; ++k) {
        view = {{0.01 * k, 0.0}, {2.0 + 0.01 * k, 2.0}};
        strips.runs({1e-4, view, plenty}, curve->domain()).value();
    }
    // Each span came into view at most once, with those of its stretch.
    EXPECT_LE(strips.span_count(), 997U);
}

TEST(CurveStrips, cost_what_is_seen_of_a_long_curve) {
    const auto curve = cubic_through(spiral_points(100000));
    CurveStrips strips(curve);
    EXPECT_EQ(strips.span_count(), 0U);
    const Box view{{1.0, 0.0}, {1.02, 0.02}};
    const PointRuns runs = strips.runs({1e-5, view, plenty}, curve->domain()).value();
    EXPECT_GE(runs.size(), 1U);
    EXPECT_LT(strips.span_count(), 200U);
}

TEST(CurveStrips, keep_what_comes_apart_apart) {
    const auto curve = shared(Curve::make({.degree = 1,
                                           .knots = {0, 0, 1, 1, 2, 2},
                                           .points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}},
                                           .tears = Tears::allow})
                                  .value());
    CurveStrips strips(curve);
    const PointRuns runs = strips.runs({0.1, everything, plenty}, curve->domain()).value();
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0], (std::vector<Point>{{0, 0}, {1, 0}}));
    EXPECT_EQ(runs[1], (std::vector<Point>{{2, 0}, {3, 0}}));
}

TEST(CurveStrips, give_the_spans_of_a_range_only) {
    const auto curve = cubic_through(spiral_points(200));
    const KnotVector& knots = curve->knots();
    CurveStrips strips(curve);
    const Interval range{knots[50], knots[54]};
    const PointRuns runs = strips.runs({1e-6, everything, plenty}, range).value();
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].front(), point_at(*curve, range.lower));
    EXPECT_EQ(runs[0].back(), point_at(*curve, range.upper));
}

TEST(CurveStrips, survive_numbers_of_any_size) {
    for (const double size : {1e-300, 1e15, 1e150, 1e300}) {
        std::vector<Point> points = spiral_points(100);
        for (Point& point : points) point = tip_of(size * vector_to(point));
        points[50].x = 4.0 * size;
        const auto curve = cubic_through(points);
        CurveStrips strips(curve);
        const Box whole{{-5.0 * size, -5.0 * size}, {5.0 * size, 5.0 * size}};
        const Box part{{-10, -10}, {10, 10}};
        for (const auto& [tolerance, view] : {std::pair(1e-3 * size, whole), std::pair(0.25, part)}) {
            const auto runs = strips.runs({tolerance, view, 2000}, curve->domain());
            EXPECT_LE(runs ? place_count(*runs) : 0, 2000U) << size;
            PointRuns chords;
            ChordRequest all = collecting(chords, tolerance);
            all.view = view;
            strips.visit_chords(all, curve->domain());
            PolygonStrips(curve).visit_chords(all);
            EXPECT_LT(chords.size(), 20000U) << size;
        }
    }
    const auto one_place = cubic_through(std::vector<Point>(1000, Point(1, 2)));
    CurveStrips strips(one_place);
    EXPECT_EQ(place_count(strips.runs({1e-9, everything, plenty}, one_place->domain()).value()), 2U);
}

TEST(PolygonStrips, give_every_leg_while_they_are_few) {
    for (const bool periodic : {false, true}) {
        RandomCurves random(3);
        const auto curve = shared(periodic ? random.periodic_curve() : random.open_curve());
        const auto points = curve->control_points();
        std::vector<Point> corners(points.begin(), points.end());
        if (periodic) corners.push_back(corners.front());
        const PointRuns runs = PolygonStrips(curve).runs({1e6, everything, plenty}).value().runs;
        ASSERT_EQ(runs.size(), 1U);
        EXPECT_EQ(runs[0], corners);
    }
}

TEST(PolygonStrips, thin_out_many_legs_and_follow_a_point) {
    std::vector<Point> points = spiral_points(50000);
    PolygonStrips strips(cubic_through(points));
    const std::size_t stretches = strips.stretch_count();
    points[20000] += Vector(3.0, 1.0);
    strips.follow(cubic_through(points));
    EXPECT_LE(strips.stretch_count(), stretches + 2);
    const PointRuns runs = strips.runs({0.002, everything, 4000}).value().runs;
    EXPECT_LE(place_count(runs), 4000U);
    EXPECT_GT(place_count(runs), 500U);
    EXPECT_LE(distance_to(runs, points[20000]), 0.01);
    for (std::size_t i = 0; i < points.size(); i += 499) EXPECT_LE(distance_to(runs, points[i]), 0.01) << i;
}

TEST(PolygonStrips, leave_out_corners_of_a_stretch_one_by_one) {
    // Legs of some 6 units on circles of a radius of some 300: sixteen of them turn far from their chord, two do not.
    std::vector<Point> points;
    for (int i = 0; i < 3000; ++i) {
        const double radius = 200.0 + 0.03 * i;
        points.emplace_back(radius * std::cos(0.02 * i), radius * std::sin(0.02 * i));
    }
    const PointRuns runs = PolygonStrips(cubic_through(points)).runs({0.25, everything, 2000}).value().runs;
    EXPECT_LE(place_count(runs), 2000U);
    for (std::size_t i = 0; i < points.size(); i += 7) EXPECT_LE(distance_to(runs, points[i]), 0.3) << i;
}

TEST(PolygonStrips, tell_how_far_along_what_is_seen_begins) {
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i) points.emplace_back(3.0 * i, i % 2 == 0 ? 0.0 : 4.0);
    const PolygonStrips strips(cubic_through(points));
    const PolygonRuns seen = strips.runs({0.1, {{150.0, 0.0}, {160.0, 4.0}}, plenty}).value();
    ASSERT_EQ(seen.starts.size(), 1U);
    // Every leg has length 5.
    EXPECT_DOUBLE_EQ(seen.starts[0], 5.0 * seen.runs[0][0].x / 3.0);
    EXPECT_LE(seen.runs[0].front().x, 150.0);
    EXPECT_GE(seen.runs[0].front().x, 90.0);
}

TEST(PolygonStrips, hand_out_every_leg_once) {
    // So many that they are visited here and there.
    std::vector<Point> points;
    for (int i = 0; i < 40000; ++i) points.emplace_back(3.0 * i, i % 2 == 0 ? 0.0 : 4.0);
    const PolygonStrips strips(cubic_through(points));
    std::vector<bool> is_seen(points.size() - 1);
    const std::vector<std::size_t> left_out{17, 30000};
    ChordRequest request{0.1, everything, [](const Strip&) { return false; },
                         [&](Point a, Point b) {
                             const auto leg = static_cast<std::size_t>(a.x / 3.0);
                             EXPECT_EQ(a, points[leg]);
                             EXPECT_EQ(b, points[leg + 1]);
                             EXPECT_FALSE(is_seen[leg]) << leg;
                             is_seen[leg] = true;
                         }};
    strips.visit_chords(request, left_out);
    for (std::size_t leg = 0; leg < is_seen.size(); ++leg) EXPECT_EQ(is_seen[leg], leg != 17 && leg != 30000) << leg;
    for (const std::size_t leg : left_out) strips.visit_leg_chord(request, leg);
    EXPECT_TRUE(is_seen[17] && is_seen[30000]);
}

TEST(PolygonStrips, visit_every_point_in_view_once) {
    const std::vector<Point> points = spiral_points(16 * 20 + 1);
    const PolygonStrips strips(cubic_through(points));
    const Box view{{-1.0, -1.0}, {3.0, 4.0}};
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (view.contains(points[i])) expected.push_back(i);
    std::vector<std::size_t> visited;
    strips.visit_points(view, 0.0, plenty, [&](std::size_t i, Point, std::size_t) { visited.push_back(i); });
    EXPECT_EQ(visited, expected);
}

}  // namespace
}  // namespace batten::core
