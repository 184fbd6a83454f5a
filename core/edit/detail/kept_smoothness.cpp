#include "core/edit/detail/kept_smoothness.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/banded_least_squares.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/measure/detail/joint_relation.h"

namespace batten::core {

namespace {

// The continuity that can be kept at a knot by moves that end there.
int most_kept(const Curve& curve) {
    return std::min(2, curve.degree() - 1);
}

// Whether it asks nothing of the control points: whatever moves, a closed curve of two points stays on its line, and
// one of three is an affine image of itself. What is left of the coefficients then is less than what counts as smooth.
bool is_met_by_all_moves(const Curve& curve, const MoveCondition& condition) {
    std::vector<double> of_points(std::min(curve.control_points().size(), condition.coefficients.size()), 0.0);
    double largest = 0.0;
    for (std::size_t j = 0; j < condition.coefficients.size(); ++j) {
        of_points[j % of_points.size()] += condition.coefficients[j];
        largest = std::max(largest, std::abs(condition.coefficients[j]));
    }
    const double allowed = ContinuityTolerances{}.derivative * largest;
    return std::ranges::all_of(of_points, [&](double coefficient) { return std::abs(coefficient) <= allowed; });
}

void add_unless_met(std::vector<MoveCondition>& conditions, const Curve& curve, MoveCondition condition) {
    if (!is_met_by_all_moves(curve, condition)) conditions.push_back(std::move(condition));
}

void add_conditions(std::vector<MoveCondition>& conditions, const Curve& curve, const JointContinuity& joint) {
    const int level = std::min(joint.geometric, most_kept(curve));
    if (level <= joint.promised) return;
    const RationalBasis before = rational_basis(curve, parameter_before(curve, joint), 2, Side::left);
    const RationalBasis after = rational_basis(curve, joint.u, 2, Side::right);
    if (joint.promised < 0) add_unless_met(conditions, curve, difference_at_knot(curve, before, 0, after, 0));
    if (level < 1) return;
    const auto relation = joint_relation(curve, joint, level);
    if (!relation) return;
    add_unless_met(conditions, curve, difference_at_knot(curve, before, 1, after, 1, relation->scale));
    if (level < 2) return;
    MoveCondition second = difference_at_knot(curve, before, 2, after, 2, relation->scale * relation->scale);
    for (std::size_t j = 0; j < before.derivatives[1].size(); ++j)
        second.coefficients[j] -= relation->shift * before.derivatives[1][j];
    add_unless_met(conditions, curve, std::move(second));
}

bool is_multiple(const Curve& curve, const DistinctKnot& knot, Interval range) {
    return knot.is_interior && range.contains(knot.value) && knot.continuity < most_kept(curve);
}

// The control points that may move: a run of them or, where the last ones are tied to the first, all.
struct Window {
    std::size_t first = 0;
    std::size_t count = 0;
    Interval range{};
};

// Between the knots that are p distinct ones away from the span of `u` on both sides, and all around where ends that
// meet lie between them.
Window window_around(const Curve& curve, double u, Side side) {
    const KnotVector& knots = curve.knots();
    const std::size_t n = curve.control_points().size();
    if (curve.is_periodic()) return {0, n, curve.domain()};
    const auto p = static_cast<std::size_t>(curve.degree());
    std::size_t low = knots.span_at(u, side);
    std::size_t high = low + 1;
    for (std::size_t passed = 0; low > p && passed < p; ++passed)
        for (const double knot = knots[low]; low > p && knots[low] == knot;) --low;
    for (std::size_t passed = 0; high < n && passed < p; ++passed)
        for (const double knot = knots[high]; high < n && knots[high] == knot;) ++high;
    // Functions that begin at the first of these knots or behind it, and end at the last one or before it.
    std::size_t first = 0;
    if (low > p)
        first = static_cast<std::size_t>(std::ranges::lower_bound(knots.values(), knots[low]) - knots.values().begin());
    std::size_t end = n;
    if (high < n)
        end = static_cast<std::size_t>(std::ranges::upper_bound(knots.values(), knots[high]) - knots.values().begin()) -
              p - 1;
    if ((first == 0 || end == n) && is_closed(curve)) return {0, n, curve.domain()};
    return {first, end > first ? end - first : 0, {knots[low], knots[high]}};
}

// Conditions that are met exactly, however many, and the least sum of squares of the unknowns: by the method of
// multipliers. Source: Hestenes 1969; Powell 1969.
class LeastMoves {
  public:
    LeastMoves(const Curve& curve, const Window& window) : curve_(curve), window_(window) {}

    void require(const MoveCondition& condition) {
        const std::size_t n = curve_.control_points().size();
        std::vector<double> row(window_.count, 0.0);
        double size = 0.0;
        for (std::size_t j = 0; j < condition.coefficients.size(); ++j) {
            const std::size_t i = (condition.first + j) % n - window_.first;
            if (i < window_.count) row[place(i)] += condition.coefficients[j];
        }
        for (const double value : row) size = std::hypot(size, value);
        if (size == 0.0) return;
        const auto begin = std::ranges::find_if(row, [](double value) { return value != 0.0; });
        const auto end = std::find_if(row.rbegin(), row.rend(), [](double value) { return value != 0.0; }).base();
        BandedEquation<Vector> equation{static_cast<std::size_t>(begin - row.begin()), {}, condition.right / size};
        equation.coefficients.assign({begin, end});
        for (double& value : equation.coefficients) value /= size;
        hard_.push_back(std::move(equation));
    }

