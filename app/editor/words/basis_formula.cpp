#include "app/editor/words/basis_formula.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::int64_t most_denominator = 1000000;
constexpr std::int64_t most_polynomial_numerator = 100000000;
constexpr std::int64_t most_small_numerator = 99;
constexpr double largest_fixed = 1e12;

std::string knot_name(std::size_t i) {
    return fmt::format("u_{{{}}}", i);
}

/// What a ramp is made of: the knots where it is 0 and where it is 1.
struct RampEnds {
    std::size_t zero;
    std::size_t one;
    bool is_rising;
};

RampEnds rising_ends(std::size_t i, std::size_t k) {
    return {i, i + k, true};
}

RampEnds falling_ends(std::size_t i, std::size_t k) {
    return {i + k + 1, i + 1, false};
}

/// "(a − b)/(c − d)" of the knots' names or values, every difference the larger less the smaller.
std::string quotient(const RampEnds& ends, const std::string& u, const std::string& zero, const std::string& one) {
    return ends.is_rising ? fmt::format("({} − {})/({} − {})", u, zero, one, zero)
                          : fmt::format("({} − {})/({} − {})", zero, u, zero, one);
}

std::string ramp_symbols(const RampEnds& ends) {
    return quotient(ends, "u", knot_name(ends.zero), knot_name(ends.one));
}

class RecurrenceWriter {
  public:
    RecurrenceWriter(const core::KnotVector& knots, const core::BasisTriangle& triangle, const Notation& notation)
        : knots_(knots), triangle_(triangle), notation_(notation) {}

    RecurrenceFormula formula(std::size_t level, std::size_t index) const {
        const core::BasisCell& cell = triangle_.levels[level][index];
        const core::BasisCell& left = triangle_.levels[level - 1][index];
        const core::BasisCell& right = triangle_.levels[level - 1][index + 1];
        const RampEnds rising = rising_ends(cell.index, level);
        const RampEnds falling = falling_ends(cell.index, level);
        const std::vector<std::string> numbers = exact_texts(
            notation_, std::array{value_of(cell.rising), left.value, value_of(cell.falling), right.value, cell.value});
        return {.symbols = {fmt::format("{} = {} {}", basis_name(cell.index, level), ramp_symbols(rising),
                                        basis_name(left.index, level - 1)),
                            fmt::format("+ {} {}", ramp_symbols(falling), basis_name(right.index, level - 1))},
                .knots = {fmt::format("= {} · {}", ramp_knots(rising, cell.rising), numbers[1]),
                          fmt::format("+ {} · {}", ramp_knots(falling, cell.falling), numbers[3])},
                .numbers = fmt::format("= {} · {} + {} · {} = {}", parenthesized_if_negative(numbers[0]), numbers[1],
                                       parenthesized_if_negative(numbers[2]), numbers[3], numbers[4]),
                .note = note(cell, level)};
    }

  private:
    static double value_of(const core::BasisRamp& ramp) { return ramp.is_void ? 0.0 : ramp.value; }

    std::string place(double u) const { return parenthesized_if_negative(knot_value_text(knots_, u, notation_)); }

    std::string ramp_knots(const RampEnds& ends, const core::BasisRamp& ramp) const {
        if (ramp.is_void) return "0/0";
        return quotient(ends, place(triangle_.u), place(knots_[ends.zero]), place(knots_[ends.one]));
    }

    /// "u_{0} = u_{1} = u_{2}".
    std::string equal_knots(std::size_t first, std::size_t last) const {
        std::vector<std::string> names;
        for (std::size_t i = first; i <= last; ++i) names.push_back(knot_name(i));
        return fmt::format("{}", fmt::join(names, " = "));
    }

    std::string note(const core::BasisCell& cell, std::size_t level) const {
        const std::size_t i = cell.index;
        if (cell.rising.is_void && cell.falling.is_void)
            return core::sentence("{knots}: both ratios are 0/0, which counts as 0",
                                  {{"knots", equal_knots(i, i + level + 1)}});
        if (cell.rising.is_void)
            return core::sentence("{knots}: the first ratio is 0/0, which counts as 0",
                                  {{"knots", equal_knots(i, i + level)}});
        if (cell.falling.is_void)
            return core::sentence("{knots}: the second ratio is 0/0, which counts as 0",
                                  {{"knots", equal_knots(i + 1, i + level + 1)}});
        return "";
    }

