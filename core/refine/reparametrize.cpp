#include "core/refine/reparametrize.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/detail/bspline.h"
#include "core/curve/detail/edit_checks.h"

namespace batten::core {

namespace {

// Maps every knot by `map`, which does not decrease but for rounding.
template <class Map>
Result<Curve> with_mapped_knots(const Curve& curve, const Map& map) {
    CurveDefinition definition = curve.definition();
    const auto stored = curve.knots().stored();
    for (std::size_t i = 0; i < stored.size(); ++i) {
        definition.knots[i] = map(stored[i]);
        if (i == 0) continue;
        definition.knots[i] = std::max(definition.knots[i], definition.knots[i - 1]);
        if (stored[i - 1] < stored[i] && definition.knots[i - 1] == definition.knots[i])
            return refuse_computed({.code = CurveErrorCode::knots_coincide, .index = i, .value = definition.knots[i]});
    }
    return Curve::make(std::move(definition));
}

}  // namespace

Result<Curve> reparametrize(const Curve& curve, Interval range) {
    const auto check =
        check_parameter_finite(range.lower).and_then([&] { return check_parameter_finite(range.upper); });
    if (!check) return refuse(check.error());
    if (!(range.lower < range.upper))
        return refuse({.code = CurveErrorCode::range_empty, .lower = range.lower, .upper = range.upper});
    const Interval domain = curve.domain();
    return with_mapped_knots(
        curve, [&](double u) { return blend(range.lower, range.upper, ratio_between(domain.lower, domain.upper, u)); });
}

Result<Curve> shift_domain(const Curve& curve, double lower) {
    if (const auto check = check_parameter_finite(lower); !check) return refuse(check.error());
    const double begin = curve.domain().lower;
    if (lower == begin) return curve;
    return with_mapped_knots(curve, [&](double u) { return lower + (u - begin); });
}

}  // namespace batten::core
