#include <fmt/format.h>

#include "exchange/code/languages.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

constexpr const char* cpp_code = R"(// {heading}
#include <array>
#include <cstddef>

constexpr std::size_t degree = {degree};
constexpr std::array<double, {knot_count}> knots{{
    {knots}}};
constexpr std::array<std::array<double, 2>, {count}> points{{{{
    {points}}}}};
constexpr std::array<double, {count}> weights{{
    {weights}}};

// The point at u in the domain, by the algorithm of de Boor.
inline std::array<double, 2> point_at(double u) {{
    std::size_t span = degree;
    while (span + 1 < points.size() && (knots[span + 1] <= u || knots[span] == knots[span + 1])) ++span;
    while (knots[span] == knots[span + 1]) --span;
    std::array<std::array<double, 3>, degree + 1> d{{}};
    for (std::size_t j = 0; j <= degree; ++j) {{
        const std::size_t i = span - degree + j;
        d[j] = {{points[i][0] * weights[i], points[i][1] * weights[i], weights[i]}};
    }}
    for (std::size_t r = 1; r <= degree; ++r)
        for (std::size_t j = degree; j >= r; --j) {{
            const double lower = knots[span - degree + j];
            const double share = (u - lower) / (knots[span + 1 + j - r] - lower);
            for (std::size_t k = 0; k < 3; ++k) d[j][k] = (1 - share) * d[j - 1][k] + share * d[j][k];
        }}
    return {{d[degree][0] / d[degree][2], d[degree][1] / d[degree][2]}};
}}
)";

std::string cpp_point(core::Point point) {
    return fmt::format("{{{}, {}}}", code_number(point.x), code_number(point.y));
}

}  // namespace

std::string cpp_text(const core::DocumentCurve& entry) {
    core::CurveDefinition form = full_definition(*entry.curve);
    if (form.weights.empty()) form.weights.assign(form.points.size(), 1.0);
    return fmt::format(fmt::runtime(cpp_code), fmt::arg("heading", heading(entry)),
                       fmt::arg("degree", entry.curve->degree()), fmt::arg("knot_count", form.knots.size()),
                       fmt::arg("count", form.points.size()), fmt::arg("knots", code_numbers(form.knots)),
                       fmt::arg("points", code_points(form.points, cpp_point)),
                       fmt::arg("weights", code_numbers(form.weights)));
}

}  // namespace batten::exchange
