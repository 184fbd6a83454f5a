#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/fraction.h"
#include "core/base/number_text.h"
#include "exchange/code/languages.h"

namespace batten::exchange {

namespace {

// A decimal of so few characters is read more easily than a fraction.
constexpr std::size_t short_decimal = 5;

// Of a page of any of the usual classes and sizes of letters: rows with fractions in them that fill it, and that fill
// half of it.
constexpr std::size_t rows_of_page = 30;
constexpr std::size_t rows_of_half_page = 14;

// A line may end behind each knot.
constexpr const char* between_knots = ",\\allowbreak ";

// "1e-300" as 10^{-300}, "1.5e+20" as 1.5 \cdot 10^{20}.
std::string power_text(const std::string& number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) return number;
    const std::string digits = number.substr(0, e);
    std::string exponent = number.substr(e + 1);
    if (exponent.front() == '+') exponent.erase(0, 1);
    if (digits == "1" || digits == "-1") return fmt::format("{}10^{{{}}}", digits == "1" ? "" : "-", exponent);
    return fmt::format("{} \\cdot 10^{{{}}}", digits, exponent);
}

std::string latex_number(double value) {
    const std::string decimal = core::shortest_text(value == 0.0 ? 0.0 : value);  // a paper has one zero
    const auto fraction = core::small_fraction(value);
    if (decimal.size() <= short_decimal || !fraction || fraction->value() != value) return power_text(decimal);
    return fmt::format("{}\\tfrac{{{}}}{{{}}}", fraction->numerator < 0 ? "-" : "", std::abs(fraction->numerator),
                       fraction->denominator);
}

std::string knot_list(std::span<const double> knots) {
    std::string text;
    for (const double knot : knots) {
        if (!text.empty()) text += between_knots;
        text += latex_number(knot);
    }
    return text;
}

std::string row_text(std::size_t i, core::Point point, const double* weight) {
    const std::string end = weight != nullptr ? fmt::format(" & {}", latex_number(*weight)) : "";
    return fmt::format("  {} & {} & {}{} \\\\\n", i, latex_number(point.x), latex_number(point.y), end);
}

std::string table_text(const core::Curve& curve, std::size_t begin, std::size_t end) {
    const bool rational = curve.is_rational();
    std::string rows;
    for (std::size_t i = begin; i < end; ++i)
        rows += row_text(i, curve.control_points()[i], rational ? &curve.weights()[i] : nullptr);
    return fmt::format(R"(\[
\renewcommand{{\arraystretch}}{{1.2}}
\begin{{array}}{{{columns}}}
  i & x_i & y_i{weight} \\ \hline
{rows}\end{{array}}
\]
)",
                       fmt::arg("columns", rational ? "c|ccc" : "c|cc"), fmt::arg("weight", rational ? " & w_i" : ""),
                       fmt::arg("rows", rows));
}

// Tables of the control points, between which a page may end, and so short that little of it stays empty.
std::string tables_text(const core::Curve& curve) {
    const std::size_t count = curve.control_points().size();
    const std::size_t rows = count <= rows_of_page ? count : rows_of_half_page;
    std::string tables;
    for (std::size_t begin = 0; begin < count; begin += rows)
        tables += table_text(curve, begin, std::min(begin + rows, count));
    return tables;
}

}  // namespace

std::string latex_text(const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    return fmt::format(R"(% {heading}; needs amsmath
{tables}{{\raggedright $p = {degree}$, $U = ({knots})${period}\par}}
)",
                       fmt::arg("heading", heading(entry)), fmt::arg("tables", tables_text(curve)),
                       fmt::arg("degree", curve.degree()), fmt::arg("knots", knot_list(curve.knots().stored())),
                       fmt::arg("period", curve.is_periodic() ? ", periodic" : ""));
}

}  // namespace batten::exchange
