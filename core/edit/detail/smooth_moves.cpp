#include "core/edit/detail/smooth_moves.h"

#include <algorithm>
#include <cmath>

#include "core/edit/shape_edit.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"

namespace batten::core {

namespace {

void scale_to_one(std::vector<MoveCondition>& conditions) {
    double largest = 0.0;
    for (const MoveCondition& condition : conditions)
        for (const double coefficient : condition.coefficients) largest = std::max(largest, std::abs(coefficient));
    if (largest == 0.0) return;
    for (MoveCondition& condition : conditions) {
        for (double& coefficient : condition.coefficients) coefficient /= largest;
        condition.right /= largest;
    }
}

void scale_rows_to_one(std::vector<MoveCondition>& conditions) {
    for (MoveCondition& condition : conditions) {
        double size = 0.0;
        for (const double coefficient : condition.coefficients) size = std::hypot(size, coefficient);
        if (size == 0.0) continue;
        for (double& coefficient : condition.coefficients) coefficient /= size;
    }
}

Vector missed(const MoveCondition& condition, const std::vector<Vector>& moves) {
    Vector sum{};
    for (std::size_t j = 0; j < condition.coefficients.size(); ++j)
        sum += condition.coefficients[j] * moves[(condition.first + j) % moves.size()];
    return sum;
}

}  // namespace

Vector sum_of_basis(const Curve& curve, const RationalBasis& basis, std::size_t order) {
    const std::span<const Point> points = curve.control_points();
    const Point origin = points[basis.first % points.size()];
    Vector sum{};
    for (std::size_t j = 0; j < basis.derivatives[order].size(); ++j)
        sum += basis.derivatives[order][j] * (points[(basis.first + j) % points.size()] - origin);
    return sum;
}

SmoothMoves::SmoothMoves(const Curve& curve, std::vector<MoveCondition> goals, std::vector<bool> is_held)
    : curve_(curve),
      goals_(std::move(goals)),
      kept_(smoothness_conditions(curve, curve.domain())),
      is_held_(std::move(is_held)) {
    scale_to_one(goals_);
    scale_rows_to_one(kept_);
    const std::size_t n = curve.control_points().size();
    is_held_.resize(n, false);
    if (curve.is_periodic()) return;
    fixed_.meet = is_closed(curve);
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto [lower, upper] = knots.domain();
    if (knots[1] == lower)
        is_held_.front() = true;
    else
        free_ends_.push_back(lower);
    if (knots[n + p - 1] == upper)
        is_held_.back() = true;
    else
        free_ends_.push_back(upper);
    for (std::size_t i = 0; i < n; ++i)
        if (is_held_[i]) fixed_.known.push_back({i, Point{}});
}

std::optional<Curve> SmoothMoves::with_weight(double weight, const Progress& progress) const {
    if (std::ranges::all_of(is_held_, [](bool held) { return held; })) return curve_;
    // What keeps the smoothness at knots is met exactly, by the method of multipliers: each pass makes up for what the
    // one before lacked.
    const int passes = kept_.empty() ? 1 : 3;
    std::vector<Vector> lacking(kept_.size(), Vector{});
    std::optional<std::vector<Vector>> moves;
    for (int pass = 0; pass < passes; ++pass) {
        moves = moves_with(std::sqrt(weight), lacking,
                           part_of(progress, static_cast<double>(pass) / passes, (pass + 1.0) / passes));
        if (!moves) return std::nullopt;
        for (std::size_t k = 0; k < kept_.size(); ++k) lacking[k] += missed(kept_[k], *moves);
    }
    for (std::size_t i = 0; i < moves->size(); ++i)
        if (is_held_[i]) (*moves)[i] = Vector{};
    const Result<Curve> moved = with_moves(curve_, 0, *moves);
    return moved ? std::optional(with_ends(*moved)) : std::nullopt;
}

// How far the best moves by `root` of the weight of each; the kept conditions outweigh all but the ends.
std::optional<std::vector<Vector>> SmoothMoves::moves_with(double root, const std::vector<Vector>& lacking,
                                                           const Progress& progress) const {
    const double largest = std::max(1.0, root);
    SplineSystem system(curve_.knots(), Point{}, fixed_);
    for (const MoveCondition& condition : goals_)
        system.require_sum(condition.first, condition.coefficients, condition.right);
    hold_points(system, root, largest);
    for (std::size_t k = 0; k < kept_.size(); ++k) require_kept(system, kept_[k], lacking[k], largest);
    for (const double end : free_ends_) require_end(system, end, largest);
    const auto points = system.solve(progress);
    if (!points) return std::nullopt;
    std::vector<Vector> moves;
    for (const Point& point : *points) moves.push_back(vector_to(point));
    return moves;
}

// An open spline knows the points that are held; a periodic one holds them by conditions that outweigh all others.
void SmoothMoves::hold_points(SplineSystem& system, double root, double largest) const {
    constexpr double outweighing = 1e7;
    for (std::size_t i = 0; i < is_held_.size(); ++i) {
        const double coefficient = is_held_[i] ? outweighing * largest : root;
        if (coefficient != 0.0) system.require_sum(i, std::span(&coefficient, 1), Vector{});
    }
}

void SmoothMoves::require_kept(SplineSystem& system, MoveCondition condition, Vector lacking, double largest) const {
    constexpr double outweighing = 1e5;
    for (double& coefficient : condition.coefficients) coefficient *= outweighing * largest;
    system.require_sum(condition.first, condition.coefficients, -outweighing * largest * lacking);
}

// An end that no control point makes alone is held by a condition that outweighs all others.
void SmoothMoves::require_end(SplineSystem& system, double end, double largest) const {
    constexpr double outweighing = 1e6;
    RationalBasis basis = rational_basis(curve_, end, 0, Side::right);
    for (double& value : basis.derivatives[0]) value *= outweighing * largest;
    system.require_sum(basis.first, basis.derivatives[0], Vector{});
}

// What is left of the moves of such ends is taken back, by points that are not held.
Curve SmoothMoves::with_ends(Curve moved) const {
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < is_held_.size(); ++i)
        if (is_held_[i]) held.push_back(i);
    for (const double end : free_ends_) {
        const Point place = point_at(curve_, end);
        if (point_at(moved, end) == place) continue;
        if (auto corrected = move_curve_point(moved, end, place, held)) moved = *std::move(corrected);
    }
    return moved;
}

}  // namespace batten::core
