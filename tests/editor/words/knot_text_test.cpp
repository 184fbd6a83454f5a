#include "app/editor/words/knot_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::editor {
namespace {

using Knots = std::vector<double>;

Knots knots_of(std::string_view text) {
    const Outcome<TypedVector> vector = read_vector(text);
    EXPECT_TRUE(vector) << text << ": " << vector.error();
    return vector ? vector->knots : Knots{};
}

std::optional<int> degree_of(std::string_view text) {
    return read_vector(text)->degree;
}

TEST(KnotText, is_read_as_people_write_it) {
    const Knots seven{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(knots_of("0 1 2 3 4 5 6 7"), seven);
    EXPECT_EQ(knots_of("0, 1, 2, 3, 4, 5, 6, 7"), seven);
    EXPECT_EQ(knots_of("(0, 1, 2, 3, 4, 5, 6, 7)"), seven);
    EXPECT_EQ(knots_of("T = (0, ..., 7)"), seven);
    EXPECT_EQ(knots_of("U=(0,1,…,7)"), seven);
    EXPECT_EQ(knots_of("0 ... 7"), seven);
    EXPECT_EQ(knots_of("[0 1 2 3 4 5 6 7]"), seven);
    EXPECT_EQ(knots_of("(0, (1/2), 1)"), (Knots{0, 0.5, 1}));
    EXPECT_EQ(knots_of("0 0 0 1/2 1 1 1"), (Knots{0, 0, 0, 0.5, 1, 1, 1}));
    EXPECT_EQ(knots_of("0, 0.5, ..., 2"), (Knots{0, 0.5, 1, 1.5, 2}));
    EXPECT_EQ(knots_of("-3, -2, ..., 1, 1, ..., 3"), (Knots{-3, -2, -1, 0, 1, 1, 2, 3}));
}

TEST(KnotText, may_have_its_degree_behind_it) {
    EXPECT_EQ(degree_of("0 0 1 1"), std::nullopt);
    EXPECT_EQ(degree_of("(0, ..., 7) 3"), 3);
    EXPECT_EQ(degree_of("T = (0, ..., 7), p = 3"), 3);
    EXPECT_EQ(degree_of("0 1 2 3 4 5 p = 2"), 2);
    EXPECT_EQ(knots_of("0 1 2 3 4 5, p = 2"), (Knots{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(knots_of("(0, 1) 1"), (Knots{0, 1}));
}

TEST(KnotText, says_what_is_wrong) {
    EXPECT_EQ(read_vector("").error(),
              "knots are needed, like 0 0 0 1 2 3 3 3 or (0, ..., 7), and with \"...\" one on both sides of it");
    EXPECT_FALSE(read_vector("(... 7)"));
    EXPECT_FALSE(read_vector("(0, ...)"));
    EXPECT_FALSE(read_vector("("));
    EXPECT_FALSE(read_vector("()"));
    EXPECT_FALSE(read_vector("(0 0 1 1")) << "what is not closed lacks something";
    EXPECT_FALSE(read_vector("(0, 1), p = 1)"));
    EXPECT_FALSE(read_vector("T ="));
    EXPECT_FALSE(read_vector("p = 3"));
    EXPECT_EQ(read_vector("0, 1, ..., 3.5").error(), "the knots from 1 do not lead to 3.5 in steps of 1");
    EXPECT_EQ(read_vector("0 ... -3").error(), "the knots from 0 do not lead to -3 in steps of 1");
    EXPECT_EQ(read_vector("0 ... 1e9").error(), "that would be 1e+09 knots; at most 100000 can be written so");
    EXPECT_EQ(read_vector("(0, 1) 1.5").error(), "the degree is 1.5; a whole number is needed");
    EXPECT_FALSE(read_vector("(0, 1) 1e300"));
    EXPECT_FALSE(read_vector("0 0 x 1"));
}

TEST(KnotText, is_told_from_commands) {
    for (const char* vector :
         {"0 0 1 1", "0,0,1,1", "(0, ..., 7)", "T = 0 1 2", "[0 1]", "-1 0 1", ".5 1", "0 1 2 p = 1"})
        EXPECT_TRUE(is_typed_vector(vector)) << vector;
    for (const char* other : {"", " ", "7", "insert-knot 0.5", "2 circles", "polyline 0,0,1,1", "t", "a"})
        EXPECT_FALSE(is_typed_vector(other)) << other;
}

TEST(KnotText, writes_a_long_vector_short) {
    EXPECT_EQ(vector_text(Knots{0, 0, 0.5, 1, 1}), "(0, 0, 0.5, 1, 1)");
    EXPECT_EQ(vector_text({}), "()");
    Knots many;
    for (int i = 0; i < 1000; ++i) many.push_back(i);
    EXPECT_EQ(vector_text(many), "(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, …, 994, 995, 996, 997, 998, 999)");
    EXPECT_EQ(knots_of(vector_text(many)), many);
}

}  // namespace
}  // namespace batten::editor
