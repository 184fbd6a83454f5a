#include "sisl_curve.h"

#include <vector>

namespace batten::bench {

SislCurve sisl_curve(int degree, std::span<const double> knots, std::span<const core::Point> points,
                     std::span<const double> weights, bool is_rational) {
    std::vector<double> coefficients;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double w = is_rational ? weights[i] : 1.0;
        coefficients.push_back(points[i].x * w);
        coefficients.push_back(points[i].y * w);
        if (is_rational) coefficients.push_back(w);
    }
    std::vector<double> copy(knots.begin(), knots.end());
    return SislCurve(newCurve(static_cast<int>(points.size()), degree + 1, copy.data(), coefficients.data(),
                              is_rational ? 2 : 1, 2, 1));
}

SislCurve sisl_curve(const core::Curve& curve) {
    return sisl_curve(curve.degree(), curve.knots().values(), curve.control_points(), curve.weights(),
                      curve.is_rational());
}

}  // namespace batten::bench