    // By the number of the control point in the window; none where the conditions contradict each other.
    std::optional<std::vector<Vector>> solve() const {
        constexpr int passes = 4;
        constexpr double penalty = 1e4;
        std::vector<Vector> errors(hard_.size(), Vector{});
        std::vector<Vector> found;
        for (int pass = 0; pass < passes; ++pass) {
            std::vector<BandedEquation<Vector>> equations;
            for (std::size_t k = 0; k < window_.count; ++k) equations.push_back({k, {1.0}, Vector{}});
            for (std::size_t k = 0; k < hard_.size(); ++k) {
                BandedEquation<Vector> equation = hard_[k];
                for (double& value : equation.coefficients) value *= penalty;
                equation.right = penalty * (hard_[k].right - errors[k]);
                equations.push_back(std::move(equation));
            }
            auto solution = solve_least_squares(equations, window_.count);
            if (!solution) return std::nullopt;
            found = *std::move(solution);
            for (std::size_t k = 0; k < hard_.size(); ++k) errors[k] += missed(hard_[k], found);
        }
        return meets_all(found) ? std::optional(in_order(found)) : std::nullopt;
    }

  private:
    // Where all points may move, conditions may tie the last ones to the first.
    std::size_t place(std::size_t i) const {
        return window_.count == curve_.control_points().size() ? folded(i, window_.count) : i;
    }

    static Vector missed(const BandedEquation<Vector>& equation, const std::vector<Vector>& found) {
        Vector sum = -equation.right;
        for (std::size_t j = 0; j < equation.coefficients.size(); ++j)
            sum += equation.coefficients[j] * found[equation.first + j];
        return sum;
    }

    bool meets_all(const std::vector<Vector>& found) const {
        constexpr double allowed = 1e-9;
        double largest = 0.0;
        for (const auto& equation : hard_) largest = std::max(largest, robust_length(equation.right));
        for (const auto& equation : hard_)
            if (!(robust_length(missed(equation, found)) <= allowed * largest)) return false;
        return true;
    }

    std::vector<Vector> in_order(const std::vector<Vector>& found) const {
        std::vector<Vector> moves(window_.count);
        for (std::size_t i = 0; i < window_.count; ++i) moves[i] = found[place(i)];
        return moves;
    }

    const Curve& curve_;
    Window window_;
    std::vector<BandedEquation<Vector>> hard_;
};

// Whether a condition speaks of a point that acts in a span whose functions are `basis`.
bool touches(const Curve& curve, const std::vector<MoveCondition>& conditions, const RationalBasis& basis) {
    const std::size_t n = curve.control_points().size();
    return std::ranges::any_of(conditions, [&](const MoveCondition& condition) {
        const std::size_t behind = (basis.first + n - condition.first % n) % n;
        return behind < condition.coefficients.size() || behind + basis.derivatives[0].size() > n;
    });
}

}  // namespace

MoveCondition difference_at_knot(const Curve& curve, const RationalBasis& before, std::size_t before_order,
                                 const RationalBasis& after, std::size_t after_order, double factor) {
    const std::size_t n = curve.control_points().size();
    const std::size_t shift = (after.first + n - before.first % n) % n;
    const std::size_t count = after.derivatives[after_order].size();
    MoveCondition condition{before.first, std::vector<double>(shift + count, 0.0)};
    for (std::size_t j = 0; j < count; ++j) {
        condition.coefficients[j] -= factor * before.derivatives[before_order][j];
        condition.coefficients[shift + j] += after.derivatives[after_order][j];
    }
    return condition;
}

std::vector<MoveCondition> smoothness_conditions(const Curve& curve, Interval range) {
    std::vector<MoveCondition> conditions;
    if (robust_length(control_box(curve).size()) == 0.0) return conditions;
    const auto distinct = distinct_knots(curve.knots());
    if (std::ranges::any_of(distinct, [&](const DistinctKnot& knot) { return is_multiple(curve, knot, range); }))
        for (const JointContinuity& joint : joint_continuity_within(curve, range))
            add_conditions(conditions, curve, joint);
    if (!curve.is_periodic() && range == curve.domain()) add_conditions(conditions, curve, continuity_of_ends(curve));
    return conditions;
}

std::optional<Curve> moved_smoothly(const Curve& curve, double u, Side side, std::span<const Vector> moves,
                                    std::span<const std::size_t> pinned) {
    const Window window = window_around(curve, u, side);
    const auto conditions = smoothness_conditions(curve, window.range);
    const RationalBasis basis = rational_basis(curve, u, static_cast<int>(moves.size()) - 1, side);
    if (!touches(curve, conditions, basis)) return std::nullopt;
    LeastMoves least(curve, window);
    for (const std::size_t i : pinned) least.require({i, {1.0}, Vector{}});
    for (const MoveCondition& condition : conditions) least.require(condition);
    for (std::size_t k = 0; k < moves.size(); ++k) least.require({basis.first, basis.derivatives[k], moves[k]});
    auto found = least.solve();
    if (!found) return std::nullopt;
    for (const std::size_t i : pinned)
        if (i - window.first < found->size()) (*found)[i - window.first] = Vector{};
    auto moved = with_moves(curve, window.first, *found);
    return moved ? std::optional(*std::move(moved)) : std::nullopt;
}

Result<Curve> with_moves(const Curve& curve, std::size_t first, std::span<const Vector> moves) {
    CurveDefinition definition = curve.definition();
    for (std::size_t i = 0; i < moves.size(); ++i) definition.points[first + i] += moves[i];
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
