#include "core/edit/plane_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/detail/angle.h"
#include "core/base/double_double.h"

namespace batten::core {

namespace {

using MapRow = std::array<double, 3>;
using Rows = std::array<MapRow, 3>;

PlaneMap linear(double xx, double xy, double yx, double yy, Point pivot) {
    return {.rows = {{{xx, xy, 0.0}, {yx, yy, 0.0}, {0.0, 0.0, 1.0}}}, .pivot = pivot};
}

// A point seen from the pivot, without error, so that the pivot itself and what lies far from zero stay where they are.
struct SeenPoint {
    DoubleDouble x;
    DoubleDouble y;

    SeenPoint(Point point, Point pivot) : x(exact_sum(point.x, -pivot.x)), y(exact_sum(point.y, -pivot.y)) {}

    DoubleDouble times(const MapRow& row) const { return row[0] * x + row[1] * y + row[2]; }
};

double largest(double a, double b, double c) {
    return std::max({std::abs(a), std::abs(b), std::abs(c)});
}

// Divided by a power of two, so that the largest of `size` is from 1 to 2; as it is where that is 0.
void divide_by_size(std::initializer_list<double*> numbers, double size) {
    if (size == 0.0) return;
    for (double* number : numbers) *number = std::scalbn(*number, -std::ilogb(size));
}

// Rows and columns of the order of 1, so that products of three cannot vanish or overflow where it matters.
Rows balanced(Rows rows) {
    for (auto& [a, b, c] : rows) divide_by_size({&a, &b, &c}, largest(a, b, c));
    for (std::size_t k = 0; k < 3; ++k) {
        double& first = rows[0][k];
        divide_by_size({&first, &rows[1][k], &rows[2][k]}, largest(first, rows[1][k], rows[2][k]));
    }
    return rows;
}

// Whether the determinant is no more than what rounding of the numbers makes of 0.
bool is_singular(const Rows& rows) {
    double determinant = 0.0;
    double size = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const std::size_t last = (k + 2) % 3;
        const double forward = rows[0][k] * rows[1][next] * rows[2][last];
        const double backward = rows[0][k] * rows[1][last] * rows[2][next];
        determinant += forward - backward;
        size += std::abs(forward) + std::abs(backward);
    }
    return std::abs(determinant) <= 8.0 * std::numeric_limits<double>::epsilon() * size;
}

}  // namespace

PlaneMap translation(Vector offset) {
    return {.rows = {{{1.0, 0.0, offset.x}, {0.0, 1.0, offset.y}, {0.0, 0.0, 1.0}}}};
}

PlaneMap rotation(double degrees, Point pivot) {
    const Vector direction = unit_vector(degrees);
    return linear(direction.x, -direction.y, direction.y, direction.x, pivot);
}

PlaneMap scaling(double along_x, double along_y, Point pivot) {
    return linear(along_x, 0.0, 0.0, along_y, pivot);
}

PlaneMap shearing(double x_per_y, double y_per_x, Point pivot) {
    return linear(1.0, x_per_y, y_per_x, 1.0, pivot);
}

PlaneMap reflection(double degrees, Point pivot) {
    const Vector doubled = unit_vector(2.0 * degrees);
    return linear(doubled.x, doubled.y, doubled.y, -doubled.x, pivot);
}

PlaneMap about_origin(const PlaneMap& map) {
    const auto [x, y] = map.pivot;
    PlaneMap result{.rows = map.rows};
    for (MapRow& row : result.rows) row[2] -= row[0] * x + row[1] * y;
    for (std::size_t k = 0; k < 3; ++k) {
        result.rows[0][k] += x * result.rows[2][k];
        result.rows[1][k] += y * result.rows[2][k];
    }
    return result;
}

Point mapped(const PlaneMap& map, Point point) {
    const SeenPoint seen(point, map.pivot);
    const DoubleDouble w = seen.times(map.rows[2]);
    const bool is_divided = w.high != 1.0 || w.low != 0.0;
    const auto coordinate = [&](const MapRow& row, double pivot) {
        const DoubleDouble numerator = seen.times(row);
        return ((is_divided ? numerator / w : numerator) + pivot).rounded();
    };
    return {coordinate(map.rows[0], map.pivot.x), coordinate(map.rows[1], map.pivot.y)};
}

double weight_factor(const PlaneMap& map, Point point) {
    const MapRow& row = map.rows[2];
    const SeenPoint seen(point, map.pivot);
    const double factor = seen.times(row).rounded();
    const double size = std::abs(row[0] * seen.x.high) + std::abs(row[1] * seen.y.high) + std::abs(row[2]);
    return std::abs(factor) <= 2.0 * std::numeric_limits<double>::epsilon() * size ? 0.0 : factor;
}

Result<void> check_map(const PlaneMap& map) {
    for (const MapRow& row : map.rows)
        for (const double number : row)
            if (!std::isfinite(number)) return refuse({.code = CurveErrorCode::map_not_finite});
    if (!is_finite(map.pivot)) return refuse({.code = CurveErrorCode::map_not_finite});
    if (is_singular(balanced(map.rows))) return refuse({.code = CurveErrorCode::map_singular});
    return {};
}

}  // namespace batten::core
