#include "app/editor/derived/insertion_lines.h"

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const core::CurveDefinition& definition, double u) {
    const core::Curve curve = core::Curve::make(definition).value();
    const Notation notation;
    return insertion_lines({curve, core::de_boor_triangle(curve, u), notation});
}

TEST(InsertionLines, say_what_takes_the_place_of_what_until_the_new_point_is_the_curve_point) {
    EXPECT_EQ(lines_of(test::cubic(), 0.4),
              (Lines{"u inserted once: P_{2}^{1}, P_{3}^{1}, P_{4}^{1} take the place of P_{2}, P_{3}",
                     "u inserted 2 times: P_{3}^{2}, P_{4}^{2} take the place of P_{3}^{1}",
                     "u inserted 3 times: the new point is C(u)"}));
}

TEST(InsertionLines, are_fewer_where_u_is_a_knot) {
    EXPECT_EQ(lines_of(test::cubic(), 0.25), (Lines{"u inserted once: P_{2}^{1}, P_{3}^{1} take the place of P_{2}",
                                                    "u inserted 2 times: the new point is C(u)"}));
    EXPECT_EQ(lines_of(test::cubic(), 0.0), (Lines{"u is a knot of multiplicity 4: P_{0} is C(u)"}));
    EXPECT_EQ(lines_of(test::cubic(), 1.0), (Lines{"u is a knot of multiplicity 4: P_{6} is C(u)"}));
    const core::CurveDefinition line{.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 1}}};
    EXPECT_EQ(lines_of(line, 0.5), (Lines{"u inserted once: the new point is C(u)"}));
}

TEST(InsertionLines, of_a_high_degree_are_shortened) {
    core::CurveDefinition definition{.degree = 7, .knots = std::vector<double>(16, 0.0), .points = {}};
    std::fill(definition.knots.begin() + 8, definition.knots.end(), 1.0);
    for (int i = 0; i < 8; ++i) definition.points.push_back({1.0 * i, 0.0});
    const Lines lines = lines_of(definition, 0.5);
    ASSERT_EQ(lines.size(), 7U);
    EXPECT_EQ(lines[0], "u inserted once: P_{1}^{1}, P_{2}^{1}, …, P_{7}^{1} take the place of P_{1}, P_{2}, …, P_{6}");
}

TEST(InsertionLines, name_points_of_a_closed_curve_as_the_canvas_does) {
    EXPECT_EQ(lines_of(test::closed_cubic(), 5.5).front(),
              "u inserted once: P_{6}^{1}, P_{7}^{1}, P_{8}^{1} take the place of P_{0}, P_{1}");
}

}  // namespace
}  // namespace batten::editor
