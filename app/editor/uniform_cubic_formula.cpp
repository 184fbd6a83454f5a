#include "app/editor/uniform_cubic_formula.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdlib>
#include <vector>

#include "app/editor/formula.h"
#include "core/evaluate/uniform_cubic.h"

namespace batten::editor {

namespace {

constexpr std::array powers{"", "t", "t^{2}", "t^{3}"};
constexpr std::array primes{"", "′", "″"};

// Of a coefficient other than 0.
std::string term_text(int coefficient, std::size_t power) {
    const int size = std::abs(coefficient);
    if (power == 0) return fmt::format("{}", size);
    return size == 1 ? powers[power] : fmt::format("{} {}", size, powers[power]);
}

std::string side_text(std::optional<std::size_t> piece, int order, int t) {
    if (!piece) return "0";
    return fmt::format("b_{{{}}}{}({})", *piece, primes[static_cast<std::size_t>(order)], t);
}

}  // namespace

std::string exact_text(core::Fraction fraction) {
    const bool is_negative = fraction.numerator < 0;
    fraction.numerator = std::abs(fraction.numerator);
    return fmt::format("{}{}", is_negative ? true_minus : "", core::fraction_text(fraction));
}

std::string piece_formula(std::size_t j) {
    std::string terms;
    for (std::size_t k = 0; k < 4; ++k) {
        const int coefficient = core::uniform_cubic_matrix[k][j];
        if (coefficient == 0) continue;
        const char* sign = coefficient < 0 ? true_minus : "+";
        terms =
            terms.empty() ? term_text(coefficient, k) : fmt::format("{} {} {}", terms, sign, term_text(coefficient, k));
    }
    const bool is_one_term = terms.find(' ') == std::string::npos;
    return is_one_term ? fmt::format("b_{{{}}}(t) = {}/6", j, terms) : fmt::format("b_{{{}}}(t) = ({})/6", j, terms);
}

ConditionFormula condition_formula(const core::UniformCubicCondition& condition) {
    return {.symbols = fmt::format("{} = {}", side_text(condition.before, condition.order, 1),
                                   side_text(condition.after, condition.order, 0)),
            .numbers = fmt::format("{} = {}", exact_text(condition.left), exact_text(condition.right))};
}

ConditionFormula sum_formula() {
    std::vector<std::string> symbols;
    std::vector<std::string> numbers;
    for (std::size_t j = 0; j < 4; ++j) {
        symbols.push_back(side_text(j, 0, 0));
        numbers.push_back(exact_text(core::uniform_cubic_piece(j)[0]));
    }
    const std::string sum = exact_text(core::uniform_cubic_sum()[0]);
    return {.symbols = fmt::format("{} = 1", fmt::join(symbols, " + ")),
            .numbers = fmt::format("{} = {}", fmt::join(numbers, " + "), sum)};
}

}  // namespace batten::editor
