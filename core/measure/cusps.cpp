#include "core/measure/cusps.h"

#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

std::optional<double> turn_at(const Curve& curve, Interval where) {
    const Interval domain = curve.domain();
    const bool is_end = where.lower == domain.lower || where.upper == domain.upper;
    if (is_end && !curve.is_periodic()) return std::nullopt;
    const auto before = tangent_at(curve, where.lower, Side::left);
    const auto after = tangent_at(curve, where.upper, Side::right);
    if (!before || !after) return std::nullopt;
    return angle_between(*before, *after);
}

}  // namespace

std::vector<Cusp> cusps(const Curve& curve) {
    std::vector<Cusp> result;
    for (const SignEvent& event : sign_events(sign_runs_along(curve, 1, speed_squared), curve.is_periodic())) {
        const double u = event.where.lower + 0.5 * event.where.length();
        result.push_back({event.where, u, point_at(curve, u), turn_at(curve, event.where)});
    }
    return result;
}

}  // namespace batten::core
