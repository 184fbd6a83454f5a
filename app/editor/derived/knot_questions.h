/// The five questions of a lecture about any knot vector, their answers, and why they are so.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "core/base/names.h"
#include "core/base/number_text.h"
#include "core/curve/knot_analysis.h"

namespace batten::editor {

enum class KnotQuestion { uniform, degree, segments, control_points, continuity };
inline constexpr std::array all_knot_questions{KnotQuestion::uniform, KnotQuestion::degree, KnotQuestion::segments,
                                               KnotQuestion::control_points, KnotQuestion::continuity};

/// The answers, and what their explanations name.
struct KnotAnswers {
    bool is_uniform = false;
    int degree = 0;
    std::size_t segments = 0;
    std::size_t control_points = 0;
    std::optional<int> continuity{};  ///< the least at an inner knot, -1 for a tear; none where there is no such knot

    std::size_t knot_count = 0;  ///< of stored()
    bool is_periodic = false;
    bool is_clamped = false;
    bool is_even = false;  ///< all knots are simple and equally spaced, also outside of the domain
    core::Interval domain{};
    std::optional<core::DistinctKnot> roughest{};   ///< the first inner knot of the highest multiplicity
    std::optional<std::array<double, 3>> uneven{};  ///< the first neighbors in the domain between which steps differ
};

/// Cost O(n).
KnotAnswers answers_about(const core::KnotVector& knots);

/// "How many segments?"
std::string question_text(KnotQuestion question);

/// "7", "not uniform", in the label notation: "C^{2}".
std::string answer_text(const KnotAnswers& answers, KnotQuestion question);

/// How knots are written.
using NumberWriter = std::function<std::string(double)>;

/// One sentence that says why.
std::string explanation(const KnotAnswers& answers, KnotQuestion question,
                        const NumberWriter& text_of = core::shortest_text);

/// "C^{2}" for 2, "C^{∞}" for none, "jump" for -1.
std::string smoothness_text(std::optional<int> continuity);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::KnotQuestion> {
    using enum editor::KnotQuestion;
    static constexpr std::array table{Named{uniform, "uniform", "Uniform or not?"},
                                      Named{degree, "degree", "Which degree?"},
                                      Named{segments, "segments", "How many segments?"},
                                      Named{control_points, "control-points", "How many control points?"},
                                      Named{continuity, "continuity", "Which continuity?"}};
};

}  // namespace batten::core
