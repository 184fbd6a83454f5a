#include "app/editor/words/uniform_cubic_formula.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "app/editor/words/formula.h"
#include "core/evaluate/uniform_cubic.h"

namespace batten::editor {

namespace {

constexpr double great_coordinate = 1000.0;  // from there on nobody reads a fraction
constexpr int decimals_of_great = 3;

constexpr std::array primes{"", "′", "″"};

// Of a coefficient other than 0.
std::string term_text(int coefficient, const char* t, std::size_t power) {
    const int size = std::abs(coefficient);
    if (power == 0) return fmt::format("{}", size);
    const std::string of_t = power == 1 ? t : fmt::format("{}^{{{}}}", t, power);
    return size == 1 ? of_t : fmt::format("{} {}", size, of_t);
}

std::string fraction_text(const Notation& notation, core::Fraction fraction) {
    return exact_text(notation, fraction.value());
}

std::string side_text(std::optional<std::size_t> piece, int order, int t) {
    if (!piece) return "0";
    return fmt::format("b_{{{}}}{}({})", *piece, primes[static_cast<std::size_t>(order)], t);
}

}  // namespace

const char* local_parameter(const Notation& notation) {
    return notation.parameter == ParameterLetter::t ? "s" : "t";
}

std::string exact_coordinate(const Notation& notation, double value) {
    const double size = std::abs(value);
    if (size < great_coordinate) return exact_text(notation, value);
    const int whole_digits = size < 1e9 ? static_cast<int>(std::log10(size)) + 1 : 1;
    return number_text(value, whole_digits + decimals_of_great);
}

std::string exact_place(const Notation& notation, core::Point place) {
    return fmt::format("({}, {})", exact_coordinate(notation, place.x), exact_coordinate(notation, place.y));
}

std::string exact_place(const Notation& notation, core::Vector vector) {
    return exact_place(notation, core::tip_of(vector));
}

std::string piece_formula(const Notation& notation, std::size_t j) {
    const char* t = local_parameter(notation);
    std::string terms;
    for (std::size_t k = 0; k < 4; ++k) {
        const int coefficient = core::uniform_cubic_matrix[k][j];
        if (coefficient == 0) continue;
        const char* sign = coefficient < 0 ? true_minus : "+";
        terms = terms.empty() ? term_text(coefficient, t, k)
                              : fmt::format("{} {} {}", terms, sign, term_text(coefficient, t, k));
    }
    const bool is_one_term = terms.find(' ') == std::string::npos;
    return is_one_term ? fmt::format("b_{{{}}}({}) = {}/6", j, t, terms)
                       : fmt::format("b_{{{}}}({}) = ({})/6", j, t, terms);
}

ConditionFormula condition_formula(const Notation& notation, const core::UniformCubicCondition& condition) {
    return {.symbols = fmt::format("{} = {}", side_text(condition.before, condition.order, 1),
                                   side_text(condition.after, condition.order, 0)),
            .numbers = fmt::format("{} = {}", fraction_text(notation, condition.left),
                                   fraction_text(notation, condition.right))};
}

ConditionFormula sum_formula(const Notation& notation) {
    std::vector<std::string> symbols;
    std::vector<std::string> numbers;
    for (std::size_t j = 0; j < 4; ++j) {
        symbols.push_back(side_text(j, 0, 0));
        numbers.push_back(fraction_text(notation, core::uniform_cubic_piece(j)[0]));
    }
    const std::string sum = fraction_text(notation, core::uniform_cubic_sum()[0]);
    return {.symbols = fmt::format("{} = 1", fmt::join(symbols, " + ")),
            .numbers = fmt::format("{} = {}", fmt::join(numbers, " + "), sum)};
}

}  // namespace batten::editor