    const core::KnotVector& knots_;
    const core::BasisTriangle& triangle_;
    const Notation& notation_;
};

/// One summand of a polynomial: what stands before the power, without its sign.
struct Term {
    bool is_negative;
    std::string magnitude;  ///< "1" is left out before a power
    std::size_t power;
};

std::string power_text(const std::string& variable, std::size_t power) {
    if (power == 0) return "";
    return power == 1 ? variable : fmt::format("{}^{{{}}}", variable, power);
}

std::string sum_of_terms(const std::vector<Term>& terms, const std::string& variable) {
    std::string text;
    for (const Term& term : terms) {
        if (text.empty())
            text.append(term.is_negative ? true_minus : "");
        else
            text.append(term.is_negative ? " − " : " + ");
        const bool is_bare = term.magnitude == "1" && term.power > 0;
        text.append(is_bare ? "" : term.magnitude).append(power_text(variable, term.power));
    }
    return text.empty() ? "0" : text;
}

/// The numerators over the least common denominator; none where these are too large to be read.
std::optional<std::vector<std::int64_t>> numerators_over(const std::vector<core::Fraction>& fractions,
                                                         std::int64_t& denominator) {
    denominator = 1;
    for (const core::Fraction& fraction : fractions) {
        if (fraction.denominator > most_denominator) return std::nullopt;
        denominator = std::lcm(denominator, fraction.denominator);
        if (denominator > most_denominator) return std::nullopt;
    }
    std::vector<std::int64_t> numerators;
    for (const core::Fraction& fraction : fractions) {
        const std::int64_t factor = denominator / fraction.denominator;
        if (std::abs(fraction.numerator) > most_polynomial_numerator / factor) return std::nullopt;
        numerators.push_back(fraction.numerator * factor);
    }
    return numerators;
}

std::string decimal_polynomial(const std::vector<double>& coefficients, const std::string& variable) {
    if (!std::ranges::all_of(coefficients, [](double c) { return std::isfinite(c); }))
        return "a polynomial whose coefficients are too large for numbers";
    std::vector<Term> terms;
    for (std::size_t power = coefficients.size(); power-- > 0;)
        if (coefficients[power] != 0.0)
            terms.push_back({coefficients[power] < 0.0, number_text(std::abs(coefficients[power])), power});
    return sum_of_terms(terms, variable);
}

/// p/(u_{first + p} − u_first), in letters.
std::string slope_symbols(std::size_t p, std::size_t first) {
    return fmt::format("{}/({} − {})", p, knot_name(first + p), knot_name(first));
}

std::string slope_number(const core::KnotVector& knots, std::size_t first, const Notation& notation) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const double length = knots[first + p] - knots[first];
    return length > 0.0 ? exact_text(notation, static_cast<double>(p) / length) : "0";
}

BasisDerivativeFormula derivative_over_knots(const core::KnotVector& knots, std::size_t i, const Notation& notation) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const std::string left = basis_name(i, p - 1);
    const std::string right = basis_name(i + 1, p - 1);
    return {.symbols = fmt::format("N′_{{{},{}}} = {} {} − {} {}", i, p, slope_symbols(p, i), left,
                                   slope_symbols(p, i + 1), right),
            .numbers = fmt::format("= {} {} − {} {}", slope_number(knots, i, notation), left,
                                   slope_number(knots, i + 1, notation), right)};
}

bool are_bezier(const core::KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    return !knots.is_periodic() && knots.control_point_count() == p + 1 && knots[0] == knots[p] &&
           knots[p + 1] == knots[2 * p + 1];
}

std::string bernstein_name(std::size_t i, std::size_t n) {
    return fmt::format("B_{{{},{}}}", i, n);
}

/// Over the knots of a Bézier curve N_{i,p-1} is B_{i-1,p-1}; N_{0,p-1} and N_{p,p-1} have no support.
BasisDerivativeFormula bernstein_derivative(const core::KnotVector& knots, std::size_t i, const Notation& notation) {
    const auto p = static_cast<std::size_t>(knots.degree());
    BasisDerivativeFormula formula{fmt::format("B′_{{{},{}}} =", i, p), "="};
    if (i > 0) {
        formula.symbols.append(fmt::format(" {} {}", slope_symbols(p, i), bernstein_name(i - 1, p - 1)));
        formula.numbers.append(fmt::format(" {} {}", slope_number(knots, i, notation), bernstein_name(i - 1, p - 1)));
    }
    if (i < p) {
        const char* minus = i > 0 ? " − " : " −";
        formula.symbols.append(fmt::format("{}{} {}", minus, slope_symbols(p, i + 1), bernstein_name(i, p - 1)));
        formula.numbers.append(
            fmt::format("{}{} {}", minus, slope_number(knots, i + 1, notation), bernstein_name(i, p - 1)));
    }
    return formula;
}

}  // namespace

