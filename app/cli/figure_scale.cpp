#include "app/cli/figure_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/curve/control_box.h"
#include "core/edit/transform.h"

namespace batten::cli {

namespace {

constexpr core::Interval drawn_sizes{1e-10, 1e10};
constexpr int most_exponent = 500;  // in one step, whose square is a double

core::Curve scaled(const core::Curve& curve, int exponent) {
    core::Curve result = curve;
    while (exponent != 0) {
        const int step = std::clamp(exponent, -most_exponent, most_exponent);
        const double factor = std::ldexp(1.0, step);
        if (const auto mapped = core::transform(result, core::scaling(factor, factor, {0.0, 0.0}))) result = *mapped;
        exponent -= step;
    }
    return result;
}

}  // namespace

int drawn_exponent(const core::Document& document) {
    double size = 0.0;
    double farthest = 0.0;
    for (const core::DocumentCurve& entry : document.curves) {
        if (!entry.visible) continue;
        const core::Box box = core::control_box(*entry.curve);
        // Halves, since the whole may be more than the largest double.
        const core::Vector half = 0.5 * core::vector_to(box.upper) - 0.5 * core::vector_to(box.lower);
        size = std::max({size, half.x, half.y});
        for (const core::Point corner : {box.lower, box.upper})
            farthest = std::max({farthest, std::abs(corner.x), std::abs(corner.y)});
    }
    if (size == 0.0 || (drawn_sizes.contains(size) && drawn_sizes.upper >= farthest)) return 0;
    return -std::ilogb(size);
}

core::Document drawn_document(const core::Document& document, int exponent) {
    core::Document drawn = document;
    const auto moved = [&](core::Point place) {
        return core::Point(std::ldexp(place.x, exponent), std::ldexp(place.y, exponent));
    };
    for (core::DocumentCurve& entry : drawn.curves) {
        entry.curve = std::make_shared<const core::Curve>(scaled(*entry.curve, exponent));
        entry.fit.reset();
    }
    for (core::Picture& picture : drawn.pictures) {
        picture.position = moved(picture.position);
        picture.scale = std::ldexp(picture.scale, exponent);
    }
    for (core::Guide& guide : drawn.guides) guide.point = moved(guide.point);
    return drawn;
}

bool has_lengths(const editor::Overlays& overlays) {
    using enum editor::Overlay;
    constexpr std::array measured{grid,          rulers,           speed_plot,      curvature_plot, osculating_circle,
                                  equal_lengths, polygon_distance, end_derivatives, curvature_marks};
    return std::ranges::any_of(measured, [&](editor::Overlay overlay) { return overlays.is_shown(overlay); });
}

}  // namespace batten::cli
