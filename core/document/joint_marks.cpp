#include "core/document/joint_marks.h"

namespace batten::core {

bool is_inner_knot(const Curve& curve, double u) {
    const Interval domain = curve.domain();
    if (curve.is_periodic() && u == domain.lower) return true;
    return domain.lower < u && u < domain.upper && curve.knots().multiplicity(u) > 0;
}

}  // namespace batten::core
