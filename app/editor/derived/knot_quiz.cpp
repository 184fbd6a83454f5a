#include "app/editor/derived/knot_quiz.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/base/ascii.h"
#include "core/base/number_text.h"

namespace batten::editor {

namespace {

constexpr const char* infinite = "infinite";

// The same numbers on every machine. Source: Steele, Lea and Flood 2014, SplitMix64.
class Dice {
  public:
    explicit Dice(std::size_t number) : state_(static_cast<std::uint64_t>(number)) {}

    int between(int least, int most) {
        return least + static_cast<int>(next() % static_cast<std::uint64_t>(most - least + 1));
    }

  private:
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
};

// Knots that are whole numbers, put together from the left.
class KnotList {
  public:
    KnotList& add(int times, int step = 0) {
        last_ += step;
        knots_.insert(knots_.end(), static_cast<std::size_t>(times), static_cast<double>(last_));
        return *this;
    }
    std::vector<double> take() { return std::move(knots_); }

  private:
    std::vector<double> knots_;
    int last_ = 0;
};

// Clamped, with `count` inner knots; of each, `next()` tells the step before it and how often it occurs.
template <class Next>
std::vector<double> clamped(int degree, int count, int last_step, const Next& next) {
    KnotList list;
    list.add(degree + 1);
    for (int k = 0; k < count; ++k) {
        const auto [step, times] = next(k);
        list.add(times, step);
    }
    return list.add(degree + 1, last_step).take();
}

struct InnerKnot {
    int step;
    int times;
};

std::vector<double> simple_knots(Dice& dice, int count, int most_step) {
    KnotList list;
    list.add(1);
    // The second step differs from the first where any do.
    for (int k = 1; k < count; ++k) list.add(1, most_step == 1 ? 1 : k < 3 ? k : dice.between(1, most_step));
    return list.take();
}

std::vector<double> period(Dice& dice) {
    KnotList list;
    list.add(1);
    const int steps = dice.between(3, 5);
    const int doubled = dice.between(1, 2 * steps);
    for (int k = 1; k <= steps; ++k) list.add(k == doubled && k < steps ? 2 : 1, 1);
    return list.take();
}

std::vector<double> open_knots(QuizKind kind, int degree, Dice& dice) {
    const auto clamped_by = [&](int count, const auto& next) { return clamped(degree, count, 1, next); };
    const int count = dice.between(1, 4);
    switch (kind) {
        case QuizKind::uniform:
            return simple_knots(dice, 2 * degree + dice.between(2, 5), 1);
        case QuizKind::unclamped_uneven:
            return simple_knots(dice, 2 * degree + dice.between(4, 6), 3);
        case QuizKind::clamped_uneven:
            return clamped_by(count + 1, [&](int k) { return InnerKnot{k == 0 ? 2 : dice.between(1, 3), 1}; });
        case QuizKind::multiple_knots:
            return clamped_by(count, [&](int k) { return InnerKnot{1, k == 0 ? 2 : dice.between(1, degree)}; });
        case QuizKind::full_multiplicity:
            return clamped_by(std::min(count, 3), [&](int) { return InnerKnot{1, degree}; });
        case QuizKind::bezier:
            return clamped_by(0, [](int) { return InnerKnot{1, 1}; });
        default:
            return clamped_by(count, [](int) { return InnerKnot{1, 1}; });
    }
}

int degree_for(QuizKind kind, Dice& dice) {
    switch (kind) {
        case QuizKind::bezier:
            return dice.between(1, 5);
        case QuizKind::clamped_uniform:
        case QuizKind::clamped_uneven:
            return dice.between(1, 4);
        default:
            return dice.between(2, 3);
    }
}

QuizOption number_option(int value, int right) {
    const std::string text = std::to_string(value);
    return {text, text, value == right};
}

// The first of the candidates that are at least `least`, up to four, each once, with `right` among them.
std::vector<QuizOption> number_options(int right, std::initializer_list<int> mistakes, int least) {
    std::vector<int> values{right};
    for (const int value : mistakes)
        if (value >= least && values.size() < 4 && std::ranges::find(values, value) == values.end())
            values.push_back(value);
    std::ranges::sort(values);
    std::vector<QuizOption> options;
    for (const int value : values) options.push_back(number_option(value, right));
    return options;
}

std::vector<QuizOption> continuity_options(const KnotAnswers& answers) {
    constexpr int none = -100;
    const int right = answers.continuity.value_or(none);
    const int p = answers.degree;
    std::vector<QuizOption> options = number_options(answers.continuity ? right : p, {p - 1, p, 0, right + 1}, -1);
    for (QuizOption& option : options) {
        option.is_right = option.is_right && answers.continuity.has_value();
        option.label = smoothness_text(std::stoi(option.name));
    }
    options.push_back({infinite, smoothness_text(std::nullopt), !answers.continuity});
    return options;
}

}  // namespace

QuizKind quiz_kind(std::size_t number) {
    return static_cast<QuizKind>(number % quiz_kind_count);
}

core::KnotVector quiz_vector(std::size_t number) {
    if (number == 1) return core::KnotVector::make(3, {0, 1, 2, 3, 4, 5, 6, 7}).value();
    const QuizKind kind = quiz_kind(number);
    Dice dice(number);
    const int degree = degree_for(kind, dice);
    if (kind == QuizKind::periodic) return core::KnotVector::make_periodic(degree, period(dice)).value();
    return core::KnotVector::make(degree, open_knots(kind, degree, dice)).value();
}

bool is_asked(const core::KnotVector& knots, KnotQuestion question) {
    return question != KnotQuestion::degree || core::is_clamped(knots);
}

std::vector<QuizOption> quiz_options(const core::KnotVector& knots, KnotQuestion question) {
    const KnotAnswers answers = answers_about(knots);
    const int p = answers.degree;
    const auto segments = static_cast<int>(answers.segments);
    const auto points = static_cast<int>(answers.control_points);
    const auto count = static_cast<int>(answers.knot_count);
    switch (question) {
        case KnotQuestion::uniform:
            return {{"yes", "uniform", answers.is_uniform}, {"no", "not uniform", !answers.is_uniform}};
        case KnotQuestion::degree:
            return number_options(p, {p + 1, p - 1, p + 2, p + 3}, 1);
        case KnotQuestion::segments:
            return number_options(segments, {points, count - 1, segments + 1, segments - 1, segments + 2}, 1);
        case KnotQuestion::control_points:
            return number_options(points, {points - 1, count - p, count, points + 1, points + 2}, 1);
        case KnotQuestion::continuity:
            return continuity_options(answers);
    }
    return {};
}

std::string quiz_answer(KnotQuestion question, const std::string& typed) {
    std::string text;
    for (const char c : typed)
        if (c != ' ') text += core::small_letter(c);
    if (question == KnotQuestion::uniform) {
        if (text == "yes" || text == "uniform") return "yes";
        return text == "no" || text == "notuniform" ? "no" : "";
    }
    if (question == KnotQuestion::continuity) {
        text.erase(0, text.find_first_not_of("c^"));
        if (text == infinite || text == "∞" || text == "inf") return infinite;
        if (text == "jump") return "-1";
    }
    const auto number = core::leading_number(text);
    return number && number->length == text.size() ? core::shortest_text(number->value) : "";
}

bool KnotQuiz::is_right(KnotQuestion question) const {
    return std::ranges::any_of(quiz_options(knots, question), [&](const QuizOption& option) {
        return option.is_right && option.name == answer_to(question);
    });
}

std::size_t KnotQuiz::right_count() const {
    return right_before + static_cast<std::size_t>(std::ranges::count_if(all_knot_questions, [&](KnotQuestion q) {
               return !answer_to(q).empty() && is_right(q);
           }));
}

std::size_t KnotQuiz::given_count() const {
    return given_before + static_cast<std::size_t>(std::ranges::count_if(
                              all_knot_questions, [&](KnotQuestion q) { return !answer_to(q).empty(); }));
}

}  // namespace batten::editor
