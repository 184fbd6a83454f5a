#include "core/refine/knot_removal.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/curve/detail/edit_checks.h"
#include "core/measure/deviation.h"
#include "core/refine/detail/removable_knot.h"
#include "core/refine/detail/removal_reach.h"

namespace batten::core {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

// In one round only what costs little beside the rest, so that a dear knot is not removed before its cheap neighbors.
constexpr double costlier_in_a_round = 8.0;
constexpr double negligible_part_of_tolerance = 1e-3;

// How many of the knots `u` may go.
Result<int> removable_count(const Curve& curve, double u) {
    if (const auto check = check_parameter_finite(u); !check) return refuse(check.error());
    const KnotVector& knots = curve.knots();
    const Interval domain = curve.domain();
    const bool is_inside = curve.is_periodic() ? domain.contains(u) : domain.lower < u && u < domain.upper;
    const int multiplicity = knots.multiplicity(u);
    if (!is_inside || multiplicity == 0) return refuse({.code = CurveErrorCode::knot_not_found, .value = u});
    const auto stored = knots.stored();
    const auto index = static_cast<std::size_t>(std::lower_bound(stored.begin(), stored.end(), u) - stored.begin());
    const bool is_seam = curve.is_periodic() && (u == domain.lower || u == domain.upper);
    int most = is_seam ? multiplicity - 1 : multiplicity;
    if (curve.is_periodic()) most = std::min(most, static_cast<int>(curve.control_points().size()) - 2);
    if (most < 1) return refuse({.code = CurveErrorCode::knot_not_removable, .index = index});
    return most;
}

std::optional<Curve> without_knot(const Curve& curve, double u) {
    if (!has_room_for_removal(curve)) {
        auto found = cramped_removal(curve, u);
        return found ? std::optional(std::move(found->curve)) : std::nullopt;
    }
    const CarriedSpline spline = unrolled_for_removal(curve);
    const bool is_upper_end = curve.is_periodic() && u == curve.domain().upper;
    auto knot = removable_knot(spline, spline.last_of_run(is_upper_end ? curve.domain().lower : u));
    if (!knot) return std::nullopt;
    const auto stored = curve.knots().stored();
    knot->from_upper_end = is_upper_end && stored[stored.size() - 2] == u;
    const auto result = without_knots(curve, spline, std::span(&*knot, 1));
    return result ? std::optional(*result) : std::nullopt;
}

// Removes the knot `u` so many times at most.
KnotRemoval removed_often(const Curve& curve, double u, int times, double tolerance) {
    KnotRemoval result{.curve = curve};
    while (result.count < times) {
        auto next = without_knot(result.curve, u);
        const double error = next ? largest_deviation(curve, *next) : unlimited;
        if (!(error <= tolerance)) {
            result.refused = error;
            break;
        }
        result.curve = *std::move(next);
        result.error = error;
        ++result.count;
    }
    return result;
}

// Removes what can be spared, round by round, and keeps account of what each span has had to bear.
class Thinning {
  public:
    // Takes knots of all values, or only `among` these.
    Thinning(const Curve& curve, std::optional<std::span<const double>> among, double tolerance,
             const Progress& progress)
        : progress_(progress),
          point_count_(curve.control_points().size()),
          curve_(curve),
          has_weights_(curve.is_rational()),
          among_(among),
          tolerance_(tolerance),
          spent_(curve.knots().stored().size(), 0.0) {}

    bool remove_some() { return has_room_for_removal(curve_) ? remove_apart() : remove_one_cramped(); }
    const Curve& curve() const { return curve_; }

  private:
    // All may go but as many points as a curve has at least.
    void tell_how_many_are_gone() const {
        tell(progress_, point_count_ - curve_.control_points().size(), point_count_);
    }

    // The span of stored() that knot or span `i` of the unrolled spline is.
    std::size_t stored_span(std::size_t i) const {
        const std::size_t n = curve_.control_points().size();
        return curve_.is_periodic() ? (i + n - removal_offset(curve_) % n) % n : i;
    }

    double spent_within(const CarriedSpline& spline, const RemovableKnot& knot) const {
        double most = 0.0;
        for (std::size_t i = knot.first; i < knot.first + knot.replaced + spline.p; ++i)
            most = std::max(most, spent_[stored_span(i)]);
        return most;
    }

    std::vector<std::size_t> wanted_indices(const CarriedSpline& spline) const {
        std::vector<std::size_t> indices = removable_indices(curve_, spline);
        if (among_)
            std::erase_if(indices, [&](std::size_t i) {
                return !std::binary_search(among_->begin(), among_->end(), spline.knots[i]);
            });
        return indices;
    }

    // Those that the tolerance allows, the cheapest first.
    std::vector<RemovableKnot> affordable(const CarriedSpline& spline) const {
        std::vector<RemovableKnot> knots;
        for (const std::size_t index : wanted_indices(spline)) {
            tell_how_many_are_gone();
            auto knot = removable_knot(spline, index);
            if (!knot) continue;
            const double left = tolerance_ - spent_within(spline, *knot);
            if (knot->bound > left && has_weights_) knot->bound = nearer_bound(spline, *knot, left);
            if (knot->bound <= left) knots.push_back(*std::move(knot));
        }
        std::sort(knots.begin(), knots.end(), [](const auto& a, const auto& b) { return a.bound < b.bound; });
        return knots;
    }

