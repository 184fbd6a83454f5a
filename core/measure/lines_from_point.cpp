#include "core/measure/lines_from_point.h"

#include <cassert>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

/// W (C - from) along each axis, where forms[axis] is W C seen from the middle of the curve.
Bernstein way_from(std::span<const Bernstein> forms, std::size_t axis, double from) {
    return difference(forms[axis], scaled(forms[2], from));
}

std::vector<CurveSample> zeros_along(const Curve& curve, const Expression& expression) {
    std::vector<CurveSample> samples;
    for (const SignEvent& event : sign_events(sign_runs_along(curve, 1, expression))) {
        if (event.where.length() > 0.0 || event.is_jump) continue;
        samples.push_back({event.where.lower, point_at(curve, event.where.lower)});
    }
    return samples;
}

/// `from` in the coordinates of the forms of `curve`.
Point in_forms(const Curve& curve, Point from) {
    assert(is_finite(from));
    const Vector way = from - middle_of(curve);
    return tip_of(form_scale(curve) * way);
}

}  // namespace

std::vector<CurveSample> perpendicular_feet(const Curve& curve, Point from) {
    const Point origin = in_forms(curve, from);
    return zeros_along(curve, [origin](std::span<const Bernstein> forms) {
        return sum(product(way_from(forms, 0, origin.x), hodograph_x(forms)),
                   product(way_from(forms, 1, origin.y), hodograph_y(forms)));
    });
}

std::vector<CurveSample> tangent_points(const Curve& curve, Point from) {
    const Point origin = in_forms(curve, from);
    return zeros_along(curve, [origin](std::span<const Bernstein> forms) {
        return difference(product(way_from(forms, 0, origin.x), hodograph_y(forms)),
                          product(way_from(forms, 1, origin.y), hodograph_x(forms)));
    });
}

}  // namespace batten::core
