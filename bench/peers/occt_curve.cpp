#include "occt_curve.h"

#include <vector>

namespace batten::bench {

TColgp_Array1OfPnt2d occt_array(std::span<const core::Point> points) {
    TColgp_Array1OfPnt2d array(1, static_cast<int>(points.size()));
    for (int i = 1; i <= array.Length(); ++i) {
        const core::Point& point = points[static_cast<std::size_t>(i) - 1];
        array(i) = gp_Pnt2d(point.x, point.y);
    }
    return array;
}

OcctCurve occt_curve(const core::Curve& curve) {
    std::vector<double> knots;
    std::vector<int> multiplicities;
    for (const double u : curve.knots().values()) {
        if (knots.empty() || knots.back() != u) {
            knots.push_back(u);
            multiplicities.push_back(0);
        }
        ++multiplicities.back();
    }
    const auto poles = occt_array(curve.control_points());
    const auto values = occt_array<TColStd_Array1OfReal>(knots);
    const auto counts = occt_array<TColStd_Array1OfInteger>(multiplicities);
    if (!curve.is_rational()) return new Geom2d_BSplineCurve(poles, values, counts, curve.degree());
    return new Geom2d_BSplineCurve(poles, occt_array<TColStd_Array1OfReal>(curve.weights()), values, counts,
                                   curve.degree());
}

}  // namespace batten::bench
