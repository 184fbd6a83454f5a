#include "exchange/svg/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/curve/control_box.h"
#include "core/edit/transform.h"
#include "core/measure/bounds.h"

namespace batten::exchange {

namespace {

using core::Box;
using core::PlaneMap;
using core::Point;
using core::Vector;

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

// What contains `box` where `map` takes it; that of a box is one where nothing turns.
Box mapped_box(const PlaneMap& map, const Box& box) {
    Box around;
    if (box.is_empty()) return around;
    for (const Point corner : {box.lower, box.upper, Point(box.lower.x, box.upper.y), Point(box.upper.x, box.lower.y)})
        around.include(core::mapped(map, corner));
    return around;
}

bool is_upright(const PlaneMap& map) {
    const auto& [x, y, last] = map.rows;
    return x[1] == 0.0 && y[0] == 0.0;
}

// How far rounding moves what `back` takes from the `box` in the plane, along each axis.
Vector rounding_of(const PlaneMap& back, const Box& box) {
    constexpr double few = 8.0 * std::numeric_limits<double>::epsilon();
    const auto& [x, y, last] = back.rows;
    const double far_x = std::max({std::abs(box.lower.x), std::abs(box.upper.x), std::abs(back.pivot.x)});
    const double far_y = std::max({std::abs(box.lower.y), std::abs(box.upper.y), std::abs(back.pivot.y)});
    return {few * (std::abs(x[0]) * far_x + std::abs(x[1]) * far_y),
            few * (std::abs(y[0]) * far_x + std::abs(y[1]) * far_y)};
}

// With `rounding`, and what arithmetic in the frame can add.
bool holds(const Box& outer, const Box& inner, Vector rounding) {
    constexpr double share = 1e-9;
    const Vector room = rounding + share * outer.size();
    return inner.is_empty() || (inner.lower.x >= outer.lower.x - room.x && inner.lower.y >= outer.lower.y - room.y &&
                                inner.upper.x <= outer.upper.x + room.x && inner.upper.y <= outer.upper.y + room.y);
}

// Boxes of a curve, each computed where it is asked for.
class CurveBoxes {
  public:
    explicit CurveBoxes(const core::Curve& curve) : curve_(curve), rough_(core::control_box(curve)) {}

    const Box& rough() const { return rough_; }

    // The tight one where `back` takes the curve; that of the control points once many were turned.
    Box tight_in(const PlaneMap& back) {
        if (is_upright(back)) {
            if (!tight_) tight_ = core::tight_box(curve_);
            return mapped_box(back, *tight_);
        }
        if (turned_ == most_turned_frames) return mapped_box(back, rough_);
        ++turned_;
        const auto seen = core::transform(curve_, back);
        return seen ? core::tight_box(*seen) : Box();
    }

  private:
    const core::Curve& curve_;
    Box rough_;                   // of the control points
    std::optional<Box> tight_{};  // in the plane
    std::size_t turned_ = 0;
};

}  // namespace

bool is_cut_off(const core::Curve& curve, const SvgFrame* frame) {
    if (frame == nullptr) return false;
    CurveBoxes boxes(curve);
    for (; frame != nullptr; frame = frame->outer.get()) {
        const auto back = inverse_of(frame->map);
        if (!back) continue;
        const Vector rounding = rounding_of(*back, boxes.rough());
        if (holds(frame->box, mapped_box(*back, boxes.rough()), rounding)) continue;
        if (!holds(frame->box, boxes.tight_in(*back), rounding)) return true;
    }
    return false;
}

}  // namespace batten::exchange
