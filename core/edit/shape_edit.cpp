#include "core/edit/shape_edit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/detail/kept_smoothness.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/rational_basis.h"

namespace batten::core {

namespace {

Result<void> check_move(const Curve& curve, double u, Point target, Vector derivative) {
    if (const auto check = check_parameter_finite(u); !check) return check;
    if (const auto check = check_in_domain(curve.knots(), u); !check) return check;
    if (!is_finite(target) || !is_finite(derivative)) return refuse({.code = CurveErrorCode::vector_not_finite});
    return {};
}

// How much each of the control points that act counts in a value at u. In a short period one point may act repeatedly.
std::vector<double> shares(const RationalBasis& basis, std::size_t order, std::size_t n) {
    std::vector<double> sums(std::min(n, basis.derivatives[order].size()), 0.0);
    for (std::size_t j = 0; j < basis.derivatives[order].size(); ++j) sums[j % n] += basis.derivatives[order][j];
    return sums;
}

// Pinned points have no share.
void unshare(std::vector<double>& shares, const RationalBasis& basis, std::size_t n,
             std::span<const std::size_t> pinned) {
    for (std::size_t j = 0; j < shares.size(); ++j)
        if (std::ranges::binary_search(pinned, (basis.first + j) % n)) shares[j] = 0.0;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
    return sum;
}

// Whether what is left of the shares can still move the curve.
bool acts(const std::vector<double>& shares) {
    constexpr double least_share = 1e-9;
    return std::ranges::any_of(shares, [](double share) { return std::abs(share) > least_share; });
}

// The point of the curve that is one of its control points, as at a clamped end, goes to the target to the last bit.
std::optional<std::size_t> only_share(const std::vector<double>& values) {
    for (std::size_t j = 0; j < values.size(); ++j)
        if (values[j] == 1.0 && dot(values, values) == 1.0) return j;
    return std::nullopt;
}

// Whether one point is both the first and the last control point, and these are the ends of the curve.
bool has_one_end_point(const Curve& curve) {
    const auto points = curve.control_points();
    return !curve.is_periodic() && is_clamped(curve.knots()) && points.front() == points.back();
}

// The curve with what acts at u moved by `moves` so that it stays smooth at its knots, where that takes more than the
// knots; else none, and then the least change is free.
std::optional<Curve> kept_smooth(const Curve& curve, const RationalBasis& basis, double u, Side side, Point target,
                                 std::span<const Vector> moves, std::span<const std::size_t> pinned) {
    auto moved = moved_smoothly(curve, u, side, moves, pinned);
    const std::size_t n = curve.control_points().size();
    const auto only = only_share(shares(basis, 0, n));
    if (!moved || (!only && !has_one_end_point(curve))) return moved;
    CurveDefinition definition = moved->definition();
    if (only) definition.points[(basis.first + *only) % n] = target;
    if (has_one_end_point(curve)) {
        const bool is_last = only && basis.first + *only + 1 == n;
        const Point end = is_last ? definition.points.back() : definition.points.front();
        definition.points.front() = definition.points.back() = end;
    }
    const auto exact = Curve::make(std::move(definition));
    return exact ? std::optional(*exact) : std::nullopt;
}

}  // namespace

Result<Curve> move_curve_point(const Curve& curve, double u, Point target, std::span<const std::size_t> pinned) {
    if (const auto check = check_move(curve, u, target, Vector{}); !check) return refuse(check.error());
    const RationalBasis basis = rational_basis(curve, u);
    const std::size_t n = curve.control_points().size();
    std::vector<double> values = shares(basis, 0, n);
    unshare(values, basis, n, pinned);
    if (!acts(values)) return refuse({.code = CurveErrorCode::points_pinned, .value = u});
    const std::array moves{target - point_at(curve, u)};
    if (const auto smooth = kept_smooth(curve, basis, u, Side::right, target, moves, pinned)) return *smooth;
    CurveDefinition definition = curve.definition();
    if (const auto j = only_share(values)) {
        definition.points[(basis.first + *j) % n] = target;
        return Curve::make(std::move(definition));
    }
    const Vector move = (target - point_at(curve, u)) / dot(values, values);
    for (std::size_t j = 0; j < values.size(); ++j)
        if (values[j] != 0.0) definition.points[(basis.first + j) % n] += values[j] * move;
    return Curve::make(std::move(definition));
}

Result<Curve> move_curve_point_and_tangent(const Curve& curve, double u, Point target, Vector derivative, Side side,
                                           std::span<const std::size_t> pinned) {
    if (const auto check = check_move(curve, u, target, derivative); !check) return refuse(check.error());
    const RationalBasis basis = rational_basis(curve, u, 1, side);
    CurveDefinition definition = curve.definition();
    const std::size_t n = definition.points.size();
    std::vector<double> values = shares(basis, 0, n);
    std::vector<double> slopes = shares(basis, 1, n);
    unshare(values, basis, n, pinned);
    unshare(slopes, basis, n, pinned);
    if (!acts(values)) return refuse({.code = CurveErrorCode::points_pinned, .value = u});
    const double size = dot(slopes, slopes);
    // The part of the slopes that does not move the point; the two conditions are then met one after the other.
    const double along = dot(slopes, values) / dot(values, values);
    for (std::size_t j = 0; j < slopes.size(); ++j) slopes[j] -= along * values[j];
    const double free_size = dot(slopes, slopes);
    constexpr double least_share = 1e-24;
    if (!(free_size > least_share * size)) return refuse({.code = CurveErrorCode::tangent_not_free, .value = u});

    const auto old = derivatives_at(curve, u, 1, side);
    const Vector move = target - old.point;
    const std::array moves{move, derivative - old[1]};
    if (const auto smooth = kept_smooth(curve, basis, u, side, target, moves, pinned)) return *smooth;
    const Vector turn = derivative - old[1] - along * move;
    const auto only = only_share(values);
    for (std::size_t j = 0; j < values.size(); ++j) {
        Point& point = definition.points[(basis.first + j) % n];
        if (only == j)
            point = target + slopes[j] / free_size * turn;
        else if (values[j] != 0.0 || slopes[j] != 0.0)
            point += values[j] / dot(values, values) * move + slopes[j] / free_size * turn;
    }
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
