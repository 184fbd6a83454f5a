#include "app/editor/derived/knot_quiz.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/editor/cards/knot_questions_card.h"
#include "app/editor/cards/quiz_card.h"
#include "app/editor/commands/knot_question_commands.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using Knots = std::vector<double>;

Knots stored(const core::KnotVector& knots) {
    return {knots.stored().begin(), knots.stored().end()};
}

TEST(KnotQuiz, makes_the_same_vectors_always) {
    EXPECT_EQ(stored(quiz_vector(1)), (Knots{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(quiz_vector(1).degree(), 3);
    EXPECT_EQ(quiz_vector(77), quiz_vector(77));
    std::set<Knots> different;
    for (std::size_t number = 0; number < 80; ++number) different.insert(stored(quiz_vector(number)));
    EXPECT_GT(different.size(), 40U);
}

TEST(KnotQuiz, makes_vectors_of_every_kind) {
    for (std::size_t number = 0; number < 400; ++number) {
        const core::KnotVector knots = quiz_vector(number);
        const KnotAnswers answers = answers_about(knots);
        const int most = answers.roughest.value_or(core::DistinctKnot{}).multiplicity;
        SCOPED_TRACE(number);
        EXPECT_LE(knots.stored().size(), 24U);
        EXPECT_EQ(knots.is_periodic(), quiz_kind(number) == QuizKind::periodic);
        switch (quiz_kind(number)) {
            case QuizKind::clamped_uniform:
                EXPECT_TRUE(answers.is_clamped && answers.is_uniform && answers.segments > 1);
                break;
            case QuizKind::uniform:
                EXPECT_TRUE(core::is_of_kind(knots, core::KnotKind::uniform));
                break;
            case QuizKind::clamped_uneven:
                EXPECT_TRUE(answers.is_clamped && !answers.is_uniform && most == 1);
                break;
            case QuizKind::multiple_knots:
                EXPECT_TRUE(answers.is_clamped && most > 1);
                break;
            case QuizKind::bezier:
                EXPECT_TRUE(core::is_of_kind(knots, core::KnotKind::bezier));
                break;
            case QuizKind::full_multiplicity:
                EXPECT_TRUE(answers.continuity == 0 && core::is_of_kind(knots, core::KnotKind::piecewise_bezier));
                break;
            case QuizKind::periodic:
                EXPECT_GE(answers.segments, 3U);
                break;
            case QuizKind::unclamped_uneven:
                EXPECT_TRUE(!answers.is_clamped && most <= 1);
                break;
        }
    }
}

TEST(KnotQuiz, offers_one_right_answer_among_others) {
    for (std::size_t number = 0; number < 400; ++number) {
        const core::KnotVector knots = quiz_vector(number);
        const KnotAnswers answers = answers_about(knots);
        for (const KnotQuestion question : all_knot_questions) {
            const std::vector<QuizOption> options = quiz_options(knots, question);
            SCOPED_TRACE(number);
            EXPECT_GE(options.size(), 2U);
            EXPECT_LE(options.size(), 5U);
            std::set<std::string> names;
            for (const QuizOption& option : options) {
                EXPECT_TRUE(names.insert(option.name).second) << option.name;
                EXPECT_EQ(quiz_answer(question, option.name), option.name);
                EXPECT_EQ(option.is_right, option.label == answer_text(answers, question)) << option.label;
            }
            EXPECT_EQ(std::ranges::count_if(options, &QuizOption::is_right), 1);
        }
    }
}

TEST(KnotQuiz, reads_answers_as_people_write_them) {
    EXPECT_EQ(quiz_answer(KnotQuestion::continuity, "C^2"), "2");
    EXPECT_EQ(quiz_answer(KnotQuestion::continuity, "c 1"), "1");
    EXPECT_EQ(quiz_answer(KnotQuestion::continuity, "jump"), "-1");
    EXPECT_EQ(quiz_answer(KnotQuestion::continuity, "Infinite"), "infinite");
    EXPECT_EQ(quiz_answer(KnotQuestion::uniform, "Not uniform"), "no");
    EXPECT_EQ(quiz_answer(KnotQuestion::uniform, "3"), "");
    EXPECT_EQ(quiz_answer(KnotQuestion::degree, " 3 "), "3");
    EXPECT_EQ(quiz_answer(KnotQuestion::degree, "three"), "");
    EXPECT_EQ(quiz_answer(KnotQuestion::segments, ""), "");
}

class KnotQuestionCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool type(const std::string& text) { return run_typed(editor_, text); }

    Editor editor_;
};

TEST_F(KnotQuestionCommands, make_a_sample_curve_over_a_typed_vector) {
    EXPECT_TRUE(type("0 0 0 1 2 3 3 3"));
    EXPECT_EQ(message(), "Made sample curve of degree 2 over (0, 0, 0, 1, 2, 3, 3, 3)");
    EXPECT_EQ(curve(editor_).degree(), 2);
    EXPECT_EQ(knots(editor_), (Knots{0, 0, 0, 1, 2, 3, 3, 3}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {1, 2}, {2, 3}, {3, 1}, {4, -1}}));
    EXPECT_TRUE(type("T = (0, ..., 7), p = 3"));
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_TRUE(type("sample-curve \"0 0 0 1 2 3 3 3\" 2"));
    EXPECT_TRUE(type("sample-curve 0,0,0,0,1,1,1,1"));
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_TRUE(type("sample-curve (0,...,5) 2 yes"));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 5U);
    EXPECT_EQ(document(editor_).curves.size(), 5U);
}

