#include "exchange/svg/frame.h"

#include <algorithm>
#include <optional>

#include "core/curve/control_box.h"
#include "core/edit/transform.h"
#include "core/measure/bounds.h"

namespace batten::exchange {

namespace {

using core::Box;
using core::PlaneMap;
using core::Point;

std::optional<PlaneMap> inverse_of(const PlaneMap& map) {
    const auto& [x, y, last] = map.rows;
    const double determinant = x[0] * y[1] - x[1] * y[0];
    const PlaneMap inverse{.rows = {{{y[1] / determinant, -x[1] / determinant, -x[2]},
                                     {-y[0] / determinant, x[0] / determinant, -y[2]},
                                     {0.0, 0.0, 1.0}}},
                           .pivot = {x[2], y[2]}};
    if (!core::check_map(inverse)) return std::nullopt;
    return inverse;
}

// With room for rounding.
bool holds(const Box& outer, const Box& inner) {
    constexpr double rounding = 1e-9;
    const double room = rounding * std::max(outer.size().x, outer.size().y);
    return inner.lower.x >= outer.lower.x - room && inner.lower.y >= outer.lower.y - room &&
           inner.upper.x <= outer.upper.x + room && inner.upper.y <= outer.upper.y + room;
}

}  // namespace

bool is_cut_off(const core::Curve& curve, const SvgFrame* frame) {
    const Box box = frame == nullptr ? Box() : core::control_box(curve);
    for (; frame != nullptr; frame = frame->outer.get()) {
        const auto back = inverse_of(frame->map);
        if (!back) continue;
        Box around;
        for (const Point corner :
             {box.lower, box.upper, Point(box.lower.x, box.upper.y), Point(box.upper.x, box.lower.y)})
            around.include(core::mapped(*back, corner));
        if (holds(frame->box, around)) continue;
        const auto seen = core::transform(curve, *back);
        if (seen && !holds(frame->box, core::tight_box(*seen))) return true;
    }
    return false;
}

}  // namespace batten::exchange
