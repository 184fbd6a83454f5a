#include "app/editor/scene/seen_line.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

namespace {

constexpr double stroke_margin_px = 8.0;
// A place of a stroke takes up to four vertices: with those of its parts a curve has at most eight for each pixel.
constexpr double places_of_curve = 1.5;
constexpr double places_of_polygon = 2.0;
constexpr double least_seen_width_px = 100.0;

core::StripRequest strip_request(const CanvasFrame& frame, double places_per_px) {
    const render::Camera& camera = frame.state.view.camera;
    const double width = frame.state.view.parts.fineness * std::max(camera.size_px.x, least_seen_width_px);
    return {line_tolerance_px(frame) / camera.scale, frame.seen(frame.pen.px(stroke_margin_px)),
            static_cast<std::size_t>(places_per_px * width)};
}

std::vector<std::vector<glm::dvec2>> screen_runs(const CanvasFrame& frame, const core::PointRuns& runs) {
    std::vector<std::vector<glm::dvec2>> places;
    places.reserve(runs.size());
    for (const auto& run : runs) places.push_back(frame.screen(run));
    return places;
}

/// Where points of the world are.
struct OnCanvas {
    const CanvasFrame& frame;

    double scale() const { return frame.state.view.camera.scale; }
    glm::dvec2 operator()(core::Point world) const { return frame.screen(world); }
};

/// What paints chords of a line of the canvas, as far as it is in `view`, into `map`.
core::ChordRequest canvas_request(const CanvasFrame& frame, const InkPlace& place, const core::Box& view,
                                  render::CoverageMap& map, double tolerance_px = ink_tolerance_px) {
    const OnCanvas screen{frame};
    return chord_request(place, {tolerance_px / screen.scale(), view}, screen, map);
}

/// The line as ink: visit(request, left_out) and visit_part(request, part) hand out its chords.
template <class Visit, class VisitPart>
SeenLine inked(const CanvasFrame& frame, KeptInk& kept, const core::StripChange& change, const Stroke& stroke,
               Visit visit, VisitPart visit_part) {
    const InkPlace place = ink_place(frame, stroke);
    const KeptInk* above = frame.curve_line.ink ? &frame.kept->curve_ink() : nullptr;
    const auto paint = [&](render::CoverageMap& map, const core::Box& view, std::span<const std::size_t> left_out) {
        visit(canvas_request(frame, place, view, map), left_out);
    };
    const auto paint_part = [&](render::CoverageMap& map, std::size_t part) {
        visit_part(canvas_request(frame, place, frame.seen(frame.pen.px(stroke_margin_px)), map), part);
    };
    kept.follow(change, place, above, {paint, paint_part});
    return {{}, {}, kept.whole()};
}

}  // namespace

double line_tolerance_px(const CanvasFrame& frame) {
    // The distance of a chord grows with the square of its length.
    return ink_tolerance_px / std::pow(frame.state.view.parts.fineness, 2);
}

InkPlace ink_place(const CanvasFrame& frame, const Stroke& stroke) {
    return {frame.state.view.camera,
            glm::ivec2(glm::ceil(frame.pen.size_px())),
            {frame.pen.px(stroke.width), frame.pen.px(stroke.dash), frame.pen.px(stroke.gap)}};
}

void paint_curve(const CanvasFrame& frame, const core::CurveStrips& strips, const InkPlace& place, double tolerance_px,
                 render::CoverageMap& map) {
    const core::Box view = frame.seen(frame.pen.px(stroke_margin_px));
    strips.visit_chords(canvas_request(frame, place, view, map, tolerance_px), strips.curve()->domain());
}

SeenLine seen_part(const CanvasFrame& frame, core::CurveStrips& strips, core::Interval range, double places_per_px,
                   const Stroke& stroke) {
    const core::StripRequest request = strip_request(frame, places_per_px);
    if (const auto runs = strips.runs(request, range)) return {screen_runs(frame, *runs), {}, {}};
    const InkPlace place = ink_place(frame, stroke);
    auto map = std::make_shared<render::CoverageMap>(place.size_px);
    strips.visit_chords(canvas_request(frame, place, request.view, *map), range);
    return {{}, {}, map};
}

std::optional<SeenLine> seen_polylines(const CanvasFrame& frame, core::CurveStrips& strips) {
    const auto runs = strips.runs(strip_request(frame, places_of_curve), strips.curve()->domain());
    if (!runs) return std::nullopt;
    return SeenLine{screen_runs(frame, *runs), {}, {}};
}

SeenLine seen_curve(const CanvasFrame& frame, KeptCurve& kept, const Stroke& stroke) {
    core::CurveStrips& strips = kept.strips();
    if (auto line = seen_polylines(frame, strips)) return std::move(*line);
    const core::Interval domain = strips.curve()->domain();
    return inked(
        frame, kept.curve_ink(), strips.change(), stroke,
        [&](const core::ChordRequest& request, std::span<const std::size_t> left_out) {
            strips.visit_chords(request, domain, left_out);
        },
        [&](const core::ChordRequest& request, std::size_t span) { strips.visit_span_chords(request, span); });
}

SeenLine seen_polygon(const CanvasFrame& frame, KeptCurve& kept, const Stroke& stroke) {
    const core::PolygonStrips& polygon = kept.polygon();
    if (auto seen = polygon.runs(strip_request(frame, places_of_polygon))) {
        for (double& start : seen->starts) start *= frame.state.view.camera.scale;
        return {screen_runs(frame, seen->runs), std::move(seen->starts), {}};
    }
    return inked(
        frame, kept.polygon_ink(), polygon.change(), stroke,
        [&](const core::ChordRequest& request, std::span<const std::size_t> left_out) {
            polygon.visit_chords(request, left_out);
        },
        [&](const core::ChordRequest& request, std::size_t leg) { polygon.visit_leg_chord(request, leg); });
}

void draw_line(CanvasFrame& frame, const SeenLine& line, const Stroke& stroke) {
    for (std::size_t k = 0; k < line.runs.size(); ++k)
        frame.pen.line(line.runs[k], stroke, line.starts.empty() ? 0.0 : line.starts[k]);
    if (line.ink) frame.pen.ink(line.ink, stroke.color);
}

}  // namespace batten::editor
