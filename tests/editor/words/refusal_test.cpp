#include "app/editor/words/refusal.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

using Code = core::CurveErrorCode;

const Units none;
const Units tenths = core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 10.0};

TEST(Refusal, words_lengths_in_the_unit_of_the_document) {
    EXPECT_EQ(refusal_words(tenths, {.code = Code::fillet_too_large, .value = 5, .upper = 3.2}),
              "the radius 0.5 mm is too large for an arc that touches both sides here; 0.32 mm is the most");
    EXPECT_EQ(refusal_words(tenths, {.code = Code::fillet_not_possible, .value = 5, .lower = 1, .upper = 3}),
              "no arc of radius 0.5 mm touches both sides here; a radius from 0.1 mm to 0.3 mm does");
    EXPECT_EQ(refusal_words(tenths, {.code = Code::tolerance_not_reached, .value = 0.1, .lower = 25}),
              "the tolerance 0.01 mm was not reached; the least error is 2.5 mm");
    EXPECT_EQ(refusal_words(tenths, {.code = Code::length_not_positive, .value = -20}),
              "a length is -2 mm; radii, axes and other lengths must be above 0");
    EXPECT_EQ(refusal_words(tenths, {.code = Code::chamfer_too_long, .value = 30, .upper = 3.0 * 0.1}),
              "the distance from the corner is 3 mm; the side is only 0.03 mm long");
}

TEST(Refusal, leaves_parameters_beside_lengths_alone) {
    EXPECT_EQ(refusal_words(tenths, {.code = Code::offset_too_far, .value = 0.5, .lower = 4, .upper = 6}),
              "the distance is 0.6 mm, but the radius of curvature at 0.5 is 0.4 mm; toward the inside the distance "
              "must be less");
    EXPECT_EQ(refusal_words(tenths, {.code = Code::parameter_outside_domain, .value = 2, .lower = 0, .upper = 1}),
              "the parameter 2 is outside the domain; it must be from 0 to 1");
}

TEST(Refusal, is_that_of_the_core_without_a_unit) {
    for (int code = 0; code <= static_cast<int>(Code::not_computable); ++code) {
        const core::CurveError error{static_cast<Code>(code), 3, 0.1 * 3.0, -1.5, 1e300};
        EXPECT_EQ(refusal_words(none, error), core::describe(error));
        EXPECT_EQ(refusal_words(tenths, error).find('{'), std::string::npos);
        EXPECT_EQ(refusal_words(tenths, error).find(" mm") != std::string::npos,
                  refusal_words(tenths, error) != core::describe(error));
    }
}

}  // namespace
}  // namespace batten::editor
