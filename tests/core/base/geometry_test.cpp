#include "core/base/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <type_traits>

#include "core/curve/detail/bspline.h"

namespace batten::core {

namespace {

template <class A, class B>
concept Adds = requires(A a, B b) {
    a + b;
};
template <class A, class B>
concept Subtracts = requires(A a, B b) {
    a - b;
};
template <class A, class B>
concept Multiplies = requires(A a, B b) {
    (a) * (b);
};
template <class A, class B>
concept Divides = requires(A a, B b) {
    a / b;
};
template <class A, class B>
concept AddsTo = requires(A a, B b) {
    a += b;
};
template <class A, class B>
concept SubtractsFrom = requires(A a, B b) {
    a -= b;
};
template <class A, class B>
concept MultipliesTo = requires(A a, B b) {
    a *= b;
};
template <class A, class B>
concept DividesTo = requires(A a, B b) {
    a /= b;
};
template <class A, class B>
concept Compares = requires(A a, B b) {
    a == b;
};
template <class A>
concept Negates = requires(A a) {
    -a;
};

template <class A, class B>
concept HasDistance = requires(A a, B b) {
    distance(a, b);
};
template <class A, class B>
concept HasMiddle = requires(A a, B b) {
    middle(a, b);
};
template <class A, class B>
concept HasDot = requires(A a, B b) {
    dot(a, b);
};
template <class A, class B>
concept HasCross = requires(A a, B b) {
    cross(a, b);
};
template <class A>
concept HasLength = requires(A a) {
    length(a);
};
template <class A>
concept IsLifted = requires(A a) {
    lift(a, 1.0);
};

// Points differ by vectors.
static_assert(std::same_as<decltype(Point{} - Point{}), Vector>);
static_assert(std::same_as<decltype(Point{} + Vector{}), Point>);
static_assert(std::same_as<decltype(Point{} - Vector{}), Point>);
static_assert(!Adds<Point, Point> && !Adds<Vector, Point> && !Subtracts<Vector, Point>);
static_assert(AddsTo<Point&, Vector> && SubtractsFrom<Point&, Vector>);
static_assert(!AddsTo<Point&, Point> && !SubtractsFrom<Point&, Point>);
static_assert(!AddsTo<Vector&, Point> && !SubtractsFrom<Vector&, Point>);

// Vectors are numbers' companions, points are not.
static_assert(std::same_as<decltype(Vector{} + Vector{}), Vector>);
static_assert(std::same_as<decltype(Vector{} - Vector{}), Vector>);
static_assert(std::same_as<decltype(-Vector{}), Vector>);
static_assert(std::same_as<decltype(2.0 * Vector{}), Vector>);
static_assert(std::same_as<decltype(Vector{} * 2.0), Vector>);
static_assert(std::same_as<decltype(Vector{} / 2.0), Vector>);
static_assert(!Negates<Point> && !Multiplies<double, Point> && !Multiplies<Point, double> && !Divides<Point, double>);
static_assert(!MultipliesTo<Point&, double> && !DividesTo<Point&, double> && DividesTo<Vector&, double>);
static_assert(!Multiplies<Vector, Vector> && !Divides<Vector, Vector> && !Divides<double, Vector>);
static_assert(!Adds<Point, double> && !Adds<Vector, double> && !Subtracts<Point, double>);

// Neither becomes the other unless a function is called that says so.
static_assert(!std::is_constructible_v<Point, Vector> && !std::is_constructible_v<Vector, Point>);
static_assert(!std::is_assignable_v<Point&, Vector> && !std::is_assignable_v<Vector&, Point>);
static_assert(!std::is_constructible_v<Point, double> && !std::is_constructible_v<Vector, double>);
static_assert(!Compares<Point, Vector> && Compares<Point, Point> && Compares<Vector, Vector>);
static_assert(std::same_as<decltype(vector_to(Point{})), Vector> && std::same_as<decltype(tip_of(Vector{})), Point>);

// What is asked of the wrong one does not compile.
static_assert(HasDistance<Point, Point> && !HasDistance<Vector, Vector> && !HasDistance<Point, Vector>);
static_assert(HasMiddle<Point, Point> && !HasMiddle<Vector, Vector>);
static_assert(HasLength<Vector> && !HasLength<Point>);
static_assert(HasDot<Vector, Vector> && !HasDot<Point, Vector> && !HasDot<Point, Point>);
static_assert(HasCross<Vector, Vector> && !HasCross<Vector, Point> && !HasCross<Point, Point>);
static_assert(IsLifted<Point> && !IsLifted<Vector>);

// The layer that paints takes a point for a place as it is; a vector only when told to.
static_assert(std::is_convertible_v<Point, glm::dvec2> && !std::is_convertible_v<glm::dvec2, Point>);
static_assert(std::is_constructible_v<Point, glm::dvec2>);
static_assert(!std::is_convertible_v<Vector, glm::dvec2> && std::is_constructible_v<glm::dvec2, Vector>);
static_assert(!std::is_constructible_v<Vector, glm::dvec2>);
static_assert(!Adds<Point, glm::dvec2> && !Subtracts<glm::dvec2, Point> && !AddsTo<Point&, glm::dvec2>);

// They cost what two doubles cost, and start as two doubles do.
static_assert(sizeof(Point) == 2 * sizeof(double) && sizeof(Vector) == 2 * sizeof(double));
static_assert(sizeof(Point) == sizeof(glm::dvec2) && alignof(Point) == alignof(glm::dvec2));
static_assert(sizeof(Vector) == sizeof(glm::dvec2) && alignof(Vector) == alignof(glm::dvec2));
static_assert(std::is_trivial_v<Point> && std::is_standard_layout_v<Point>);
static_assert(std::is_trivial_v<Vector> && std::is_standard_layout_v<Vector>);
static_assert(Point{} == Point(0, 0) && Vector{} == Vector(0, 0));

TEST(Geometry, points_differ_by_vectors) {
    EXPECT_EQ(Point(5, 1) - Point(2, 7), Vector(3, -6));
    EXPECT_EQ(Point(2, 7) + Vector(3, -6), Point(5, 1));
    EXPECT_EQ(Point(5, 1) - Vector(3, -6), Point(2, 7));
    Point point(1, 2);
    point += Vector(10, 20);
    EXPECT_EQ(point, Point(11, 22));
    point -= Vector(1, 3);
    EXPECT_EQ(point, Point(10, 19));
}

TEST(Geometry, vectors_add_up_and_scale) {
    EXPECT_EQ(Vector(1, 2) + Vector(10, 30), Vector(11, 32));
    EXPECT_EQ(Vector(1, 2) - Vector(10, 30), Vector(-9, -28));
    EXPECT_EQ(-Vector(1, -2), Vector(-1, 2));
    EXPECT_EQ(3.0 * Vector(1, -2), Vector(3, -6));
    EXPECT_EQ(Vector(1, -2) * 3.0, Vector(3, -6));
    EXPECT_EQ(Vector(3, -6) / 3.0, Vector(1, -2));
    Vector v(1, 2);
    v += Vector(3, 6);
    EXPECT_EQ(v, Vector(4, 8));
    v -= Vector(1, 2);
    EXPECT_EQ(v, Vector(3, 6));
    v /= 3.0;
    EXPECT_EQ(v, Vector(1, 2));
}

// By a division each, not by a product with the reciprocal.
TEST(Geometry, quotients_are_rounded_once) {
    EXPECT_EQ((Vector(1, 5) / 49.0).x, 1.0 / 49.0);
    EXPECT_EQ((Vector(1, 5) / 49.0).y, 5.0 / 49.0);
    EXPECT_NE((Vector(1, 5) / 49.0).y, 5.0 * (1.0 / 49.0));
}

TEST(Geometry, both_coordinates_count_for_equality) {
    EXPECT_EQ(Point(1, 2), Point(1, 2));
    EXPECT_NE(Point(1, 2), Point(1, 3));
    EXPECT_NE(Vector(1, 2), Vector(0, 2));
    EXPECT_EQ(Vector(0.0, 0.0), Vector(-0.0, 0.0));
}

TEST(Geometry, cross_tells_left_from_right) {
    EXPECT_EQ(cross({1, 0}, {0, 1}), 1.0);
    EXPECT_EQ(cross({0, 1}, {1, 0}), -1.0);
    EXPECT_EQ(cross({2, 3}, {5, 7}), 2.0 * 7.0 - 3.0 * 5.0);
    EXPECT_EQ(cross({2, 3}, {4, 6}), 0.0);
    EXPECT_GT(cross({3, 1}, turned_left({3, 1})), 0.0);
}

TEST(Geometry, dot_tells_forwards_from_backwards) {
    EXPECT_EQ(dot({2, 3}, {5, 7}), 31.0);
    EXPECT_EQ(dot({2, 3}, {-5, -7}), -31.0);
    EXPECT_EQ(dot({2, 3}, turned_left({2, 3})), 0.0);
}

TEST(Geometry, angles_are_positive_to_the_left) {
    EXPECT_EQ(angle_between({2, 0}, {0, 3}), 0.5 * std::numbers::pi);
    EXPECT_EQ(angle_between({0, 3}, {2, 0}), -0.5 * std::numbers::pi);
    EXPECT_EQ(angle_between({1, 2}, {3, 6}), 0.0);
    EXPECT_EQ(angle_between({1, 2}, {-1, -2}), std::numbers::pi);
    EXPECT_NEAR(angle_between({1, 1}, {-1, 1}), 0.5 * std::numbers::pi, 1e-15);
}

TEST(Geometry, turned_left_is_a_quarter_of_a_turn) {
    EXPECT_EQ(turned_left({1, 0}), Vector(0, 1));
    EXPECT_EQ(turned_left({0, 1}), Vector(-1, 0));
    EXPECT_EQ(turned_left({3, -4}), Vector(4, 3));
}

TEST(Geometry, lengths_and_distances) {
    EXPECT_EQ(length({3, -4}), 5.0);
    EXPECT_EQ(robust_length({-3, 4}), 5.0);
    EXPECT_EQ(distance({1, 1}, {4, 5}), 5.0);
    EXPECT_EQ(distance({4, 5}, {1, 1}), 5.0);
    EXPECT_EQ(distance({1e6, 2}, {1e6, 2}), 0.0);
    // The root of the rounded sum of the rounded squares, which is not the last word on the length.
    EXPECT_EQ(length({0.1, 0.7}), std::sqrt(0.1 * 0.1 + 0.7 * 0.7));
}

TEST(Geometry, robust_lengths_need_no_squares) {
    const double large = std::ldexp(1.0, 700);
    const double small = std::ldexp(1.0, -700);
    EXPECT_EQ(robust_length({3 * large, 4 * large}), 5 * large);
    EXPECT_EQ(robust_length({3 * small, 4 * small}), 5 * small);
    EXPECT_EQ(length({3 * large, 4 * large}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(length({3 * small, 4 * small}), 0.0);
}

TEST(Geometry, the_middle_of_points_as_large_as_doubles_are) {
    EXPECT_EQ(middle({1, 10}, {5, -20}), Point(3, -5));
    const double largest = std::numeric_limits<double>::max();
    EXPECT_EQ(middle({largest, largest}, {largest, -largest}), Point(largest, 0));
}

TEST(Geometry, points_and_vectors_from_the_origin) {
    EXPECT_EQ(vector_to({3, -4}), Vector(3, -4));
    EXPECT_EQ(tip_of({3, -4}), Point(3, -4));
    EXPECT_EQ(seen_from({3, -4}, {1, 10}), Point(2, -14));
    EXPECT_EQ(seen_from({3, -4}, {}), Point(3, -4));
}

TEST(Geometry, one_coordinate_that_is_not_finite_is_enough) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(is_finite(Point(1e308, -1e308)) && is_finite(Vector(0, 0)));
    for (const double wrong : {infinity, -infinity, no_number}) {
        EXPECT_FALSE(is_finite(Point(wrong, 0)) || is_finite(Point(0, wrong)));
        EXPECT_FALSE(is_finite(Vector(wrong, 0)) || is_finite(Vector(0, wrong)));
    }
}

TEST(Geometry, lifting_multiplies_and_projecting_divides_by_the_weight) {
    EXPECT_EQ(lift({3, -4}, 2.0), HomogeneousPoint(6, -8, 2));
    EXPECT_EQ(project({6, -8, 2}), Point(3, -4));
    EXPECT_EQ(plane_part({6, -8, 2}), Vector(6, -8));
}

TEST(Geometry, points_go_to_the_painter_and_back) {
    const glm::dvec2 place = Point(3, -4);
    EXPECT_EQ(place, glm::dvec2(3, -4));
    EXPECT_EQ(Point(place), Point(3, -4));
    EXPECT_EQ(glm::dvec2(Vector(3, -4)), glm::dvec2(3, -4));
}

TEST(Geometry, blends_of_every_type_are_affine_combinations) {
    const Ratio quarter{0.75, 0.25};
    EXPECT_EQ(blend(2.0, 6.0, quarter), 3.0);
    EXPECT_EQ(blend(Point(0, 8), Point(4, 0), quarter), Point(1, 6));
    EXPECT_EQ(blend(Vector(0, 8), Vector(4, 0), quarter), Vector(1, 6));
    EXPECT_EQ(blend(HomogeneousPoint(0, 8, 1), HomogeneousPoint(4, 0, 5), quarter), HomogeneousPoint(1, 6, 2));
}

TEST(Geometry, a_box_is_empty_until_a_point_is_included) {
    Box box;
    EXPECT_TRUE(box.is_empty());
    box.include({1, 5});
    EXPECT_FALSE(box.is_empty());
    EXPECT_EQ(box.size(), Vector(0, 0));
    box.include({3, -1});
    EXPECT_EQ(box.lower, Point(1, -1));
    EXPECT_EQ(box.upper, Point(3, 5));
    EXPECT_EQ(box.size(), Vector(2, 6));
    EXPECT_EQ(box.center(), Point(2, 2));
    EXPECT_TRUE(box.contains({1, 5}));
    EXPECT_FALSE(box.contains({0.5, 0}));
    EXPECT_TRUE(box.intersects({{3, 5}, {9, 9}}));
    EXPECT_FALSE(box.intersects({{3.5, 0}, {9, 9}}));
}

}  // namespace

}  // namespace batten::core
