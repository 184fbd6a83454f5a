#include "app/editor/cards/quiz_card.h"

#include "app/editor/commands/knot_question_commands.h"
#include "app/editor/words/knot_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

void add_vector(Card& card, const core::KnotVector& knots) {
    card.formula(sentence("U = {knots}", {{"knots", vector_text(knots.stored())}}));
    const core::Place degree("degree", knots.degree());
    if (knots.is_periodic())
        card.line(sentence("one period of a closed curve of degree p = {degree}", {degree}));
    else if (!core::is_clamped(knots))
        card.line(sentence("for a curve of degree p = {degree}", {degree}));
}

void add_quiz_question(Card& card, const KnotQuiz& quiz, KnotQuestion question) {
    const std::string& given = quiz.answer_to(question);
    card.line(question_text(question), CardTone::strong);
    CardButtons options;
    for (const QuizOption& option : quiz_options(quiz.knots, question))
        options.buttons.push_back(
            {option.label, AnswerQuiz{.question = question, .answer = option.name}, option.name == given});
    card.add(std::move(options));
    if (given.empty()) return;
    const bool is_right = quiz.is_right(question);
    const core::Place why("why", explanation(answers_about(quiz.knots), question));
    card.line(sentence(is_right ? "Right: {why}" : "Not right: {why}", {why}),
              is_right ? CardTone::good : CardTone::bad);
}

Command sample_of(const core::KnotVector& knots) {
    return SampleCurve{.knots = vector_text(knots.stored()), .degree = knots.degree(), .periodic = knots.is_periodic()};
}

}  // namespace

Card quiz_card(const EditorState& state) {
    Card card{"Knot quiz", {}};
    if (!state.quiz) {
        card.line("Knot vectors of every kind, with questions about each; the answers are marked.");
        card.add(CardButtons{{{"Begin", AskQuiz{.number = 1}}}});
        return card;
    }
    const KnotQuiz& quiz = *state.quiz;
    card.line(sentence("Vector {number}", {{"number", quiz.number}}), CardTone::dim);
    add_vector(card, quiz.knots);
    for (const KnotQuestion question : all_knot_questions)
        if (is_asked(quiz.knots, question)) add_quiz_question(card, quiz, question);
    card.line(
        sentence("Right so far: {right} of {count}", {{"right", quiz.right_count()}, {"count", quiz.given_count()}}));
    card.add(CardButtons{{{"Next vector", AskQuiz{.number = quiz.number + 1}},
                          {"Its curve", sample_of(quiz.knots)},
                          {"End", EndQuiz{}}}});
    return card;
}

}  // namespace batten::editor