TEST_F(KnotQuestionCommands, refuse_what_is_no_vector) {
    EXPECT_FALSE(type("0 1 2 3 4 5 6 7"));
    EXPECT_EQ(message(),
              "the knots (0, 1, 2, 3, 4, 5, 6, 7) do not tell their degree, because their ends are not clamped; it is "
              "needed behind them, like p = 3");
    EXPECT_FALSE(type("0 0 0 2 1 3 3 3"));
    EXPECT_EQ(message(), "knot 4 is 1, less than knot 3, which is 2; knots must not decrease");
    EXPECT_FALSE(type("1 1 1 1"));
    EXPECT_FALSE(type("0 0 1 1 p = 3"));
    EXPECT_EQ(message().rfind("4 knots were found", 0), 0U) << message();
    EXPECT_TRUE(document(editor_).curves.empty());
}

TEST_F(KnotQuestionCommands, hide_and_show_answers_one_by_one) {
    EXPECT_NE(card_text(knot_questions_card(state())).find("There is no curve"), std::string::npos);
    type("0 0 0 0 1 3 4 7 7 7 7");
    std::string text = card_text(knot_questions_card(state()));
    EXPECT_EQ(
        text.rfind("Knot questions\nU = (0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7)\nUniform or not? not uniform\nfrom 0 to 1 "
                   "the step is 1, from 1 to 3 it is 2\nWhich degree? 3\n",
                   0),
        0U)
        << text;
    EXPECT_NE(text.find("Which continuity? C²\n"), std::string::npos) << text;
    type("toggle-answer degree");
    text = card_text(knot_questions_card(state()));
    EXPECT_NE(text.find("\nWhich degree? …\nHow many segments? 4\n"), std::string::npos) << text;
    type("show-answers no");
    text = card_text(knot_questions_card(state()));
    EXPECT_NE(text.find("\nUniform or not? …\nWhich degree? …\nHow many segments? …\nHow many control points? …\nWhich "
                        "continuity? …\n"),
              std::string::npos)
        << text;
    type("show-answers");
    EXPECT_TRUE(state().view.hidden_answers.none());
}

TEST_F(KnotQuestionCommands, keep_the_card_short_whatever_the_curve) {
    std::string many = "(0, ..., 20000) 25";
    EXPECT_TRUE(type(many)) << message();
    const std::string text = card_text(knot_questions_card(state()));
    EXPECT_NE(text.find("(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, …, 19995, "), std::string::npos) << text;
    EXPECT_NE(text.find("How many segments? 19950\n"), std::string::npos) << text;
}

TEST_F(KnotQuestionCommands, ask_and_mark) {
    EXPECT_FALSE(type("answer-quiz uniform yes"));
    EXPECT_EQ(message(), "no quiz is under way; 'Knot quiz' begins one");
    EXPECT_NE(card_text(quiz_card(state())).find("Begin"), std::string::npos);
    EXPECT_TRUE(type("knot-quiz"));
    EXPECT_TRUE(state().view.overlays.is_shown(Overlay::quiz));
    ASSERT_TRUE(state().quiz);
    EXPECT_EQ(state().quiz->number, 1U);
    std::string text = card_text(quiz_card(state()));
    EXPECT_NE(text.find("U = (0, 1, 2, 3, 4, 5, 6, 7)\nfor a curve of degree p = 3\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("Which degree?"), std::string::npos);
    EXPECT_EQ(text.find("ight:"), std::string::npos);
    EXPECT_TRUE(type("answer-quiz control-points 4"));
    EXPECT_EQ(message(), "Right: as many as knots − p − 1 = 8 − 3 − 1 = 4");
    EXPECT_TRUE(type("answer-quiz segments 7"));
    EXPECT_EQ(message(), "Not right: no knot lies inside the domain from 3 to 4, so that it is one segment");
    EXPECT_TRUE(type("answer-quiz continuity infinite"));
    EXPECT_FALSE(type("answer-quiz degree 3"));
    EXPECT_EQ(message(), "the degree is given with these knots and not asked for, because their ends are not clamped");
    EXPECT_FALSE(type("answer-quiz segments many"));
    EXPECT_EQ(message(), "'many' is no answer to the question 'How many segments?'");
    text = card_text(quiz_card(state()));
    EXPECT_NE(text.find("Right so far: 2 of 3"), std::string::npos) << text;
    EXPECT_NE(text.find("\nNot right: no knot lies inside"), std::string::npos) << text;
    EXPECT_TRUE(type("knot-quiz"));
    EXPECT_EQ(state().quiz->number, 2U);
    EXPECT_EQ(state().quiz->right_count(), 2U);
    EXPECT_EQ(state().quiz->given_count(), 3U);
    EXPECT_TRUE(type("end-quiz"));
    EXPECT_EQ(message(), "The quiz is over; right answers: 2 of 3");
    EXPECT_FALSE(state().quiz);
}

// What the card's button makes is the vector that is asked about.
TEST_F(KnotQuestionCommands, show_the_curve_of_every_vector_of_the_quiz) {
    for (std::size_t number = 1; number < 60; ++number) {
        editor_.run(AskQuiz{.number = number});
        const Card card = quiz_card(state());
        const CardButtons& last = std::get<CardButtons>(card.blocks.back());
        ASSERT_EQ(last.buttons[1].text, "Its curve");
        EXPECT_TRUE(editor_.run(last.buttons[1].command)) << message();
        EXPECT_EQ(knots(editor_), stored(quiz_vector(number)));
        EXPECT_EQ(curve(editor_).degree(), quiz_vector(number).degree());
    }
}

}  // namespace
}  // namespace batten::editor
