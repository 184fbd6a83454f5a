#include "core/measure/detail/common_spans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "core/edit/knot_edit.h"
#include "core/edit/point_edit.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {
namespace {

// The knots and control points on which the curve over `part`, inside one span, depends.
struct Written {
    std::vector<double> knots;
    std::vector<Point> points;
    std::vector<double> weights;

    bool operator==(const Written&) const = default;
};

Written written(const Curve& curve, Interval part) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t s = curve.knots().span_at(0.5 * (part.lower + part.upper));
    Written result;
    for (std::size_t k = s - p + 1; k <= s + p; ++k) result.knots.push_back(curve.knots()[k]);
    for (std::size_t k = s - p; k <= s; ++k) {
        result.points.push_back(curve.control_points()[k % curve.control_points().size()]);
        result.weights.push_back(curve.weights()[k % curve.control_points().size()]);
    }
    return result;
}

// All parts, from one knot of either curve to the next, in which the curves are not written the same: slow and
// obviously right, for curves over the same domain.
std::vector<Interval> parts_one_by_one(const Curve& a, const Curve& b) {
    std::vector<double> knots;
    for (const Curve* curve : {&a, &b})
        for (const double u : curve->knots().values())
            if (curve->domain().contains(u)) knots.push_back(u);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    std::vector<Interval> parts;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        const Interval part{knots[k], knots[k + 1]};
        if (written(a, part) != written(b, part)) parts.push_back(part);
    }
    return parts;
}

void expect_same_parts(const Curve& a, const Curve& b) {
    ASSERT_EQ(a.domain(), b.domain());
    const std::vector<Interval> expected = parts_one_by_one(a, b);
    const std::vector<CommonSpan> found = differing_spans(a, b);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].part_of_a, expected[k]);
        EXPECT_EQ(found[k].part_of_b, expected[k]);
        EXPECT_EQ(found[k].span_of_a, a.knots().span_at(expected[k].lower));
        EXPECT_EQ(found[k].span_of_b, b.knots().span_at(expected[k].lower));
    }
}

// The same curve, with arrays of its own.
Curve copied(const Curve& curve) {
    return Curve::make(curve.definition()).value();
}

// A curve that differs in one thing; none where that is not possible.
std::optional<Curve> changed(RandomCurves& random, const Curve& curve) {
    const auto i = static_cast<std::size_t>(random.whole(0, static_cast<int>(curve.control_points().size()) - 1));
    switch (random.whole(0, 3)) {
        case 0:
            return set_control_point(curve, i, {random.number(-5.0, 5.0), random.number(-5.0, 5.0)}).value();
        case 1:
            return set_weight(curve, i, random.number(0.5, 2.0)).value();
        case 2: {
            const auto inserted = insert_knot(curve, random.parameter(curve));
            return inserted ? std::optional(*inserted) : std::nullopt;
        }
        default: {
            std::vector<double> knots(curve.knots().stored().begin(), curve.knots().stored().end());
            const auto k = static_cast<std::size_t>(random.whole(1, static_cast<int>(knots.size()) - 2));
            knots[k] = random.number(knots[k - 1], knots[k + 1]);
            CurveDefinition definition = curve.definition();
            definition.knots = knots;
            const auto made = Curve::make(std::move(definition));
            return made && made->domain() == curve.domain() ? std::optional(*made) : std::nullopt;
        }
    }
}

TEST(CommonSpans, are_those_that_are_not_written_the_same) {
    RandomCurves random(77);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const Curve curve = random.curve();
        const auto other = changed(random, curve);
        if (!other) continue;
        ++compared;
        expect_same_parts(curve, *other);
        expect_same_parts(*other, curve);
        expect_same_parts(copied(curve), *other);
        // Two changes, with parts that are the same between them.
        if (const auto third = changed(random, *other); third && third->knots().size() == curve.knots().size())
            expect_same_parts(curve, *third);
    }
    EXPECT_GT(compared, 1000);
}

TEST(CommonSpans, of_equal_curves_are_none) {
    RandomCurves random(78);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.curve();
        EXPECT_TRUE(differing_spans(curve, curve).empty());
        EXPECT_TRUE(differing_spans(curve, copied(curve)).empty());
    }
}

// A control point acts on p+1 spans, a knot on 2p+1 at most, a new knot on 2p+1 of the curve that has it.
TEST(CommonSpans, are_as_few_as_what_was_changed_acts_on) {
    std::vector<Point> points(1000);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {static_cast<double>(i), static_cast<double>(i * i % 7)};
    const Curve curve = open_curve(3, points);
    EXPECT_EQ(differing_spans(curve, set_control_point(curve, 500, {7.0, 7.0}).value()).size(), 4U);
    EXPECT_EQ(differing_spans(curve, set_weight(curve, 500, 2.0).value()).size(), 4U);
    const double u = curve.knots()[500];
    const double middle = 0.5 * (u + curve.knots()[501]);
    EXPECT_LE(differing_spans(curve, move_knot(curve, 500, middle, KnotMove::stop).value()).size(), 8U);
    EXPECT_LE(differing_spans(curve, insert_knot(curve, middle).value()).size(), 8U);
}

}  // namespace
}  // namespace batten::core
