/// A quiz on knot vectors: vectors of every kind by number, what may be answered, and the marks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/editor/derived/knot_questions.h"

namespace batten::editor {

/// What vectors the quiz makes, in turn.
enum class QuizKind {
    clamped_uniform,
    uniform,         ///< unclamped, like (0, ..., 7)
    clamped_uneven,  ///< simple knots at different steps
    multiple_knots,
    bezier,
    full_multiplicity,  ///< every inner knot p times
    periodic,
    unclamped_uneven
};
inline constexpr std::size_t quiz_kind_count = 8;

/// Of which kind vector `number` is: each of eight in a row is another.
QuizKind quiz_kind(std::size_t number);

/// Vector `number` of the quiz, the same always: of degree 1 to 5 and a dozen knots or so. Vector 1 is (0, ..., 7) of
/// degree 3.
core::KnotVector quiz_vector(std::size_t number);

/// Whether the quiz asks for it: not for the degree where the ends are not clamped, which is given with the knots then.
bool is_asked(const core::KnotVector& knots, KnotQuestion question);

/// One of the answers that are offered: the right one, and what is often said instead.
struct QuizOption {
    std::string name;   ///< as it is typed: "yes", "3", "infinite"
    std::string label;  ///< in the label notation
    bool is_right = false;
};

/// Two to five answers in their natural order, the right one among them.
std::vector<QuizOption> quiz_options(const core::KnotVector& knots, KnotQuestion question);

/// What was typed as the name of an option, "C^2" as "2", whether it is offered or not; empty where it is no answer to
/// this question.
std::string quiz_answer(KnotQuestion question, const std::string& typed);

/// A quiz under way.
struct KnotQuiz {
    std::size_t number = 0;
    core::KnotVector knots;
    std::array<std::string, all_knot_questions.size()> given{};  ///< names of options; empty where nothing was said
    std::size_t right_before = 0;                                ///< answers to the vectors before
    std::size_t given_before = 0;

    const std::string& answer_to(KnotQuestion question) const { return given[static_cast<std::size_t>(question)]; }

    /// Whether the answer to `question`, which there is, is right.
    bool is_right(KnotQuestion question) const;

    /// The answers so far, and how many of them are right.
    std::size_t right_count() const;
    std::size_t given_count() const;
};

}  // namespace batten::editor
