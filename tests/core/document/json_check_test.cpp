#include "core/document/json_check.h"

#include <gtest/gtest.h>

namespace batten::core {
namespace {

TEST(JsonCheck, takes_what_is_json_and_tells_the_place_of_what_is_not) {
    EXPECT_TRUE(check_json(R"({"a": [1, {"b": null}], "c": "d"})").has_value());
    EXPECT_TRUE(check_json("3").has_value());
    EXPECT_EQ(check_json("[1,\n2").error().where, "line 2, column 2");
    EXPECT_EQ(check_json("{\"a\": 1, \"a\": 2}").error().sentence(),
              "line 1, column 12: the member \"a\" occurs twice in one object; every name may occur once");
}

TEST(JsonCheck, refuses_what_cannot_be_walked_by_recursion) {
    EXPECT_TRUE(check_json(std::string(100, '[') + std::string(100, ']')).has_value());
    EXPECT_EQ(check_json(std::string(101, '[') + std::string(101, ']')).error().sentence(),
              "line 1, column 101: lists and objects are nested more than 100 deep, the most that is read");
}

}  // namespace
}  // namespace batten::core
