#include "app/editor/commands/knot_question_commands.h"

#include <array>
#include <cmath>
#include <numbers>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/derived/knot_quiz.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/knot_text.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/curve/knot_kinds.h"

namespace batten::editor {

namespace {

using core::sentence;

// How often the first and the last knot occur, less one, where that is the same and more than once.
std::optional<int> degree_by_ends(const std::vector<double>& knots) {
    const auto first = std::ranges::count(knots, knots.front());
    if (first < 2 || first != std::ranges::count(knots, knots.back()) || knots.front() == knots.back())
        return std::nullopt;
    return static_cast<int>(first) - 1;
}

Outcome<core::KnotVector> vector_of(const SampleCurve& command) {
    const Outcome<TypedVector> typed = read_vector(command.knots);
    if (!typed) return tl::unexpected(typed.error());
    std::optional<int> degree = command.degree ? command.degree : typed->degree;
    if (!degree && !command.periodic) degree = degree_by_ends(typed->knots);
    if (!degree)
        return tl::unexpected(
            sentence("the knots {knots} do not tell their degree, because their ends are not clamped; it is needed "
                     "behind them, like p = 3",
                     {{"knots", vector_text(typed->knots)}}));
    const auto knots = command.periodic ? core::KnotVector::make_periodic(*degree, typed->knots)
                                        : core::KnotVector::make(*degree, typed->knots);
    if (!knots) return refused(std::nullopt, knots.error());
    return *knots;
}

// A wave over whole numbers, so that what is computed with it is easy to follow.
std::vector<core::Point> wave(std::size_t count) {
    constexpr std::array heights{0.0, 2.0, 3.0, 1.0, -1.0};
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(static_cast<double>(i), heights[i % heights.size()]);
    return points;
}

// The corners of a star around (0, 0).
std::vector<core::Point> star(std::size_t count) {
    std::vector<core::Point> points;
    const double radius = std::max(2.0, static_cast<double>(count) / 3.0);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        const double reach = i % 2 == 0 ? radius : 1.5 * radius;
        points.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
    }
    return points;
}

Outcome<Edit> sample_curve(const EditorState& state, const SampleCurve& command) {
    const Outcome<core::KnotVector> knots = vector_of(command);
    if (!knots) return tl::unexpected(knots.error());
    const std::size_t count = knots->control_point_count();
    core::Result<core::Curve> curve =
        core::Curve::make(*knots, command.periodic ? star(count) : wave(count), std::vector<double>(count, 1.0));
    if (!curve) return refused(state, curve.error());
    return with_curve(state, "sample", *std::move(curve));
}

StepTexts texts_of_sample(const EditorState&, const SampleCurve&, const core::Curve& curve) {
    const core::Place knots("knots", vector_text(curve.knots().stored()));
    return {sentence("Make sample curve over {knots}", {knots}),
            sentence("Made sample curve of degree {degree} over {knots}", {{"degree", curve.degree()}, knots})};
}

Outcome<void> toggle_answer(EditorState& state, const ToggleAnswer& command) {
    state.view.hidden_answers.flip(static_cast<std::size_t>(command.question));
    return {};
}

Outcome<void> show_answers(EditorState& state, const ShowAnswers& command) {
    if (command.shown)
        state.view.hidden_answers.reset();
    else
        state.view.hidden_answers.set();
    return {};
}

Outcome<void> ask_quiz(EditorState& state, const AskQuiz& command) {
    KnotQuiz next{.number = command.number, .knots = quiz_vector(command.number)};
    if (state.quiz) {
        next.right_before = state.quiz->right_count();
        next.given_before = state.quiz->given_count();
    }
    state.quiz = std::move(next);
    state.view.overlays.show(Overlay::quiz, true);
    return {};
}

Outcome<void> answer_quiz(EditorState& state, const AnswerQuiz& command) {
    KnotQuiz& quiz = *state.quiz;
    if (!is_asked(quiz.knots, command.question))
        return tl::unexpected(
            Refusal("the degree is given with these knots and not asked for, because their ends are not clamped"));
    std::string answer = quiz_answer(command.question, command.answer);
    if (answer.empty())
        return tl::unexpected(sentence("'{answer}' is no answer to the question '{question}'",
                                       {{"answer", command.answer}, {"question", question_text(command.question)}}));
    quiz.given[static_cast<std::size_t>(command.question)] = std::move(answer);
    const core::Place why("why", explanation(answers_about(quiz.knots), command.question));
    state.message = {sentence(quiz.is_right(command.question) ? "Right: {why}" : "Not right: {why}", {why}), false};
    return {};
}

Outcome<void> end_quiz(EditorState& state, const EndQuiz&) {
    const core::Place right("right", state.quiz->right_count());
    const core::Place count("count", state.quiz->given_count());
    state.message = {sentence("The quiz is over; right answers: {right} of {count}", {right, count}), false};
    state.quiz.reset();
    return {};
}

std::optional<Refusal> no_quiz(const EditorState& state) {
    if (state.quiz) return std::nullopt;
    return "no quiz is under way; 'Knot quiz' begins one";
}

std::size_t next_number(const EditorState& state) {
    return state.quiz ? state.quiz->number + 1 : 1;
}

std::string lecture_knots(const EditorState&) {
    return "0 0 0 0 1 2 2 2 2";
}

template <class Command>
Field question_field() {
    return field::choice<&Command::question>("question", "which of the five");
}

}  // namespace