std::string knot_value_text(const core::KnotVector& knots, double u, const Notation& notation) {
    const std::optional<core::Fraction> fraction = core::small_fraction(u);
    const bool is_small = fraction && std::abs(fraction->numerator) <= most_small_numerator;
    if (is_small || std::abs(u) >= largest_fixed) return exact_text(notation, u);
    return without_trailing_zeros(fixed_text(u, decimals_for(knots.domain().length())));
}

std::string basis_name(std::size_t i, std::size_t k) {
    return fmt::format("N_{{{},{}}}", i, k);
}

RecurrenceFormula recurrence_formula(const core::KnotVector& knots, const core::BasisTriangle& triangle,
                                     std::size_t level, std::size_t index, const Notation& notation) {
    return RecurrenceWriter(knots, triangle, notation).formula(level, index);
}

std::string step_formula(const core::KnotVector& knots, const core::BasisTriangle& triangle, std::size_t index,
                         const Notation& notation) {
    const core::BasisCell& cell = triangle.levels[0][index];
    const std::size_t i = cell.index;
    const bool is_one = cell.value == 1.0;
    const bool is_closed = is_one && triangle.u == knots[i + 1];
    const char* pattern = knots[i] == knots[i + 1] ? "{function} = 0, because {lower} = {upper}"
                          : is_closed ? "{function} = 1, because u = {u} is in [{lower}, {upper}] = [{begin}, {end}]"
                          : is_one    ? "{function} = 1, because u = {u} is in [{lower}, {upper}) = [{begin}, {end})"
                                   : "{function} = 0, because u = {u} is not in [{lower}, {upper}) = [{begin}, {end})";
    return core::filled_as_needed(pattern, {{"function", basis_name(i, 0)},
                                            {"u", knot_value_text(knots, triangle.u, notation)},
                                            {"lower", knot_name(i)},
                                            {"upper", knot_name(i + 1)},
                                            {"begin", knot_value_text(knots, knots[i], notation)},
                                            {"end", knot_value_text(knots, knots[i + 1], notation)}});
}

std::string bernstein_recurrence(std::size_t i, std::size_t n) {
    if (i == 0) return fmt::format("{} = (1 − u) {}", bernstein_name(i, n), bernstein_name(i, n - 1));
    if (i == n) return fmt::format("{} = u {}", bernstein_name(i, n), bernstein_name(i - 1, n - 1));
    return fmt::format("{} = u {} + (1 − u) {}", bernstein_name(i, n), bernstein_name(i - 1, n - 1),
                       bernstein_name(i, n - 1));
}

BasisDerivativeFormula basis_derivative_formula(const core::KnotVector& knots, std::size_t i,
                                                const Notation& notation) {
    return are_bezier(knots) ? bernstein_derivative(knots, i, notation) : derivative_over_knots(knots, i, notation);
}

std::string polynomial_text(const core::PowerForm& form, const std::string& variable, const Notation& notation) {
    std::int64_t denominator = 1;
    const bool has_fractions = notation.numbers == NumberStyle::fractions && !form.fractions.empty();
    const auto numerators =
        has_fractions ? numerators_over(form.fractions, denominator) : std::optional<std::vector<std::int64_t>>();
    if (!numerators) return decimal_polynomial(form.coefficients, variable);
    std::vector<Term> terms;
    for (std::size_t power = numerators->size(); power-- > 0;) {
        const std::int64_t numerator = (*numerators)[power];
        if (numerator != 0) terms.push_back({numerator < 0, std::to_string(std::abs(numerator)), power});
    }
    std::string sum = sum_of_terms(terms, variable);
    if (denominator == 1) return sum;
    return terms.size() == 1 ? fmt::format("{}/{}", sum, denominator) : fmt::format("({})/{}", sum, denominator);
}

}  // namespace batten::editor
