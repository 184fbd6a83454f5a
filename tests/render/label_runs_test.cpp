#include "render/label_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace batten::render {
namespace {

struct Expected {
    const char* text;
    Script script;
    bool is_stacked;
};

void expect_runs(const char* label, const std::vector<Expected>& expected) {
    const std::vector<LabelRun> runs = label_runs(label);
    ASSERT_EQ(runs.size(), expected.size()) << label;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(runs[i].text, expected[i].text) << label;
        EXPECT_EQ(runs[i].script, expected[i].script) << label;
        EXPECT_EQ(runs[i].is_stacked, expected[i].is_stacked) << label;
    }
}

TEST(LabelRuns, are_the_text_itself_where_there_are_no_scripts) {
    expect_runs("", {});
    expect_runs("C(u) = 2", {{"C(u) = 2", Script::none, false}});
    expect_runs("a_b^c", {{"a_b^c", Script::none, false}});
}

TEST(LabelRuns, stack_the_second_of_two_different_scripts) {
    expect_runs("P_{3}^{1} = x", {{"P", Script::none, false},
                                  {"3", Script::sub, false},
                                  {"1", Script::super, true},
                                  {" = x", Script::none, false}});
    expect_runs("x^{2}_{i}", {{"x", Script::none, false}, {"2", Script::super, false}, {"i", Script::sub, true}});
    expect_runs("x^{2}^{3}", {{"x", Script::none, false}, {"2", Script::super, false}, {"3", Script::super, false}});
    expect_runs("_{1}^{2}_{3}", {{"1", Script::sub, false}, {"2", Script::super, true}, {"3", Script::sub, false}});
}

TEST(LabelRuns, stand_farther_apart_where_the_upper_one_reaches_down) {
    const auto shifts = [](const char* label) {
        const std::vector<LabelRun> runs = label_runs(label);
        return std::vector<double>{runs.at(0).shift, runs.at(1).shift, runs.at(2).shift};
    };
    EXPECT_EQ(shifts("P_{3}^{1}"), (std::vector<double>{0.0, 0.3, -0.3}));
    for (const char* label : {"P_{i+1}^{(k)}", "P^{(k)}_{i+1}"}) {
        const std::vector<double> found = shifts(label);
        EXPECT_EQ(found[1], -found[2]) << label;
        EXPECT_GT(std::abs(found[1]), 0.35) << label;
        EXPECT_EQ(found[1] > 0.0, label[1] == '_') << label;
    }
    EXPECT_EQ(shifts("P^{(1)}x"), (std::vector<double>{0.0, -0.3, 0.0})) << "nothing stands below it";
}

TEST(LabelRuns, reach_to_the_end_of_a_text_that_lacks_it) {
    expect_runs("P_{12", {{"P", Script::none, false}, {"12", Script::sub, false}});
}

}  // namespace
}  // namespace batten::render
