#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/detail/dense_least_squares.h"
#include "core/refine/detail/removable_knot.h"
#include "core/refine/knot_refinement.h"

namespace batten::core {

namespace {

// At which name of the knot it is taken out: a seam is counted at both ends of the period, one of which has to spare.
double spare_knot(std::span<const double> period, double u) {
    const bool has_spare_below = period[1] == period.front();
    const bool has_spare_above = period[period.size() - 2] == period.back();
    if (u == period.front()) return has_spare_below ? u : period.back();
    if (u == period.back()) return has_spare_above ? u : period.front();
    return u;
}

std::vector<double> without_value(std::span<const double> period, double u) {
    std::vector<double> knots(period.begin(), period.end());
    knots.erase(std::find(knots.begin(), knots.end(), u));
    return knots;
}

// Column j: what inserting `u` again makes of the spline that is 1 at point j. Row i belongs to old point i, to which
// it shall lead, divided by its weight, so that all points count alike in the plane.
std::optional<DenseEquations> insertion_equations(int degree, const std::vector<double>& reduced, double u,
                                                  std::span<const CarriedPoint> points) {
    const std::size_t columns = reduced.size() - 1;
    DenseEquations equations{.columns = columns, .matrix = std::vector<double>(points.size() * columns)};
    for (std::size_t j = 0; j < columns; ++j) {
        CurveDefinition unit{.degree = degree, .knots = reduced, .periodic = true};
        unit.points.assign(columns, Point{});
        unit.points[j].x = 1.0;
        const auto inserted =
            Curve::make(std::move(unit)).and_then([&](const Curve& basis) { return refine_knots(basis, {u}); });
        if (!inserted) return std::nullopt;
        for (std::size_t i = 0; i < points.size(); ++i)
            equations.matrix[i * columns + j] = inserted->control_points()[i].x / points[i].point.z;
    }
    for (const CarriedPoint& carried : points) equations.right.push_back(carried.point / carried.point.z);
    return equations;
}

// What the points `x` miss of the right sides.
std::vector<HomogeneousPoint> errors_of(const DenseEquations& equations, std::span<const HomogeneousPoint> x) {
    std::vector<HomogeneousPoint> errors;
    for (std::size_t i = 0; i < equations.right.size(); ++i) {
        HomogeneousPoint sum(0.0);
        for (std::size_t j = 0; j < x.size(); ++j) sum += equations.matrix[i * x.size() + j] * x[j];
        errors.push_back(sum - equations.right[i]);
    }
    return errors;
}

// As for RemovableKnot, with the whole curve for what is around.
double bound_of(std::span<const HomogeneousPoint> points, std::span<const HomogeneousPoint> errors) {
    double error = 0.0;
    double weight_error = 0.0;
    double reach = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        error = std::max(error, length(plane_part(errors[i])));
        weight_error = std::max(weight_error, std::abs(errors[i].z));
        reach = std::max(reach, length(vector_to(project(points[i]))));
    }
    if (!(weight_error < 1.0)) return std::numeric_limits<double>::infinity();
    return (error + reach * weight_error) / (1.0 - weight_error);
}

}  // namespace

std::optional<CrampedRemoval> cramped_removal(const Curve& curve, double u) {
    assert(curve.is_periodic() && curve.knots().multiplicity(u) > 0);
    const std::size_t n = curve.control_points().size();
    const double spare = spare_knot(curve.knots().stored(), u);
    std::vector<double> reduced = without_value(curve.knots().stored(), spare);
    const CarriedSpline spline = carried(curve);
    const auto equations = insertion_equations(curve.degree(), reduced, spare, std::span(spline.points).first(n));
    if (!equations) return std::nullopt;
    const std::vector<HomogeneousPoint> solution = solve_least_squares(*equations);
    const double bound = bound_of(equations->right, errors_of(*equations, solution));
    std::vector<CarriedPoint> found;
    for (const HomogeneousPoint& point : solution) found.push_back({point, CarriedPoint::is_new});
    auto result = settled(
        curve,
        {.degree = curve.degree(), .knots = std::move(reduced), .is_periodic = true, .kind = curve.knots().kind()},
        found);
    if (!result) return std::nullopt;
    return CrampedRemoval{*std::move(result), bound};
}

}  // namespace batten::core
