#include <fmt/format.h>

#include "exchange/code/languages.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

constexpr const char* polynomial_code = "curve = BSpline(knots, points, {degree})\n";

constexpr const char* rational_code = R"(weights = np.array([
    {weights}], dtype=float)
homogeneous = BSpline(knots, np.column_stack((points * weights[:, None], weights)), {degree})


def curve(u):
    value = homogeneous(u)
    return value[..., :2] / value[..., 2:]
)";

std::string python_point(core::Point point) {
    return fmt::format("[{}, {}]", code_number(point.x), code_number(point.y));
}

}  // namespace

std::string python_text(const core::DocumentCurve& entry) {
    const core::CurveDefinition form = full_definition(*entry.curve);
    const std::string head =
        fmt::format(R"(# {heading}
import numpy as np
from scipy.interpolate import BSpline

knots = np.array([
    {knots}], dtype=float)
points = np.array([
    {points}], dtype=float)
)",
                    fmt::arg("heading", heading(entry)), fmt::arg("knots", code_numbers(form.knots)),
                    fmt::arg("points", code_points(form.points, python_point)));
    return head + fmt::format(fmt::runtime(!entry.curve->is_rational() ? polynomial_code : rational_code),
                              fmt::arg("weights", code_numbers(form.weights)),
                              fmt::arg("degree", entry.curve->degree()));
}

}  // namespace batten::exchange
