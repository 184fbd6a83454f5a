#include "app/editor/scene/support_marks.h"

#include <fmt/core.h>

#include "app/editor/derived/support_points.h"
#include "app/editor/scene/curve_strokes.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double support_band_width = 12.0;
constexpr double band_step = 7.0;  // each further band is wider, so that all are seen
constexpr double support_band_share = 0.45;
constexpr double end_text_size = 12.5;
constexpr double strip_opacity = 0.14;
constexpr double axis_width = 6.0;

void mark_end(CanvasFrame& frame, double u, core::Side side, std::size_t point) {
    const glm::dvec2 place = frame.screen(core::point_at(*frame.curve, u, side));
    frame.pen.symbol(place, {.radius = 0.5 * support_band_width,
                             .fill = frame.theme.canvas,
                             .outline = frame.theme.point(frame.hue(point)),
                             .outline_width = 2.5});
    const std::string text = fmt::format("u = {}", exact_text(frame.state.view.notation, u));
    frame.labels.push_back(
        {.place = place,
         .words = {{text, {.color = frame.theme.point_text(frame.hue(point)), .size = end_text_size}}},
         .distance = 12.0,
         .first = LabelSide::below});
}

}  // namespace

void draw_support(CanvasFrame& frame) {
    const std::vector<std::size_t> points = points_with_support(frame.state);
    for (std::size_t k = points.size(); k-- > 0;) {
        const render::Color color =
            render::blended(frame.theme.point(frame.hue(points[k])), support_band_share, frame.theme.canvas);
        for (const core::Interval& part : highlight_of_point(*frame.curve, points[k]).parts)
            draw_part(frame, part, {.color = color, .width = support_band_width + static_cast<double>(k) * band_step});
    }
    for (const std::size_t point : points)
        for (const core::Interval& part : highlight_of_point(*frame.curve, point).parts) {
            mark_end(frame, part.lower, core::Side::right, point);
            mark_end(frame, part.upper, core::Side::left, point);
        }
}

void draw_support_strip(PlotFrame& frame) {
    const std::vector<std::size_t> points = points_with_support(frame.state);
    for (std::size_t k = 0; k < points.size(); ++k)
        for (const core::Interval& part : highlight_of_point(frame.curve, points[k]).parts) {
            const auto band = frame.band(part);
            if (!band) continue;
            const render::Color color = frame.theme.point(frame.hue(points[k]));
            frame.pen.fill(corners_of(*band), render::faded(color, strip_opacity));
            const double y = frame.layout.bottom_px + frame.pen.px(axis_width) * (0.5 + static_cast<double>(k));
            frame.pen.segment({band->lower_px.x, y}, {band->upper_px.x, y},
                              {.color = color, .width = axis_width - 1.0});
        }
}

}  // namespace batten::editor