const CommandSpec& SampleCurve::spec() {
    static const CommandSpec spec{
        .name = "sample-curve",
        .title = "Sample curve over knots",
        .explanation = "Adds a curve of even points over the knots that are typed, so that they can be seen at work.",
        .synonyms = "knot vector T U type",
        .group = CommandGroup::make,
        .fields = {field::text<&SampleCurve::knots>("knots", "all of them, like 0 0 0 1 2 2 2 or (0, ..., 7)")
                       .beginning_with<lecture_knots>(),
                   field::count<&SampleCurve::degree>("degree", "as clamped ends tell it where it is left out"),
                   field::flag<&SampleCurve::periodic>("periodic",
                                                       "yes where the knots are one period of a closed curve")
                       .usually(false)},
        .run = body_of<sample_curve>,
        .texts = texts_of<texts_of_sample>};
    return spec;
}

const CommandSpec& ToggleAnswer::spec() {
    static const CommandSpec spec{.name = "toggle-answer",
                                  .title = "Hide or show an answer",
                                  .explanation = "Hides the answer to one of the questions about knots, or shows it.",
                                  .synonyms = "question uniform degree segments control points continuity",
                                  .group = CommandGroup::construct,
                                  .submenu = "Knot questions",
                                  .offered = in_the_window,
                                  .fields = {question_field<ToggleAnswer>()},
                                  .run = body_of<toggle_answer>};
    return spec;
}

const CommandSpec& ShowAnswers::spec() {
    static const CommandSpec spec{
        .name = "show-answers",
        .title = "Show all answers",
        .explanation = "Shows the answers to all questions about knots, or hides them.",
        .synonyms = "hide questions",
        .group = CommandGroup::construct,
        .submenu = "Knot questions",
        .offered = in_the_window,
        .fields = {field::flag<&ShowAnswers::shown>("shown", "no to hide them").usually(true)},
        .run = body_of<show_answers>};
    return spec;
}

const CommandSpec& AskQuiz::spec() {
    static const CommandSpec spec{
        .name = "knot-quiz",
        .title = "Knot quiz",
        .explanation = "Makes a knot vector to answer questions about; the same number makes the same vector.",
        .synonyms = "questions exercise test",
        .group = CommandGroup::construct,
        .submenu = "Knot questions",
        .offered = in_the_window,
        .fields = {field::count<&AskQuiz::number>("number", "which vector").suggesting<next_number>()},
        .run = body_of<ask_quiz>};
    return spec;
}

const CommandSpec& AnswerQuiz::spec() {
    static const CommandSpec spec{
        .name = "answer-quiz",
        .title = "Answer quiz",
        .explanation = "Answers one of the questions of the knot quiz and says whether that is right.",
        .synonyms = "mark",
        .group = CommandGroup::construct,
        .submenu = "Knot questions",
        .offered = in_the_window,
        .fields = {question_field<AnswerQuiz>(),
                   field::text<&AnswerQuiz::answer>("answer", "yes or no, a number, C2, or infinite")},
        .refusal = no_quiz,
        .run = body_of<answer_quiz>};
    return spec;
}

const CommandSpec& EndQuiz::spec() {
    static const CommandSpec spec{.name = "end-quiz",
                                  .title = "End quiz",
                                  .explanation = "Ends the knot quiz and says how many answers were right.",
                                  .group = CommandGroup::construct,
                                  .submenu = "Knot questions",
                                  .offered = in_the_window,
                                  .refusal = no_quiz,
                                  .run = body_of<end_quiz>};
    return spec;
}

void add_knot_question_commands(CommandTable& table) {
    add_all<SampleCurve, ToggleAnswer, ShowAnswers, AskQuiz, AnswerQuiz, EndQuiz>(table);
}

}  // namespace batten::editor
