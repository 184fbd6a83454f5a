#include "app/cli/basis_rows.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/cli/json_output.h"
#include "core/base/number_text.h"
#include "core/evaluate/rational_basis.h"

namespace batten::cli {

namespace {

// One function: its value, then its derivatives.
struct FunctionValues {
    std::size_t index = 0;
    std::vector<double> plain;     // N
    std::vector<double> rational;  // R; empty where the curve is not rational
};

using Rows = core::ShortList<core::BasisRow, 1>;

// The local functions are those of so many points that follow each other; of a periodic curve with few points several
// are the same function, whose values add up.
std::vector<double> values_of(const Rows& rows, std::size_t j, std::size_t period) {
    std::vector<double> values;
    for (const core::BasisRow& row : rows) {
        double sum = 0.0;
        for (std::size_t k = j; k < row.size(); k += period) sum += row[k];
        values.push_back(sum);
    }
    return values;
}

std::vector<FunctionValues> functions_at(const core::Curve& curve, double u, const EvalOptions& options) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const core::BasisValues plain = core::basis_functions(curve.knots(), u, options.derivatives, options.side);
    Rows rational;
    if (curve.is_rational()) rational = core::rational_basis(curve, u, options.derivatives, options.side).derivatives;
    std::vector<FunctionValues> functions;
    for (std::size_t j = 0; j < std::min(n, p + 1); ++j)
        functions.push_back({.index = (plain.span - p + j) % n,
                             .plain = values_of(plain.derivatives, j, n),
                             .rational = values_of(rational, j, n)});
    return functions;
}

bool is_finite(const std::vector<FunctionValues>& functions) {
    const auto are_finite = [](const std::vector<double>& values) {
        return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    };
    return std::ranges::all_of(functions, [&](const FunctionValues& function) {
        return are_finite(function.plain) && are_finite(function.rational);
    });
}

void append_rows(std::string& text, double u, const std::vector<FunctionValues>& functions) {
    for (const FunctionValues& function : functions) {
        core::append_shortest_text(text, u);
        text.append(1, '\t').append(std::to_string(function.index));
        for (const auto* values : {&function.plain, &function.rational})
            for (const double value : *values) {
                text += '\t';
                core::append_shortest_text(text, value);
            }
        text += '\n';
    }
}

Json json_of_row(double u, const std::vector<FunctionValues>& functions) {
    Json list = Json::array();
    double sum = 0.0;
    for (const FunctionValues& function : functions) {
        Json member{{"index", function.index}, {"N", function.plain}};
        if (!function.rational.empty()) member["R"] = function.rational;
        list.push_back(std::move(member));
        sum += function.plain.front();
    }
    return {{"u", u}, {"sum", sum}, {"functions", std::move(list)}};
}

}  // namespace

tl::expected<std::string, double> basis_rows(const core::Curve& curve, std::span<const double> parameters,
                                             const EvalOptions& options) {
    std::string text;
    Json list = Json::array();
    for (const double u : parameters) {
        const std::vector<FunctionValues> functions = functions_at(curve, u, options);
        if (!is_finite(functions)) return tl::unexpected(u);
        if (options.as_json)
            list.push_back(json_of_row(u, functions));
        else
            append_rows(text, u, functions);
    }
    if (!options.as_json) return text;
    std::ostringstream out;
    print(out, list);
    return std::move(out).str();
}

}  // namespace batten::cli
