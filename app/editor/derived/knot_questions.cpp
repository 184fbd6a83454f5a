#include "app/editor/derived/knot_questions.h"

#include <cmath>
#include <limits>

#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::Place;
using core::sentence;

// Remembers the first three neighboring knots of the domain between which the steps differ by more than rounding.
class StepWatch {
  public:
    void see(double u) {
        const double tolerance = 8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(u), std::abs(last_));
        if (seen_ > 1 && !uneven_ && std::abs((u - last_) - (last_ - before_)) > tolerance)
            uneven_ = {before_, last_, u};
        before_ = last_;
        last_ = u;
        ++seen_;
    }

    const std::optional<std::array<double, 3>>& uneven() const { return uneven_; }

  private:
    std::optional<std::array<double, 3>> uneven_{};
    double before_ = 0.0;
    double last_ = 0.0;
    int seen_ = 0;
};

std::string why_uniform(const KnotAnswers& answers, const NumberWriter& text_of) {
    const Place step("step", text_of(answers.domain.length() / static_cast<double>(answers.segments)));
    if (answers.is_even) return sentence("all knots are simple and all steps between them are {step}", {step});
    if (answers.is_uniform && answers.segments == 1)
        return sentence("the domain from {lower} to {upper} is one segment, and there is no other to differ from it",
                        {{"lower", text_of(answers.domain.lower)}, {"upper", text_of(answers.domain.upper)}});
    if (answers.is_uniform)
        return sentence(answers.is_clamped ? "inside the clamped ends the knots are simple and all steps between them "
                                             "are {step}"
                                           : "the knots of the domain are simple and all steps between them are {step}",
                        {step});
    if (answers.roughest && answers.roughest->multiplicity > 1)
        return sentence("knot {u} occurs {times} times, so that a step there is 0",
                        {{"u", text_of(answers.roughest->value)}, {"times", answers.roughest->multiplicity}});
    if (!answers.uneven) return "the steps between the knots of the domain are not all equal";
    const auto& [a, b, c] = *answers.uneven;
    return sentence("from {a} to {b} the step is {first}, from {b} to {c} it is {second}",
                    {{"a", text_of(a)},
                     {"b", text_of(b)},
                     {"c", text_of(c)},
                     {"first", text_of(b - a)},
                     {"second", text_of(c - b)}});
}

std::string why_degree(const KnotAnswers& answers) {
    if (answers.is_periodic) return "one period of knots does not tell the degree; it is given with them";
    if (answers.is_clamped)
        return sentence("the first and the last knot occur p + 1 = {order} times each, because the ends are clamped",
                        {{"order", answers.degree + 1}});
    return sentence(
        "p = {knots} knots − {points} control points − 1 = {degree}; the ends are not clamped, so that the "
        "knots alone do not tell it",
        {{"knots", answers.knot_count}, {"points", answers.control_points}, {"degree", answers.degree}});
}

std::string why_segments(const KnotAnswers& answers, const NumberWriter& text_of) {
    const Place lower("lower", text_of(answers.domain.lower));
    const Place upper("upper", text_of(answers.domain.upper));
    if (answers.is_periodic)
        return sentence(
            {.one = "the period from {lower} to {upper} has one knot value, and so one segment",
             .many = "the period from {lower} to {upper} has {count} different knots, each of which begins a "
                     "segment"},
            answers.segments, {lower, upper});
    if (answers.segments == 1)
        return sentence("no knot lies inside the domain from {lower} to {upper}, so that it is one segment",
                        {lower, upper});
    return sentence(
        {.one = "one knot value divides the domain from {lower} to {upper} into {segments} segments",
         .many = "{count} different knots divide the domain from {lower} to {upper} into {segments} segments"},
        answers.segments - 1, {lower, upper, {"segments", answers.segments}});
}

std::string why_control_points(const KnotAnswers& answers) {
    const Place knots("knots", answers.knot_count);
    const Place points("points", answers.control_points);
    if (answers.is_periodic)
        return sentence("n control points have n + 1 knots of one period: n = {knots} − 1 = {points}", {knots, points});
    return sentence("as many as knots − p − 1 = {knots} − {degree} − 1 = {points}",
                    {knots, {"degree", answers.degree}, points});
}

std::string why_continuity(const KnotAnswers& answers, const NumberWriter& text_of) {
    if (!answers.roughest) return "there is no knot inside the domain, so that the curve is a single piece";
    const Place degree("degree", answers.degree);
    const Place u("u", text_of(answers.roughest->value));
    const Place times("times", answers.roughest->multiplicity);
    const Place order("order", answers.roughest->continuity);
    if (answers.roughest->multiplicity == 1)
        return sentence("all inner knots are simple: p − 1 = {degree} − 1 = {order}", {degree, order});
    if (answers.roughest->continuity < 0)
        return sentence("knot {u} occurs p + 1 = {times} times, so that the curve may come apart there", {u, times});
    return sentence("knot {u} occurs m = {times} times, the most inside: p − m = {degree} − {times} = {order}",
                    {u, times, degree, order});
}

}  // namespace

KnotAnswers answers_about(const core::KnotVector& knots) {
    KnotAnswers answers{.is_uniform = core::is_uniform(knots),
                        .degree = knots.degree(),
                        .segments = core::segment_count(knots),
                        .control_points = knots.control_point_count(),
                        .continuity = core::least_continuity(knots),
                        .knot_count = knots.stored().size(),
                        .is_periodic = knots.is_periodic(),
                        .is_clamped = core::is_clamped(knots),
                        .is_even = core::is_of_kind(knots, core::KnotKind::uniform),
                        .domain = knots.domain()};
    StepWatch steps;
    for (const core::DistinctKnot& knot : core::distinct_knots(knots)) {
        if (knot.in_domain) steps.see(knot.value);
        if (knot.is_interior && (!answers.roughest || knot.multiplicity > answers.roughest->multiplicity))
            answers.roughest = knot;
    }
    if (knots.is_periodic()) steps.see(answers.domain.upper);
    answers.uneven = steps.uneven();
    return answers;
}

std::string question_text(KnotQuestion question) {
    return core::title_of(question);
}

std::string smoothness_text(std::optional<int> continuity) {
    return continuity ? continuity_text(*continuity) : "C^{∞}";
}

std::string answer_text(const KnotAnswers& answers, KnotQuestion question) {
    switch (question) {
        case KnotQuestion::uniform:
            return answers.is_uniform ? "uniform" : "not uniform";
        case KnotQuestion::degree:
            return std::to_string(answers.degree);
        case KnotQuestion::segments:
            return std::to_string(answers.segments);
        case KnotQuestion::control_points:
            return std::to_string(answers.control_points);
        case KnotQuestion::continuity:
            return smoothness_text(answers.continuity);
    }
    return {};
}

std::string explanation(const KnotAnswers& answers, KnotQuestion question, const NumberWriter& text_of) {
    switch (question) {
        case KnotQuestion::uniform:
            return why_uniform(answers, text_of);
        case KnotQuestion::degree:
            return why_degree(answers);
        case KnotQuestion::segments:
            return why_segments(answers, text_of);
        case KnotQuestion::control_points:
            return why_control_points(answers);
        case KnotQuestion::continuity:
            return why_continuity(answers, text_of);
    }
    return {};
}

}  // namespace batten::editor
