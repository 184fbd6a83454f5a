/// How far a curve is from its control polygon.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// A bound of the largest distance |C(u) - L(u)| over the domain, where L runs along the control polygon, from each
/// corner P_i at its Greville abscissa to the next one (in homogeneous coordinates, as C does): so no point of either
/// is farther from the other. As close and as dear as largest_deviation(). Inserting knots in the middle of all spans
/// divides it by about 4. Legs of an unclamped curve count as far as they lie over its domain, the leg across a tear
/// not at all. Infinite where it is too large for a double, or where knots are so close together that doubles cannot
/// tell the abscissae apart. Source: Cohen and Schumaker 1985.
double polygon_distance(const Curve& curve);

}  // namespace batten::core
