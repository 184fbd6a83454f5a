#include "app/cli/drawn_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "core/curve/control_box.h"
#include "core/edit/transform.h"

namespace batten::cli {

namespace {

constexpr core::Interval drawn_sizes{1e-10, 1e10};
constexpr double farthest_in_sizes = 1e10;
constexpr int most_exponent = 500;  // in one step, whose square is a double

core::Curve mapped(const core::Curve& curve, const core::PlaneMap& map) {
    const auto result = core::transform(curve, map);
    return result ? *result : curve;
}

core::Curve scaled(const core::Curve& curve, int exponent) {
    core::Curve result = curve;
    while (exponent != 0) {
        const int step = std::clamp(exponent, -most_exponent, most_exponent);
        const double factor = std::ldexp(1.0, step);
        result = mapped(result, core::scaling(factor, factor, {0.0, 0.0}));
        exponent -= step;
    }
    return result;
}

/// The largest of the coordinates of the corners.
double distance_from_origin(const core::Box& box) {
    double farthest = 0.0;
    for (const core::Point corner : {box.lower, box.upper})
        farthest = std::max({farthest, std::abs(corner.x), std::abs(corner.y)});
    return farthest;
}

bool shows_any(const editor::Overlays& overlays, std::span<const editor::Overlay> wanted) {
    return std::ranges::any_of(wanted, [&](editor::Overlay overlay) { return overlays.is_shown(overlay); });
}

}  // namespace

DrawnPlace drawn_place(const core::Document& document) {
    core::Box whole;
    double size = 0.0;
    for (const core::DocumentCurve& entry : document.curves) {
        if (!entry.visible) continue;
        const core::Box box = core::control_box(*entry.curve);
        // Halves, since the whole may be more than the largest double.
        const core::Vector half = 0.5 * core::vector_to(box.upper) - 0.5 * core::vector_to(box.lower);
        size = std::max({size, half.x, half.y});
        whole.include(box.lower);
        whole.include(box.upper);
    }
    if (size == 0.0) return {};
    const double farthest = distance_from_origin(whole);
    const bool is_far = farthest / farthest_in_sizes > size && std::isfinite(whole.size().x + whole.size().y);
    const core::Vector offset = is_far ? -core::vector_to(whole.center()) : core::Vector(0.0, 0.0);
    const double reach = is_far ? size : farthest;
    return {offset, drawn_sizes.contains(size) && drawn_sizes.upper >= reach ? 0 : -std::ilogb(size)};
}

core::Document drawn_document(const core::Document& document, const DrawnPlace& place) {
    core::Document drawn = document;
    const auto moved = [&](core::Point point) {
        const core::Point near = point + place.offset;
        return core::Point(std::ldexp(near.x, place.exponent), std::ldexp(near.y, place.exponent));
    };
    for (core::DocumentCurve& entry : drawn.curves) {
        const core::Curve near = mapped(*entry.curve, core::translation(place.offset));
        entry.curve = std::make_shared<const core::Curve>(scaled(near, place.exponent));
        entry.fit.reset();
    }
    for (core::Picture& picture : drawn.pictures) {
        picture.position = moved(picture.position);
        picture.scale = std::ldexp(picture.scale, place.exponent);
    }
    for (core::Guide& guide : drawn.guides) guide.point = moved(guide.point);
    return drawn;
}

bool has_lengths(const editor::Overlays& overlays) {
    using enum editor::Overlay;
    constexpr std::array measured{grid,          rulers,           speed_plot,      curvature_plot, osculating_circle,
                                  equal_lengths, polygon_distance, end_derivatives, curvature_marks};
    return shows_any(overlays, measured);
}

bool has_coordinates(const editor::Overlays& overlays) {
    using enum editor::Overlay;
    constexpr std::array placed{grid, rulers};
    return shows_any(overlays, placed);
}

}  // namespace batten::cli
