/// Cuts curves where they cross, and lets them go on until they meet.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// The parameters at which a curve crosses or touches itself or one of `others`, ascending and each once, of pieces
/// that coincide both ends; those at the ends of an open curve are left out, and one where the ends of a curve meet is
/// at its lower end. Right to about 1e-13 of the size. Cost: that of the intersections.
std::vector<double> crossing_parameters(const Curve& curve, std::span<const Curve* const> others,
                                        const Progress& progress = {});

/// The part of the curve around `u` that lies between two neighbors of `cuts`, which are ascending, or an end of the
/// curve. A closed curve, periodic or with ends that meet, has no ends there: the part may reach over the seam, its
/// upper end then being above the domain. Error: nothing_crosses where there is no cut, or only one on a closed curve.
[[nodiscard]] Result<Interval> part_around(const Curve& curve, double u, std::span<const double> cuts);

/// What is left of the curve without the part from part_around(): two curves, or one where that part is at an end or
/// the curve closed, which goes on over its seam. Errors: those of sub_curve and join.
[[nodiscard]] Result<std::vector<Curve>> without_part(const Curve& curve, Interval part);

/// The parts between `cuts`, which are ascending and inside the domain; of a closed curve as many as there are cuts,
/// the first of which goes on over the seam. Errors: those of sub_curve and join.
[[nodiscard]] Result<std::vector<Curve>> split_at(const Curve& curve, std::span<const double> cuts);

/// How a curve goes on beyond its end.
enum class Onward {
    natural,  ///< as the polynomial of its last piece
    straight  ///< in the direction of its end
};

template <>
struct Names<Onward> {
    static constexpr std::array table{Named{Onward::natural, "natural", "as its last piece goes on"},
                                      Named{Onward::straight, "straight", "straight on"}};
};

/// The curve made longer at this end until it meets `other`, where it comes to that first; as it is where it ends there
/// already. It is sought over up to four times the size of both. Errors: curve_periodic; other_not_reached; those of
/// extend_length and extend_straight. Cost: that of the intersections.
[[nodiscard]] Result<Curve> extend_to(const Curve& curve, CurveEnd end, const Curve& other, Onward onward);

}  // namespace batten::core
