#include "app/editor/words/wording.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace batten::editor {
namespace {

TEST(Wording, says_what_an_edit_did_to_the_shape) {
    EXPECT_EQ(done_sentence("Inserted knot 0.5", ShapeEffect::keeps, {}), "Inserted knot 0.5; the curve is unchanged");
    EXPECT_EQ(done_sentence("Moved P₅", ShapeEffect::changes, {.deviation = 0.12}),
              "Moved P₅; the curve moved by at most 0.12");
    EXPECT_EQ(done_sentence("Made knots custom", ShapeEffect::changes, {.deviation = 0.0}),
              "Made knots custom; the curve is unchanged");
    EXPECT_EQ(done_sentence("Fitted curve", ShapeEffect::none, {.error = 0.25}), "Fitted curve; error at most 0.25");
    EXPECT_EQ(done_sentence("Pasted", ShapeEffect::none, {}), "Pasted");
}

TEST(Wording, says_both_distances_where_they_differ_by_much) {
    EXPECT_EQ(done_sentence("Lowered degree", ShapeEffect::changes, {.deviation = 0.6289, .of_shapes = 0.3339}),
              "Lowered degree; the curve moved by at most 0.6289 at equal parameters, its shape by at most 0.3339");
}

TEST(Wording, says_where_a_distance_cannot_be_computed) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const char* const said =
        "Moved P₅; how far the curve moved cannot be computed: its points, weights or knots are too far apart, too "
        "large or too small";
    EXPECT_EQ(done_sentence("Moved P₅", ShapeEffect::changes, {.deviation = infinity}), said);
    EXPECT_EQ(done_sentence("Moved P₅", ShapeEffect::changes, {.deviation = infinity, .is_rounding = true}), said);
    EXPECT_EQ(done_sentence("Moved P₅", ShapeEffect::changes, {.error = infinity}), said);
}

TEST(Wording, is_no_more_unchanged_than_it_is) {
    EXPECT_EQ(done_sentence("Set degree", ShapeEffect::changes, {.deviation = 3e-17, .is_rounding = true}),
              "Set degree; the curve is unchanged but for rounding, at most 3e-17");
    EXPECT_EQ(done_sentence("Unclamped ends", ShapeEffect::keeps, {.error = 0.00095}),
              "Unclamped ends; the shape is kept up to rounding of far control points, error at most 0.00095");
}

TEST(Wording, takes_rounding_out_of_numbers_of_one_kind) {
    using Numbers = std::vector<double>;
    EXPECT_EQ(without_rounding(std::array{3.0, -2.2e-16, 0.5, 0.0}), (Numbers{3.0, 0.0, 0.5, 0.0}));
    EXPECT_EQ(without_rounding(std::array{3e-20, 1e-20}), (Numbers{3e-20, 1e-20})) << "small ones are not rounding";
    EXPECT_EQ(without_rounding(std::array{1.0, 1e-12}), (Numbers{1.0, 1e-12}));
    EXPECT_TRUE(without_rounding(std::span<const double>()).empty());
    const core::Vector vector = without_rounding(core::Vector(1.7e-15, -12.0));
    EXPECT_EQ(vector.x, 0.0);
    EXPECT_EQ(vector.y, -12.0);
}

}  // namespace
}  // namespace batten::editor
