#include "app/editor/words/blossom_text.h"

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

core::KnotVector lecture_knots() {
    return core::KnotVector::make(3, {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1}).value();
}

TEST(BlossomText, names_control_points_by_the_knots_after_theirs) {
    const core::KnotVector knots = lecture_knots();
    EXPECT_EQ(blossom_by_indices(core::control_point_label(knots, 2)), "f(u_{3}, u_{4}, u_{5})");
    EXPECT_EQ(blossom_by_values(core::control_point_label(knots, 2), {}), "f(0, 1/4, 1/2)");
    EXPECT_EQ(blossom_by_values(core::control_point_label(knots, 1), {}), "f(0, 0, 1/4)");
    EXPECT_EQ(blossom_by_values(core::control_point_label(knots, 6), {}), "f(1, 1, 1)");
    EXPECT_EQ(blossom_by_values(core::control_point_label(knots, 1), {.numbers = NumberStyle::decimals}),
              "f(0, 0, 0.25)");
    EXPECT_EQ(notated(blossom_by_indices(core::de_boor_label(knots, 3, 1)), {.parameter = ParameterLetter::t}),
              "f(t_{4}, t_{5}, t)");
}

TEST(BlossomText, names_points_of_the_construction_by_the_parameter_as_often_as_their_level) {
    const core::KnotVector knots = lecture_knots();
    EXPECT_EQ(blossom_by_indices(core::de_boor_label(knots, 3, 1)), "f(u_{4}, u_{5}, u)");
    EXPECT_EQ(blossom_by_values(core::de_boor_label(knots, 3, 1), {}), "f(1/4, 1/2, u)");
    EXPECT_EQ(blossom_by_values(core::de_boor_label(knots, 4, 2), {}), "f(1/2, u, u)");
    EXPECT_EQ(blossom_by_values(core::de_boor_label(knots, 4, 3), {}), "f(u, u, u)");
}

TEST(BlossomText, of_many_arguments_has_the_ends) {
    core::BlossomLabel label{.first_knot = 4, .knots = {0, 0, 1, 2, 3}, .parameter_count = 2};
    EXPECT_EQ(blossom_by_indices(label), "f(u_{4}, …, u_{8}, u, u)");
    EXPECT_EQ(blossom_by_values(label, {}), "f(0, …, 3, u, u)");
    label.knots = {0.5};
    label.parameter_count = 24;
    EXPECT_EQ(blossom_by_values(label, {}), "f(1/2, u, …, u)");
    label.knots = {-1.0 / 3.0, 0.123456};
    label.parameter_count = 4;
    EXPECT_EQ(blossom_by_values(label, {}), "f(−1/3, 0.1235, u, u, u, u)");
}

}  // namespace
}  // namespace batten::editor
