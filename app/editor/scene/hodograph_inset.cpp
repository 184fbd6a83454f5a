#include "app/editor/scene/hodograph_inset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/editor/scene/panel_box.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double inset_padding = 14.0;
constexpr double title_height = 20.0;
constexpr double places_per_px = 4.0;  // of the picture's width
constexpr std::size_t most_sampled_spans = 2000;

std::size_t span_count(const core::Curve& curve) {
    return curve.knots().size() - 2 * static_cast<std::size_t>(curve.degree()) - 1;
}

std::size_t sampling_stride(const core::Curve& curve) {
    return span_count(curve) / most_sampled_spans + 1;
}

/// The derivative over each non-empty span, from its one-sided value at the start to that at the end, where the
/// hodograph is too large for a curve; of very many spans some.
core::PointRuns sampled_runs(const core::Curve& curve) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t spans = span_count(curve);
    const int steps = std::clamp(320 / static_cast<int>(spans), 4, 40);
    core::PointRuns runs;
    for (std::size_t s = p; s < p + spans; s += sampling_stride(curve)) {
        if (knots[s] == knots[s + 1]) continue;
        auto& run = runs.emplace_back();
        for (int k = 0; k <= steps; ++k) {
            const double u = k == steps ? knots[s + 1] : knots[s] + (knots[s + 1] - knots[s]) * k / steps;
            const core::Vector v =
                core::derivatives_at(curve, u, 1, k == steps ? core::Side::left : core::Side::right)[1];
            if (core::is_finite(v)) run.push_back(core::tip_of(v));
        }
    }
    return runs;
}

core::Box box_of(const core::PointRuns& runs) {
    core::Box box;
    for (const auto& run : runs)
        for (const core::Point tip : run) box.include(tip);
    return box;
}

/// Maps vectors into the box, all by one scale.
class InsetMap {
  public:
    InsetMap(const render::PixelBox& area, core::Box box) {
        box.include({0.0, 0.0});
        const glm::dvec2 room = area.upper_px - area.lower_px;
        // Halves first: the difference of two huge values may not be finite.
        const core::Vector half = 0.5 * core::vector_to(box.upper) - 0.5 * core::vector_to(box.lower);
        const double larger = std::max(half.x / room.x, half.y / room.y);
        middle_ = core::middle(box.upper, box.lower);
        scale_ = larger > 0.0 && std::isfinite(1.0 / larger) ? 0.5 / larger : 0.0;
        center_ = area.lower_px + 0.5 * room;
    }

    double scale() const { return scale_; }

    glm::dvec2 operator()(core::Point tip) const {
        return center_ + scale_ * glm::dvec2(tip.x - middle_.x, middle_.y - tip.y);
    }

  private:
    core::Point middle_{};
    glm::dvec2 center_{};
    double scale_ = 0.0;
};

void draw_axes(Pen& pen, const Theme& theme, const render::PixelBox& area, glm::dvec2 origin) {
    pen.segment({area.lower_px.x, origin.y}, {area.upper_px.x, origin.y}, {.color = theme.line});
    pen.segment({origin.x, area.lower_px.y}, {origin.x, area.upper_px.y}, {.color = theme.line});
}

std::string title_of(const CanvasFrame& frame) {
    const std::size_t spans = span_count(*frame.curve);
    if (frame.kept->hodograph() != nullptr || sampling_stride(*frame.curve) == 1) return "Hodograph C′(u)";
    return core::sentence("C′(u) on {shown} of {count} spans",
                          {{"shown", (spans - 1) / sampling_stride(*frame.curve) + 1}, {"count", spans}});
}

std::vector<glm::dvec2> places_of(const std::vector<core::Point>& run, const InsetMap& map) {
    std::vector<glm::dvec2> places;
    places.reserve(run.size());
    for (const core::Point tip : run) places.push_back(map(tip));
    return places;
}

/// The strips of the hodograph, null where it cannot be drawn as a curve.
core::CurveStrips* strips_of(const CanvasFrame& frame) {
    core::CurveStrips* strips = frame.kept->hodograph();
    return strips != nullptr && core::is_finite(strips->box().lower) && core::is_finite(strips->box().upper) ? strips
                                                                                                             : nullptr;
}

/// The polylines of the hodograph, so near that no feature of a pixel is missed; none where these have too many places.
std::optional<core::PointRuns> hodograph_runs(const CanvasFrame& frame, const render::PixelBox& area) {
    core::CurveStrips* strips = strips_of(frame);
    if (strips == nullptr) return sampled_runs(*frame.curve);
    const InsetMap map(area, strips->box());
    const double tolerance = std::max(line_tolerance_px / std::max(map.scale(), std::numeric_limits<double>::min()),
                                      std::numeric_limits<double>::min());
    const auto most = static_cast<std::size_t>(places_per_px * frame.pen.size_px().x);
    return strips->runs({tolerance, strips->box(), most}, strips->curve()->domain());
}

void draw_inked(CanvasFrame& frame, const core::CurveStrips& strips, const InsetMap& map, const Stroke& stroke) {
    const InkPlace place = ink_place(frame, stroke);
    auto ink = std::make_shared<render::CoverageMap>(place.size_px);
    strips.visit_chords(chord_request(place, {line_tolerance_px / map.scale(), strips.box()}, map, *ink),
                        strips.curve()->domain());
    frame.pen.ink(ink, stroke.color);
}

}  // namespace

void draw_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box) {
    Pen& pen = frame.pen;
    const Theme& theme = frame.theme;
    draw_panel_box(pen, theme, box);
    const glm::dvec2 corner = box.lower_px + glm::dvec2(pen.px(inset_padding));
    pen.text({corner.x, box.lower_px.y + pen.px(15.0)}, title_of(frame), {.color = theme.dim, .size = 11.5});
    const render::PixelBox area{corner + glm::dvec2(0.0, pen.px(title_height - 4.0)),
                                box.upper_px - glm::dvec2(pen.px(inset_padding))};
    const std::optional<core::PointRuns> runs = hodograph_runs(frame, area);
    const InsetMap map(area, runs ? box_of(*runs) : strips_of(frame)->box());
    draw_axes(pen, theme, area, map({0.0, 0.0}));
    const Stroke stroke{.color = theme.curve, .width = 1.75};
    if (!runs) draw_inked(frame, *strips_of(frame), map, stroke);
    if (runs)
        for (const auto& run : *runs) pen.line(places_of(run, map), stroke);
    const core::Point now = core::tip_of(core::derivatives_at(*frame.curve, frame.triangle->u, 1)[1]);
    if (!core::is_finite(now)) return;
    pen.segment(map({0.0, 0.0}), map(now), {.color = theme.parameter, .width = 1.5});
    pen.symbol(map(now), {.radius = 4.5, .fill = theme.parameter, .outline = theme.panel, .outline_width = 1.5});
}

}  // namespace batten::editor
