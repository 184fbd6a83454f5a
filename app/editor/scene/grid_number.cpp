#include "app/editor/scene/grid_number.h"

#include <algorithm>
#include <cmath>

#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double least_inch_fraction = 1.0 / 1024.0;
constexpr double most_mixed = 1e6;

// The power of ten of the last digit that multiples of a step have: −2 for 0.25.
double last_decade(double step) {
    constexpr int most_digits = 8;
    // A hair more, so that 1000 counts four digits although its logarithm may come out just below 3.
    double decade = std::floor(std::log10(step) + 1e-9);
    for (int digits = 1; digits < most_digits; ++digits, decade -= 1.0) {
        const double count = step / std::pow(10.0, decade);
        if (std::abs(count - std::round(count)) < 1e-6) break;
    }
    return decade;
}

std::string decimal_number(double value, double step) {
    if (value == 0.0) return "0";
    const double value_decade = std::floor(std::log10(std::abs(value)) + 1e-9);
    return number_text(value, static_cast<int>(std::clamp(value_decade - last_decade(step) + 1.0, 1.0, 17.0)));
}

// The whole part and the binary fraction of a number of inches.
std::string mixed_number(double value) {
    const double size = std::abs(value);
    const double whole = std::floor(size);
    double over = size - whole;
    double under = 1.0;
    while (over != std::floor(over)) {
        over *= 2.0;
        under *= 2.0;
    }
    const char* sign = value < 0.0 ? true_minus : "";
    const core::Place number("whole", decimal_number(whole, 1.0));
    if (over == 0.0) return core::sentence("{sign}{whole}", {{"sign", sign}, number});
    const core::Place numerator("over", static_cast<std::size_t>(over));
    const core::Place denominator("under", static_cast<std::size_t>(under));
    if (whole == 0.0) return core::sentence("{sign}{over}/{under}", {{"sign", sign}, numerator, denominator});
    return core::sentence("{sign}{whole} {over}/{under}", {{"sign", sign}, number, numerator, denominator});
}

}  // namespace

bool is_inch_fraction(double step, const Units& units) {
    const bool has_inches = units && units->unit == core::LengthUnit::inch;
    return has_inches && step >= least_inch_fraction && step <= 1.0 && std::exp2(std::round(std::log2(step))) == step;
}

std::string grid_number_text(double value, double step, const Units& units) {
    const bool is_mixed = is_inch_fraction(step, units) && std::abs(value) < most_mixed;
    return is_mixed ? mixed_number(value) : decimal_number(value, step);
}

}  // namespace batten::editor
