#include "app/editor/state/fit_curve.h"

#include <utility>

#include "app/editor/state/point_hues.h"
#include "core/edit/transform.h"
#include "core/make/through_points.h"

namespace batten::editor {

core::Result<void> set_fit(core::DocumentCurve& entry, core::FitPoints fit) {
    return core::through_points(fit).map([&](core::Curve curve) {
        replace_curve(entry, std::make_shared<const core::Curve>(std::move(curve)));
        entry.fit = std::make_shared<const core::FitPoints>(std::move(fit));
    });
}

core::Result<void> map_entry(core::DocumentCurve& entry, const core::PlaneMap& map) {
    if (entry.fit != nullptr && map.is_affine())
        return core::check_map(map).and_then([&] { return set_fit(entry, mapped_fit(*entry.fit, map)); });
    return core::transform(*entry.curve, map).map([&](core::Curve curve) {
        replace_curve(entry, std::make_shared<const core::Curve>(std::move(curve)));
    });
}

core::FitPoints mapped_fit(core::FitPoints fit, const core::PlaneMap& map) {
    const core::Point origin = core::mapped(map, map.pivot);
    for (core::FitPoint& point : fit.points) {
        point.place = core::mapped(map, point.place);
        if (point.handle != core::Vector(0.0, 0.0)) point.handle = core::mapped(map, map.pivot + point.handle) - origin;
    }
    return fit;
}

}  // namespace batten::editor
