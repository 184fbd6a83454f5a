#include <fmt/format.h>

#include <vector>

#include "exchange/code/languages.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

constexpr const char* polynomial_form = "curve = spmak(knots, points);\n";

constexpr const char* rational_form = R"(weights = [ ...
    {weights}];
curve = rsmak(knots, [points .* [weights; weights]; weights]);
)";

// A list in brackets goes on in the next line behind three dots.
constexpr const char* continuation = " ...";

std::string continued(const std::string& list) {
    std::string result;
    for (const char c : list) {
        if (c == '\n') result += continuation;
        result += c;
    }
    return result;
}

std::string row_of(const std::vector<core::Point>& points, double core::Point::*coordinate) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const core::Point& point : points) values.push_back(point.*coordinate);
    return continued(code_numbers(values));
}

}  // namespace

std::string matlab_text(const core::DocumentCurve& entry) {
    const core::CurveDefinition form = full_definition(*entry.curve);
    const std::string head = fmt::format(
        R"(% {heading}
% With the Curve Fitting Toolbox; fnval(curve, u) are its points.
knots = [ ...
    {knots}];
points = [ ...
    {x}; ...
    {y}];
)",
        fmt::arg("heading", heading(entry)), fmt::arg("knots", continued(code_numbers(form.knots))),
        fmt::arg("x", row_of(form.points, &core::Point::x)), fmt::arg("y", row_of(form.points, &core::Point::y)));
    return head + fmt::format(fmt::runtime(!entry.curve->is_rational() ? polynomial_form : rational_form),
                              fmt::arg("weights", continued(code_numbers(form.weights))));
}

}  // namespace batten::exchange
