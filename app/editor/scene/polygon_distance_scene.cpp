#include "app/editor/scene/polygon_distance_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/editor/words/formula.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double round_width = 1.5;
constexpr double gap_width = 2.0;
constexpr double curve_end_radius = 3.0;
constexpr double gap_label_size = 15.0;
constexpr std::size_t most_gaps = 200;

/// A corner and the point of the curve at its abscissa.
struct Gap {
    core::Point corner;
    core::Point on_curve;

    double length() const { return core::distance(corner, on_curve); }
};

/// Those of corners whose abscissa is in the domain.
std::vector<Gap> gaps_of(const core::Curve& curve) {
    std::vector<Gap> gaps;
    const std::size_t n = curve.control_points().size();
    for (std::size_t i = 0; i + static_cast<std::size_t>(curve.degree()) + 1 < curve.knots().size(); ++i) {
        const double u = core::greville_abscissa(curve.knots(), i);
        if (!curve.domain().contains(u)) continue;
        // At a tear two corners have one abscissa, which is on the left of the second one.
        const bool is_left = i > 0 && core::greville_abscissa(curve.knots(), i - 1) < u;
        gaps.push_back({curve.control_points()[i % n],
                        core::derivatives_at(curve, u, 0, is_left ? core::Side::left : core::Side::right).point});
    }
    return gaps;
}

void wish_length(CanvasFrame& frame, const Gap& gap) {
    const glm::dvec2 from = frame.screen(gap.corner);
    const glm::dvec2 to = frame.screen(gap.on_curve);
    const bool is_steep = std::abs(to.y - from.y) >= std::abs(to.x - from.x);
    const glm::dvec2 middle = 0.5 * (from + to);
    const Units& units = frame.state.shown().units;
    frame.labels.push_back(
        {.place = middle,
         .words = {{with_unit(units, number_text(in_units(units, gap.length()))),
                    {.color = frame.theme.error, .size = gap_label_size, .font = render::LabelFont::bold}}},
         .distance = 12.0,
         .first = is_steep ? LabelSide::right : LabelSide::below,
         .crowding = Crowding::cover_symbols});
}

}  // namespace

render::Color round_color(const Theme& theme, std::size_t round) {
    constexpr double last_round = 3.0;
    if (round == 0) return theme.polygon;
    return render::blended(theme.comb, (static_cast<double>(round) - 1.0) / (last_round - 1.0), theme.accent);
}

void draw_polygon_rounds(CanvasFrame& frame) {
    const auto rounds = frame.state.derived.polygon_rounds(*frame.curve);
    for (std::size_t r = rounds->size(); r-- > 1;) {
        const core::Curve& refined = *(*rounds)[r].curve;
        std::vector<glm::dvec2> places = frame.screen(refined.control_points());
        if (refined.is_periodic()) places.push_back(places.front());
        frame.pen.line(places, {.color = round_color(frame.theme, r), .width = round_width});
    }
}

void draw_polygon_distances(CanvasFrame& frame) {
    if (frame.curve->control_points().size() > most_gaps || frame.curve->degree() == 1) return;
    const std::vector<Gap> gaps = gaps_of(*frame.curve);
    const auto is_seen = [&](const Gap& gap) {
        return gap.length() * frame.state.view.camera.scale >= frame.pen.px(1.0);
    };
    for (const Gap& gap : gaps)
        if (is_seen(gap))
            frame.pen.segment(frame.screen(gap.corner), frame.screen(gap.on_curve),
                              {.color = frame.theme.error, .width = gap_width});
    for (const Gap& gap : gaps)
        if (is_seen(gap))
            frame.pen.symbol(frame.screen(gap.on_curve),
                             {.radius = curve_end_radius, .fill = frame.theme.error, .outline = no_color});
    const auto longest = std::ranges::max_element(gaps, {}, &Gap::length);
    if (longest != gaps.end() && longest->length() > 0.0) wish_length(frame, *longest);
}

}  // namespace batten::editor
