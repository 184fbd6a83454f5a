/// How far apart two curves are.
#pragma once

#include <optional>
#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// A bound of the largest distance |a(u) - b(u)| over both domains, matched affinely: never less than that distance but
/// for the last bits of the number itself, and at most 1e-4 of it more; where weights are so different or curves have
/// so many peaks that this takes too long, it may be more. The number shown beside a shape-changing edit, and the check
/// behind a shape-keeping one; both curves are compared at equal parameters, so a mere reparametrization counts as a
/// deviation. 0 for curves that are written the same, and infinite where it is too large for a double.
///
/// The control points of the difference of two pieces bound it; the piece with the largest bound is halved until its
/// bound agrees with a distance that was found. Cost O(p^2) for each span in which the curves are not written the same.
double largest_deviation(const Curve& a, const Curve& b);

/// The same; none where the curves are written differently in more than so many spans. Cost O(n) then.
std::optional<double> quick_deviation(const Curve& a, const Curve& b, std::size_t most_spans);

/// Parameters of two curves that belong together.
struct MatchedParameters {
    double of_a = 0.0;
    double of_b = 0.0;
};

/// Such a bound where the parameters are matched in another way than affinely: affinely between each of `matches`,
/// which ascend in both, from one end of both domains to the other, and the next one.
double largest_deviation(const Curve& a, const Curve& b, std::span<const MatchedParameters> matches);

}  // namespace batten::core
