#include "core/refine/blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/measure/arc_length.h"
#include "core/measure/intersect_curves.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"
#include "tests/core/joint_jumps.h"
#include "tests/core/known_curves.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

using enum GeometricContinuity;
constexpr GeometricContinuity all[]{g0, g1, g2, g3};

TEST(Blend, continues_both_curves_as_asked) {
    RandomCurves random(571);
    for (int k = 0; k < 40; ++k) {
        const Curve first = random.open_curve();
        const Curve second = random.open_curve();
        for (const JoinedEnds ends : all_joined_ends)
            for (const GeometricContinuity at_first : all)
                for (const GeometricContinuity at_second : all) {
                    const auto blended = blend(first, second, ends, {at_first, 1.0}, {at_second, 0.7});
                    ASSERT_TRUE(blended) << describe(blended.error());
                    EXPECT_EQ(blended->degree(), order_of(at_first) + order_of(at_second) + 1);
                    if (blended->degree() == 1) continue;
                    const double size = length(blended->control_points().back() - blended->control_points().front());
                    EXPECT_LE(difference_of(run_back(measured_beyond(*blended, CurveEnd::start)),
                                            measured_beyond(first, ends.first), at_first, size),
                              1e-7);
                    EXPECT_LE(difference_of(measured_beyond(*blended, CurveEnd::end),
                                            run_back(measured_beyond(second, ends.second)), at_second, size),
                              1e-7);
                }
    }
}

TEST(Blend, of_two_arcs_of_a_circle_is_nearly_the_arc_between) {
    // What a Hermite interpolant of the arc length leaves: less and less with what is given.
    const double errors[]{1.0, 2e-2, 4e-4, 1e-5};
    for (const double scale : {1e-6, 1.0, 1e3})
        for (const GeometricContinuity continuity : {g1, g2, g3}) {
            const Curve first = circular_arc({0, 0}, scale, {0, 60}).value();
            const Curve second = circular_arc({0, 0}, scale, {150, 60}).value();
            const Curve blended =
                blend(first, second, {CurveEnd::end, CurveEnd::start}, {continuity}, {continuity}).value();
            for (int k = 0; k <= 20; ++k)
                EXPECT_NEAR(length(vector_to(point_at(blended, k / 20.0))) / scale, 1.0, errors[order_of(continuity)]);
            EXPECT_NEAR(arc_length(blended).value / scale, 0.5 * std::numbers::pi, errors[order_of(continuity)]);
        }
}

TEST(Blend, of_lines_on_one_line_is_the_line) {
    const Curve first = line({0, 1}, {1, 1}).value();
    const Curve second = line({3, 1}, {5, 1}).value();
    for (const GeometricContinuity continuity : all) {
        const Curve blended =
            blend(first, second, {CurveEnd::end, CurveEnd::start}, {continuity}, {continuity}).value();
        for (const Point& point : blended.control_points()) EXPECT_NEAR(point.y, 1.0, 1e-15);
        EXPECT_NEAR(point_at(blended, 0.5).x, 2.0, 1e-14);
        EXPECT_TRUE(self_intersections(blended).contacts.empty());
    }
}

TEST(Blend, makes_no_loop_between_ends_that_face_each_other) {
    for (const double turn : {-90.0, -60.0, 0.0, 60.0, 90.0})
        for (const double bend : {-1.0, -0.5, 0.0, 0.5, 1.0})
            for (const GeometricContinuity continuity : {g1, g2, g3}) {
                const double angle = turn * std::numbers::pi / 180.0;
                const Passing from{{0, 0}, Vector(1, 0), bend, 0.3};
                const Passing to{{2, 1}, Vector(std::cos(angle), std::sin(angle)), -bend, -0.2};
                const auto blended = blend(from, {continuity}, to, {continuity}).value();
                SCOPED_TRACE(testing::Message() << turn << ' ' << bend << ' ' << name_of(continuity));
                EXPECT_TRUE(self_intersections(blended).contacts.empty());
                EXPECT_LE(arc_length(blended).value, 6.0);
            }
}

TEST(Blend, follows_longer_with_more_tension) {
    const Passing from{{0, 0}, Vector(0, 1), 0.0, 0.0};
    const Passing to{{2, 0}, Vector(0, -1), 0.0, 0.0};
    double height = 0.0;
    for (const double tension : {0.25, 0.5, 1.0, 1.5}) {
        const Curve blended = blend(from, {g1, tension}, to, {g1, tension}).value();
        EXPECT_NEAR(point_at(blended, 0.5).x, 1.0, 1e-14);
        const double top = point_at(blended, 0.5).y;
        EXPECT_GT(top, height);
        height = top;
    }
    // Of the half circle of radius 1 the natural one is near.
    EXPECT_NEAR(point_at(blend(from, {g1}, to, {g1}).value(), 0.5).y, 1.0, 0.35);
}

TEST(Blend, far_away_joins_bit_by_bit) {
    const Vector far(1e6, -1e6);
    const Curve first = moved(circular_arc({0, 0}, 1, {0, 60}).value(), far);
    const Curve second = moved(circular_arc({4, 1}, 2, {150, -60}).value(), far);
    const Curve blended = blend(first, second, {CurveEnd::end, CurveEnd::start}, {g3}, {g3}).value();
    EXPECT_EQ(blended.control_points().front(), first.control_points().back());
    EXPECT_EQ(blended.control_points().back(), second.control_points().front());
    EXPECT_GE(smoothness_of(meeting_of(passing_at(first, CurveEnd::end), passing_at(blended, CurveEnd::start)), 4), 2);
}

TEST(Blend, refuses_what_cannot_be) {
    using Code = CurveErrorCode;
    const Curve first = line({0, 0}, {1, 0}).value();
    const Curve second = line({1, 0}, {5, 1}).value();
    const JoinedEnds ends{CurveEnd::end, CurveEnd::start};
    EXPECT_EQ(blend(first, second, ends, {}, {}).error().code, Code::ends_meet);
    EXPECT_EQ(blend(first, second, {CurveEnd::start, CurveEnd::end}, {g1, 0.0}, {}).error().code,
              Code::tension_not_positive);
    EXPECT_EQ(blend(first, second, {CurveEnd::start, CurveEnd::end}, {g1}, {g1, NAN}).error().code,
              Code::tension_not_positive);
    const Curve still =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{4, 0}, {4, 0}, {5, 0}, {6, 1}}})
            .value();
    EXPECT_EQ(blend(first, still, ends, {g1}, {g2}).error().code, Code::end_stands_still);
    EXPECT_TRUE(blend(first, still, ends, {g2}, {g1}));
    EXPECT_EQ(blend(first, circle({5, 5}, 1).value(), ends, {}, {}).error().code, Code::curve_closed);
}

}  // namespace
}  // namespace batten::core
