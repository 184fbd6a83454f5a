/// Commands that ask about knot vectors: a sample curve over a typed one, the answers on the card, and the quiz.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "app/editor/derived/knot_questions.h"

namespace batten::editor {

struct SampleCurve {
    std::string knots;          ///< as people type them (knot_text.h)
    std::optional<int> degree;  ///< none: as typed behind the knots, else as the clamped ends say
    bool periodic;
    static const CommandSpec& spec();
};

/// Hides an answer on the card, or shows it again.
struct ToggleAnswer {
    KnotQuestion question;
    static const CommandSpec& spec();
};

struct ShowAnswers {
    bool shown;
    static const CommandSpec& spec();
};

/// Begins the quiz, or goes on to another vector.
struct AskQuiz {
    std::size_t number;
    static const CommandSpec& spec();
};

struct AnswerQuiz {
    KnotQuestion question;
    std::string answer;
    static const CommandSpec& spec();
};

struct EndQuiz {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
