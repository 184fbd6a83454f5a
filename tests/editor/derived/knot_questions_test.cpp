#include "app/editor/derived/knot_questions.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace batten::editor {
namespace {

using enum KnotQuestion;

KnotAnswers about(int degree, std::vector<double> knots, core::Tears tears = core::Tears::refuse) {
    return answers_about(core::KnotVector::make(degree, std::move(knots), core::KnotKind::custom, tears).value());
}

KnotAnswers about_period(int degree, std::vector<double> period) {
    return answers_about(core::KnotVector::make_periodic(degree, std::move(period)).value());
}

std::string whole_answer(const KnotAnswers& answers) {
    std::string text;
    for (const KnotQuestion question : all_knot_questions) text += answer_text(answers, question) + "|";
    return text;
}

TEST(KnotQuestions, are_answered_as_the_reference_results) {
    std::ifstream file(BATTEN_TEST_DATA "/golden/knot_analysis.json");
    const auto cases = nlohmann::json::parse(file)["cases"];
    ASSERT_GT(cases.size(), 20U);
    for (const auto& known : cases) {
        const KnotAnswers answers = about(known["degree"], known["knots"]);
        EXPECT_EQ(answers.control_points, known["control_points"]) << known["name"];
        EXPECT_EQ(answers.segments, known["segments"]) << known["name"];
        EXPECT_EQ(answers.is_uniform, known["uniform"]) << known["name"];
        EXPECT_EQ(answers.continuity.has_value(), !known["continuity"].is_null()) << known["name"];
        if (answers.continuity) {
            EXPECT_EQ(*answers.continuity, known["continuity"]) << known["name"];
        }
        EXPECT_EQ(answers.uneven.has_value() || answers.roughest.value_or(core::DistinctKnot{}).multiplicity > 1,
                  !known["uniform"])
            << known["name"];
    }
}

TEST(KnotQuestions, of_the_lecture) {
    EXPECT_EQ(whole_answer(about(4, {0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6, 6})), "uniform|4|6|10|C^{3}|");
    EXPECT_EQ(whole_answer(about(3, {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7})), "not uniform|3|4|7|C^{2}|");
    EXPECT_EQ(whole_answer(about(2, {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5})), "not uniform|2|5|8|C^{0}|");
    EXPECT_EQ(whole_answer(about(3, {0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 5, 5, 5, 5})), "not uniform|3|5|11|C^{0}|");
    EXPECT_EQ(whole_answer(about(3, {0, 1, 2, 3, 4, 5, 6, 7})), "uniform|3|1|4|C^{∞}|");
    EXPECT_EQ(whole_answer(about_period(2, {0, 1, 2, 2, 3})), "not uniform|2|3|4|C^{0}|");
    EXPECT_EQ(whole_answer(about(1, {0, 0, 1, 1, 2, 2}, core::Tears::allow)), "not uniform|1|2|4|jump|");
}

TEST(KnotQuestions, are_explained_for_clamped_knots) {
    const KnotAnswers uneven = about(3, {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7});
    EXPECT_EQ(explanation(uneven, uniform), "from 0 to 1 the step is 1, from 1 to 3 it is 2");
    EXPECT_EQ(explanation(uneven, degree),
              "the first and the last knot occur p + 1 = 4 times each, because the ends are clamped");
    EXPECT_EQ(explanation(uneven, segments), "3 different knots divide the domain from 0 to 7 into 4 segments");
    EXPECT_EQ(explanation(uneven, control_points), "as many as knots − p − 1 = 11 − 3 − 1 = 7");
    EXPECT_EQ(explanation(uneven, continuity), "all inner knots are simple: p − 1 = 3 − 1 = 2");
    const KnotAnswers multiple = about(3, {0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 5, 5, 5, 5});
    EXPECT_EQ(explanation(multiple, uniform), "knot 2 occurs 3 times, so that a step there is 0");
    EXPECT_EQ(explanation(multiple, continuity), "knot 2 occurs m = 3 times, the most inside: p − m = 3 − 3 = 0");
    const KnotAnswers even = about(2, {0, 0, 0, 0.5, 1, 1, 1});
    EXPECT_EQ(explanation(even, uniform),
              "inside the clamped ends the knots are simple and all steps between them are 0.5");
    EXPECT_EQ(explanation(even, segments), "one knot value divides the domain from 0 to 1 into 2 segments");
    const KnotAnswers bezier = about(2, {0, 0, 0, 1, 1, 1});
    EXPECT_EQ(explanation(bezier, uniform),
              "the domain from 0 to 1 is one segment, and there is no other to differ from it");
    EXPECT_EQ(explanation(bezier, segments), "no knot lies inside the domain from 0 to 1, so that it is one segment");
    EXPECT_EQ(explanation(bezier, continuity),
              "there is no knot inside the domain, so that the curve is a single piece");
    EXPECT_EQ(explanation(about(1, {0, 0, 1, 1, 2, 2}, core::Tears::allow), continuity),
              "knot 1 occurs p + 1 = 2 times, so that the curve may come apart there");
}

TEST(KnotQuestions, are_explained_for_other_knots) {
    const KnotAnswers open = about(2, {0, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_EQ(explanation(open, uniform), "all knots are simple and all steps between them are 1");
    const KnotAnswers outside = about(1, {-5, 0, 2, 4, 5});
    EXPECT_EQ(explanation(outside, uniform), "the knots of the domain are simple and all steps between them are 2");
    EXPECT_EQ(
        explanation(open, degree),
        "p = 8 knots − 5 control points − 1 = 2; the ends are not clamped, so that the knots alone do not tell it");
    EXPECT_EQ(explanation(open, segments), "2 different knots divide the domain from 2 to 5 into 3 segments");
    const KnotAnswers closed = about_period(2, {0, 1, 2, 2, 3});
    EXPECT_EQ(explanation(closed, uniform), "knot 2 occurs 2 times, so that a step there is 0");
    EXPECT_EQ(explanation(closed, degree), "one period of knots does not tell the degree; it is given with them");
    EXPECT_EQ(explanation(closed, segments),
              "the period from 0 to 3 has 3 different knots, each of which begins a segment");
    EXPECT_EQ(explanation(closed, control_points), "n control points have n + 1 knots of one period: n = 5 − 1 = 4");
    EXPECT_EQ(explanation(about_period(2, {0, 1, 3, 4}), uniform), "from 0 to 1 the step is 1, from 1 to 3 it is 2");
    EXPECT_EQ(explanation(about_period(2, {0, 1, 2, 4}), uniform), "from 1 to 2 the step is 1, from 2 to 4 it is 2");
}

TEST(KnotQuestions, write_knots_as_they_are_told_to) {
    EXPECT_EQ(explanation(about(1, {0, 0, 0.25, 1, 1}), uniform, [](double) { return "x"; }),
              "from x to x the step is x, from x to x it is x");
}

TEST(KnotQuestions, take_rounding_for_none) {
    std::vector<double> knots{0};
    for (int i = 0; i <= 10; ++i) knots.push_back(0.1 * i);
    knots.push_back(1.0);
    const KnotAnswers answers = about(1, knots);
    EXPECT_TRUE(answers.is_uniform);
    EXPECT_FALSE(answers.uneven);
}

}  // namespace
}  // namespace batten::editor
