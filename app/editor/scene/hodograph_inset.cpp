#include "app/editor/scene/hodograph_inset.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/scene/panel_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double width = 200.0;
constexpr double inset_height = 150.0;
constexpr double inset_margin = 14.0;
constexpr double inset_padding = 14.0;
constexpr double title_height = 20.0;
constexpr std::size_t most_hodograph_spans = 2000;

using Run = std::vector<core::Vector>;

/// The derivative at the start of every so many spans.
std::vector<Run> sparse_hodograph(const core::Curve& curve, std::size_t stride) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    Run run;
    for (std::size_t s = p; s + p + 1 < knots.size(); s += stride) {
        const core::Vector v = core::derivatives_at(curve, knots[s], 1)[1];
        if (core::is_finite(v)) run.push_back(v);
    }
    return {run};
}

/// The derivative over each non-empty span, from its one-sided value at the start to that at the end; of very many
/// spans as many values as the inset can show.
std::vector<Run> hodograph_runs(const core::Curve& curve) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t stride = (knots.size() - 2 * p) / most_hodograph_spans + 1;
    if (stride > 1) return sparse_hodograph(curve, stride);
    const int steps = std::clamp(320 / static_cast<int>(knots.size() - 2 * p), 4, 40);
    std::vector<Run> runs;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        if (knots[s] == knots[s + 1]) continue;
        Run& run = runs.emplace_back();
        for (int k = 0; k <= steps; ++k) {
            const double u = k == steps ? knots[s + 1] : knots[s] + (knots[s + 1] - knots[s]) * k / steps;
            const core::Vector v =
                core::derivatives_at(curve, u, 1, k == steps ? core::Side::left : core::Side::right)[1];
            if (core::is_finite(v)) run.push_back(v);
        }
    }
    return runs;
}

/// Maps vectors into the box, all by one scale.
class InsetMap {
  public:
    InsetMap(const render::PixelBox& area, const std::vector<Run>& runs) {
        core::Box box;
        box.include({0.0, 0.0});
        for (const Run& run : runs)
            for (const core::Vector v : run) box.include(core::tip_of(v));
        const glm::dvec2 room = area.upper_px - area.lower_px;
        // Halves first: the difference of two huge values may not be finite.
        const core::Vector half = 0.5 * core::vector_to(box.upper) - 0.5 * core::vector_to(box.lower);
        const double larger = std::max(half.x / room.x, half.y / room.y);
        middle_ = core::middle(box.upper, box.lower);
        scale_ = larger > 0.0 && std::isfinite(1.0 / larger) ? 0.5 / larger : 0.0;
        center_ = area.lower_px + 0.5 * room;
    }

    glm::dvec2 operator()(core::Vector v) const {
        return center_ + scale_ * glm::dvec2(v.x - middle_.x, middle_.y - v.y);
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

/// Without the points that lie within half a pixel of their predecessor.
std::vector<glm::dvec2> thinned(const Run& run, const InsetMap& map) {
    std::vector<glm::dvec2> places;
    for (std::size_t k = 0; k < run.size(); ++k) {
        const glm::dvec2 place = map(run[k]);
        const bool is_last = k + 1 == run.size();
        if (is_last || places.empty() || glm::distance(places.back(), place) > 0.5) places.push_back(place);
    }
    return places;
}

}  // namespace

bool has_inset(const EditorState& state) {
    return state.visible_active_curve() != nullptr && state.view.overlays.is_shown(Overlay::hodograph);
}

render::PixelBox hodograph_box(const View& view) {
    const double scale = view.interface_scale;
    const glm::dvec2 upper{view.camera.size_px.x - scale * inset_margin, scale * (inset_margin + inset_height)};
    return {upper - scale * glm::dvec2(width, inset_height), upper};
}

void draw_hodograph_inset(CanvasFrame& frame) {
    const render::PixelBox box = hodograph_box(frame.state.view);
    Pen& pen = frame.pen;
    const Theme& theme = frame.theme;
    draw_panel_box(pen, theme, box);
    const glm::dvec2 corner = box.lower_px + glm::dvec2(pen.px(inset_padding));
    pen.text({corner.x, box.lower_px.y + pen.px(15.0)}, "Hodograph C′(u)", {.color = theme.dim, .size = 11.5});
    const render::PixelBox area{corner + glm::dvec2(0.0, pen.px(title_height - 4.0)),
                                box.upper_px - glm::dvec2(pen.px(inset_padding))};
    const std::vector<Run> runs = hodograph_runs(*frame.curve);
    const InsetMap map(area, runs);
    draw_axes(pen, theme, area, map({0.0, 0.0}));
    for (const Run& run : runs) pen.line(thinned(run, map), {.color = theme.curve, .width = 1.75});
    const core::Vector now = core::derivatives_at(*frame.curve, frame.triangle->u, 1)[1];
    if (!core::is_finite(now)) return;
    pen.segment(map({0.0, 0.0}), map(now), {.color = theme.parameter, .width = 1.5});
    pen.symbol(map(now), {.radius = 4.5, .fill = theme.parameter, .outline = theme.panel, .outline_width = 1.5});
}

}  // namespace batten::editor
