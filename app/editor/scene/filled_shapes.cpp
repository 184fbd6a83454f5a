#include "app/editor/scene/filled_shapes.h"

#include <algorithm>

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/curve_strokes.h"
#include "core/measure/continuity.h"

namespace batten::editor {

namespace {

constexpr std::uint8_t fill_alpha = 72;
constexpr double fill_margin_px = 2.0;
constexpr double farthest_loop_px = 1e6;
constexpr std::size_t most_loop_places = 60'000;
constexpr int most_coarsenings = 16;

/// A visible closed curve, by its place in the document.
struct ClosedItem {
    std::size_t index = 0;
    FilledShapes::Item item;
};

std::vector<ClosedItem> closed_curves(const CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    std::vector<ClosedItem> found;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const core::DocumentCurve& entry = document.curves[i];
        if (!entry.visible || !core::is_closed(*entry.curve)) continue;
        render::Color color = color_of(entry, frame.theme);
        color.alpha = fill_alpha;
        found.push_back({i, {entry.curve, color}});
    }
    return found;
}

/// The same side of the picture, so near that painters can count it in pixels.
render::Pixel near_pixel(glm::dvec2 place) {
    return {static_cast<float>(std::clamp(place.x, -farthest_loop_px, farthest_loop_px)),
            static_cast<float>(std::clamp(place.y, -farthest_loop_px, farthest_loop_px))};
}

/// The curve as one loop; one with too many places is coarser.
std::vector<render::Pixel> loop_of(CanvasFrame& frame, const ClosedItem& closed) {
    core::CurveStrips& strips = frame.cache.curve(closed.index, closed.item.curve).strips();
    core::StripRequest request{line_tolerance_px(frame) / frame.state.view.camera.scale, frame.seen(fill_margin_px),
                               most_loop_places};
    std::optional<core::PointRuns> runs = strips.outline(request);
    for (int k = 0; k < most_coarsenings && !runs; ++k) {
        request.tolerance *= 4.0;
        runs = strips.outline(request);
    }
    std::vector<render::Pixel> loop;
    if (!runs) return loop;
    for (const auto& run : *runs)
        for (const core::Point point : run) loop.push_back(near_pixel(frame.screen(point)));
    return loop;
}

std::vector<render::Region> regions_of(CanvasFrame& frame, const std::vector<ClosedItem>& curves,
                                       const FilledShapes& wanted) {
    std::vector<render::Region> regions;
    std::vector<std::shared_ptr<render::RegionLoops>> shapes;
    for (const ClosedItem& closed : curves) {
        const auto of_color = std::find_if(regions.begin(), regions.end(), [&](const render::Region& region) {
            return region.color == closed.item.color;
        });
        const auto k = static_cast<std::size_t>(of_color - regions.begin());
        if (of_color == regions.end()) {
            shapes.push_back(std::make_shared<render::RegionLoops>());
            shapes.back()->rule = wanted.rule;
            regions.push_back({shapes.back(), nullptr, closed.item.color});
        }
        shapes[k]->loops.push_back(loop_of(frame, closed));
    }
    for (render::Region& region : regions)
        region.map =
            std::make_shared<render::CoverageMap>(render::region_coverage(*region.loops, wanted.place.size_px));
    return regions;
}

}  // namespace

void draw_filled_shapes(CanvasFrame& frame) {
    const bool is_even_odd = frame.shows(Overlay::even_odd_fill);
    if (!is_even_odd && !frame.shows(Overlay::fill)) return;
    const std::vector<ClosedItem> curves = closed_curves(frame);
    FilledShapes wanted{
        ink_place(frame, {}), is_even_odd ? render::FillRule::even_odd : render::FillRule::non_zero, {}, {}};
    for (const ClosedItem& closed : curves) wanted.items.push_back(closed.item);
    FilledShapes& kept = frame.cache.fills();
    const bool is_kept = kept.place == wanted.place && kept.rule == wanted.rule && kept.items == wanted.items;
    if (!is_kept) {
        wanted.regions = regions_of(frame, curves, wanted);
        kept = std::move(wanted);
    }
    for (const render::Region& region : kept.regions) frame.pen.region(region);
}

}  // namespace batten::editor