    // Those that do not meet, ascending.
    std::vector<RemovableKnot> chosen(const CarriedSpline& spline) const {
        std::vector<RemovableKnot> candidates = affordable(spline);
        if (candidates.empty()) return {};
        const double limit =
            std::max(costlier_in_a_round * candidates.front().bound, negligible_part_of_tolerance * tolerance_);
        const std::size_t apart = spline.p + 2;
        std::vector<bool> is_taken(curve_.knots().stored().size() + apart, false);
        std::vector<RemovableKnot> knots;
        for (RemovableKnot& candidate : candidates) {
            if (candidate.bound > limit) break;
            if (is_taken[stored_span(candidate.index)]) continue;
            for (std::size_t i = candidate.index + 1 - apart; i < candidate.index + apart; ++i)
                is_taken[stored_span(i)] = true;
            knots.push_back(std::move(candidate));
        }
        std::sort(knots.begin(), knots.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
        return knots;
    }

    void spend(const CarriedSpline& spline, std::span<const RemovableKnot> removed) {
        for (const RemovableKnot& knot : removed) {
            const double total = knot.bound + spent_within(spline, knot);
            for (std::size_t i = knot.first; i < knot.first + knot.replaced + spline.p; ++i)
                spent_[stored_span(i)] = total;
        }
        constexpr double gone = -1.0;
        for (const RemovableKnot& knot : removed) {
            const std::size_t span = stored_span(knot.index);
            // A seam's only knot at the lower end stays, and one at the upper end goes.
            const bool is_at_upper_end = curve_.is_periodic() && span == 0;
            (is_at_upper_end ? spent_.back() : spent_[span]) = gone;
        }
        std::erase(spent_, gone);
    }

    bool remove_apart() {
        const CarriedSpline spline = unrolled_for_removal(curve_);
        const std::vector<RemovableKnot> removed = chosen(spline);
        if (removed.empty()) return false;
        auto next = without_knots(curve_, spline, removed);
        if (!next) return false;
        spend(spline, removed);
        curve_ = *std::move(next);
        return true;
    }

    // So few points that every removal reaches all of them: what was borne so far is borne everywhere.
    bool remove_one_cramped() {
        const double spent = *std::max_element(spent_.begin(), spent_.end());
        std::optional<CrampedRemoval> best;
        if (curve_.control_points().size() <= 2) return false;
        const CarriedSpline spline = unrolled_for_removal(curve_);
        tell_how_many_are_gone();
        for (const std::size_t index : wanted_indices(spline)) {
            auto found = cramped_removal(curve_, spline.knots[index]);
            if (found && (!best || found->bound < best->bound)) best = std::move(found);
        }
        if (!best || !(best->bound + spent <= tolerance_)) return false;
        curve_ = std::move(best->curve);
        spent_.assign(curve_.knots().stored().size(), best->bound + spent);
        return true;
    }

    const Progress& progress_;
    std::size_t point_count_;  // of the curve as it was given
    Curve curve_;
    bool has_weights_;
    std::optional<std::span<const double>> among_;
    double tolerance_;
    std::vector<double> spent_;  // by span of stored()
};

}  // namespace

Result<KnotRemoval> remove_knot(const Curve& curve, double u, int times, double tolerance) {
    assert(times >= 1);
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    const auto most = removable_count(curve, u);
    if (!most) return refuse(most.error());
    const auto reach = curve_in_reach(curve, u);
    if (!reach) return removed_often(curve, u, std::min(times, *most), tolerance);
    KnotRemoval result = removed_often(reach->curve, u, std::min(times, *most), tolerance);
    result.curve = result.count > 0 ? with_part_exchanged(curve, *reach, result.curve, u) : curve;
    return result;
}

namespace {

Result<KnotRemoval> thinned(const Curve& curve, std::optional<std::span<const double>> among, double tolerance,
                            const Progress& progress) {
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    Thinning thinning(curve, among, tolerance, progress);
    while (thinning.remove_some()) {
    }
    const auto count = curve.control_points().size() - thinning.curve().control_points().size();
    const double error = largest_deviation(curve, thinning.curve());
    // Where the tolerance is below what rounding leaves, nothing is small enough.
    if (!(error <= tolerance)) return KnotRemoval{.curve = curve, .refused = error};
    return KnotRemoval{.curve = thinning.curve(), .count = static_cast<int>(count), .error = error};
}

}  // namespace

Result<KnotRemoval> remove_knots(const Curve& curve, double tolerance, const Progress& progress) {
    return thinned(curve, std::nullopt, tolerance, progress);
}

Result<KnotRemoval> remove_knots_among(const Curve& curve, std::span<const double> among, double tolerance) {
    assert(std::is_sorted(among.begin(), among.end()));
    return thinned(curve, among, tolerance, {});
}

}  // namespace batten::core
