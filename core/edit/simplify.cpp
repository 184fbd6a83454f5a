#include "core/edit/simplify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/edit/refit.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/refine/knot_removal.h"

namespace batten::core {

namespace {

// How much more than the tolerance the removal alone may cost, since the fit makes up for it; in falling order.
constexpr std::array factors{300.0, 100.0, 30.0, 10.0, 3.0};
constexpr int most_fits = 8;  // for one factor, each of which keeps more knots

// The knots that may go.
std::vector<double> spare_knots(const Curve& curve) {
    std::vector<double> spare;
    for (const DistinctKnot& knot : distinct_knots(curve.knots())) spare.push_back(knot.value);
    if (curve.degree() == 1) return spare;
    for (const JointContinuity& joint : joint_continuity(curve))
        if (joint.geometric < 1 && !(std::abs(joint.angle.value_or(least_corner)) < least_corner))
            std::erase(spare, joint.u);
    return spare;
}

// The stretches between knots of `found`, and one more on either side, in which it is farther than `tolerance` from
// `curve` somewhere, ascending.
std::vector<Interval> bad_stretches(const Curve& curve, const Curve& found, double tolerance) {
    constexpr int samples = 8;
    std::vector<double> breaks;
    for (const DistinctKnot& knot : distinct_knots(found.knots()))
        if (found.domain().contains(knot.value)) breaks.push_back(knot.value);
    std::vector<Interval> bad;
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
        for (int k = 0; k < samples; ++k) {
            const double u = breaks[s] + (breaks[s + 1] - breaks[s]) * (k + 0.5) / samples;
            if (distance(point_at(curve, u), point_at(found, u)) <= tolerance) continue;
            bad.push_back({breaks[s == 0 ? 0 : s - 1], breaks[std::min(s + 2, breaks.size() - 1)]});
            break;
        }
    return bad;
}

// Takes knots of the stretches off the list; whether there were any.
bool keep_within(std::vector<double>& spare, const std::vector<Interval>& stretches) {
    return std::erase_if(spare, [&](double knot) {
               return std::ranges::any_of(stretches, [knot](Interval stretch) { return stretch.contains(knot); });
           }) > 0;
}

// The best fit after removing what costs up to `factor` times the tolerance, with knots kept where that was too much.
std::optional<Approximation> with_factor(const Curve& curve, std::vector<double> spare, double tolerance, double factor,
                                         const Progress& progress) {
    for (int round = 0; round < most_fits; ++round) {
        const auto removed = remove_knots_among(curve, spare, factor * tolerance);
        if (!removed || removed->count == 0) return std::nullopt;
        auto fitted = refit(removed->curve, curve, progress);
        if (!fitted) return std::nullopt;
        if (fitted->error <= tolerance) return *std::move(fitted);
        if (!keep_within(spare, bad_stretches(curve, fitted->curve, tolerance))) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace

Result<Approximation> simplify(const Curve& curve, double tolerance, const Progress& progress) {
    const std::vector<double> spare = spare_knots(curve);
    const auto removed = remove_knots_among(curve, spare, tolerance);
    if (!removed) return refuse(removed.error());
    Approximation best{removed->curve, removed->error};
    const std::size_t count = factors.size();
    for (std::size_t k = 0; k < count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(count);
        const auto found = with_factor(curve, spare, tolerance, factors[k], part_of(progress, share, share));
        if (found && found->curve.control_points().size() < best.curve.control_points().size()) best = *found;
    }
    return best;
}

}  // namespace batten::core
