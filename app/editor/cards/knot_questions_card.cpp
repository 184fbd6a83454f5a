#include "app/editor/cards/knot_questions_card.h"

#include "app/editor/commands/knot_question_commands.h"
#include "app/editor/words/knot_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

// What the buttons that hide and show are called.
const char* short_name(KnotQuestion question) {
    static constexpr std::array names{"uniform", "degree", "segments", "points", "continuity"};
    return names[static_cast<std::size_t>(question)];
}

bool is_hidden(const EditorState& state, KnotQuestion question) {
    return state.view.hidden_answers.test(static_cast<std::size_t>(question));
}

// Where the order is told beside the degree.
std::string answer_for(const EditorState& state, const KnotAnswers& answers, KnotQuestion question) {
    std::string answer = answer_text(answers, question);
    if (question != KnotQuestion::degree || state.view.notation.degree != DegreeOrOrder::order) return answer;
    return sentence("{degree}, order k = p + 1 = {order}", {{"degree", answer}, {"order", answers.degree + 1}});
}

// The knot that decides how smooth the curve is.
Hover deciding_knot(const core::KnotVector& knots, const KnotAnswers& answers, KnotQuestion question) {
    if (question != KnotQuestion::continuity || !answers.roughest || knots.is_periodic()) return {};
    const core::DistinctKnot& knot = *answers.roughest;
    return HoveredKnot{knot.first + static_cast<std::size_t>(knot.multiplicity) - 1};
}

void add_question(Card& card, const EditorState& state, const core::KnotVector& knots, KnotQuestion question) {
    const KnotAnswers& answers = *state.derived.answers_about(knots);
    const core::Place asked("question", question_text(question));
    if (is_hidden(state, question)) {
        card.add(CardLine{{.text = sentence("{question} …", {asked}),
                           .tone = CardTone::strong,
                           .command = ToggleAnswer{.question = question}}});
        return;
    }
    const auto text_of = [&](double value) { return exact_text(state.view.notation, value); };
    card.add(
        CardLine{{.text = sentence("{question} {answer}", {asked, {"answer", answer_for(state, answers, question)}}),
                  .tone = CardTone::strong,
                  .command = ToggleAnswer{.question = question}}});
    card.add(CardLine{{.text = explanation(answers, question, text_of),
                       .tone = CardTone::dim,
                       .hover = deciding_knot(knots, answers, question)}});
}

CardButtons switches(const EditorState& state) {
    CardButtons row;
    for (const KnotQuestion question : all_knot_questions)
        row.buttons.push_back({short_name(question), ToggleAnswer{.question = question}, !is_hidden(state, question)});
    row.buttons.push_back({"Show all", ShowAnswers{.shown = true}});
    row.buttons.push_back({"Hide all", ShowAnswers{.shown = false}});
    return row;
}

}  // namespace

Card knot_questions_card(const EditorState& state) {
    Card card{"Knot questions", {}};
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) {
        card.line("There is no curve. A knot vector typed in the command palette, like 0 0 0 1 2 2 2, makes one.");
        card.add(CardButtons{
            {{"Sample curve", SampleCurve{.knots = "0 0 0 0 1 2 2 2 2", .degree = std::nullopt, .periodic = false}}}});
        return card;
    }
    const core::KnotVector& knots = curve->knots();
    const auto text_of = [&](double value) { return exact_text(state.view.notation, value); };
    card.formula(sentence("U = {knots}", {{"knots", vector_text(knots.stored(), text_of)}}));
    if (knots.is_periodic()) card.line("one period of a closed curve", CardTone::dim);
    for (const KnotQuestion question : all_knot_questions) add_question(card, state, knots, question);
    card.add(switches(state));
    return card;
}

}  // namespace batten::editor
