#include "app/editor/scene/directions.h"

#include <array>
#include <glm/geometric.hpp>

#include "app/editor/scene/curve_strokes.h"

namespace batten::editor {

namespace {

constexpr double chevron_spacing = 100.0;
constexpr double chevron_length = 7.0;
constexpr double chevron_half_width = 5.5;

void draw_along(CanvasFrame& frame, const std::vector<glm::dvec2>& run, render::Color color) {
    const double spacing = frame.pen.px(chevron_spacing);
    const render::PixelBox picture{{0.0, 0.0}, frame.pen.size_px()};
    double to_next = 0.5 * spacing;
    for (std::size_t k = 1; k < run.size(); ++k) {
        const double length = glm::distance(run[k - 1], run[k]);
        // A chord may be 64 pictures long.
        const glm::dvec2 direction = (run[k] - run[k - 1]) / length;
        double along = to_next;
        for (; along <= length; along += spacing) {
            const glm::dvec2 tip = run[k - 1] + along * direction;
            if (picture.contains(tip)) draw_chevron(frame, tip, direction, color);
        }
        to_next = along - length;
    }
}

}  // namespace

void draw_chevron(CanvasFrame& frame, glm::dvec2 tip, glm::dvec2 direction, render::Color color) {
    const glm::dvec2 across{-direction.y, direction.x};
    const glm::dvec2 back = tip - frame.pen.px(chevron_length) * direction;
    const double half = frame.pen.px(chevron_half_width);
    frame.pen.line(std::array{back + half * across, tip, back - half * across}, {.color = color, .width = 2.5});
}

void draw_directions(CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const core::DocumentCurve& entry = document.curves[i];
        if (!entry.visible) continue;
        const auto line = seen_polylines(frame, frame.cache.curve(i, entry.curve).strips());
        if (!line) continue;
        const render::Color color =
            i == document.active ? color_of(entry, frame.theme) : color_of_other(entry, frame.theme);
        for (const auto& run : line->runs) draw_along(frame, run, color);
    }
}

}  // namespace batten::editor
