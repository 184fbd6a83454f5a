#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

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

// Column j: what inserting `u` again makes of the spline that is 1 at point j. Row i belongs to old point i.
std::optional<Eigen::MatrixXd> insertion_matrix(int degree, const std::vector<double>& reduced, double u) {
    const auto columns = static_cast<Eigen::Index>(reduced.size()) - 1;
    Eigen::MatrixXd matrix(columns + 1, columns);
    for (Eigen::Index j = 0; j < columns; ++j) {
        CurveDefinition unit{.degree = degree, .knots = reduced, .periodic = true};
        unit.points.assign(reduced.size() - 1, Point{});
        unit.points[static_cast<std::size_t>(j)].x = 1.0;
        const auto inserted =
            Curve::make(std::move(unit)).and_then([&](const Curve& basis) { return refine_knots(basis, {u}); });
        if (!inserted) return std::nullopt;
        for (Eigen::Index i = 0; i <= columns; ++i)
            matrix(i, j) = inserted->control_points()[static_cast<std::size_t>(i)].x;
    }
    return matrix;
}

Eigen::MatrixX3d rows_of(std::span<const CarriedPoint> points) {
    Eigen::MatrixX3d rows(static_cast<Eigen::Index>(points.size()), 3);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const HomogeneousPoint& point = points[static_cast<std::size_t>(i)].point;
        rows.row(i) << point.x, point.y, point.z;
    }
    return rows;
}

// As for RemovableKnot, with the whole curve for what is around.
double bound_of(const Eigen::MatrixX3d& points, const Eigen::MatrixX3d& errors) {
    const double weight_error = errors.col(2).cwiseAbs().maxCoeff();
    const double least_weight = points.col(2).minCoeff() - weight_error;
    if (!(least_weight > 0.0)) return std::numeric_limits<double>::infinity();
    const double reach =
        (points.leftCols(2).array().colwise() / points.col(2).array()).matrix().rowwise().norm().maxCoeff();
    return (errors.leftCols(2).rowwise().norm().maxCoeff() + reach * weight_error) / least_weight;
}

}  // namespace

std::optional<CrampedRemoval> cramped_removal(const Curve& curve, double u) {
    assert(curve.is_periodic() && curve.knots().multiplicity(u) > 0);
    const std::size_t n = curve.control_points().size();
    const double spare = spare_knot(curve.knots().stored(), u);
    std::vector<double> reduced = without_value(curve.knots().stored(), spare);
    const auto matrix = insertion_matrix(curve.degree(), reduced, spare);
    if (!matrix) return std::nullopt;
    const CarriedSpline spline = carried(curve);
    const Eigen::MatrixX3d points = rows_of(std::span(spline.points).first(n));
    const Eigen::MatrixX3d solution = matrix->colPivHouseholderQr().solve(points);
    const double bound = bound_of(points, *matrix * solution - points);
    if (!std::isfinite(bound) || !(solution.col(2).minCoeff() > 0.0)) return std::nullopt;
    std::vector<CarriedPoint> found;
    for (Eigen::Index i = 0; i < solution.rows(); ++i)
        found.push_back({HomogeneousPoint(solution(i, 0), solution(i, 1), solution(i, 2)), CarriedPoint::is_new});
    auto result = settled(
        curve,
        {.degree = curve.degree(), .knots = std::move(reduced), .is_periodic = true, .kind = curve.knots().kind()},
        found);
    if (!result) return std::nullopt;
    return CrampedRemoval{*std::move(result), bound};
}

}  // namespace batten::core
