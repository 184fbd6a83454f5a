#include <batten/core/evaluate/evaluate.h>
#include <batten/core/measure/arc_length.h>
#include <batten/core/refine/knot_insertion.h>

#include <cmath>
#include <iostream>

using namespace batten::core;

int main() {
    // A quarter of the unit circle, exactly; and with one knot more, which keeps its shape.
    const double w = std::sqrt(0.5);
    const Result<Curve> arc = Curve::make(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, w, 1}});
    const Result<Curve> refined = arc.and_then([](const Curve& curve) { return insert_knot(curve, 0.5); });
    if (!refined) {
        std::cerr << describe(refined.error()) << '\n';
        return 1;
    }
    const Point middle = point_at(*refined, 0.5);
    std::cout.precision(15);
    std::cout << refined->control_points().size() << " control points\n"
              << "C(0.5) = (" << middle.x << ", " << middle.y << ")\n"
              << "length " << arc_length(*refined).value << '\n';
}
