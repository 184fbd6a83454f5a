#include "app/editor/scene/directions.h"

#include <algorithm>
#include <array>
#include <cmath>
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
    const glm::dvec2 middle = 0.5 * frame.pen.size_px();
    const double reach = glm::length(middle);
    double to_next = 0.5 * spacing;
    for (std::size_t k = 1; k < run.size(); ++k) {
        const double length = glm::distance(run[k - 1], run[k]);
        if (!(length > 0.0)) continue;
        const glm::dvec2 direction = (run[k] - run[k - 1]) / length;
        // A chord may be far longer than the picture: only what is nearer to the picture's middle than its corners
        // counts.
        const double nearest = glm::dot(middle - run[k - 1], direction);
        double along = to_next + spacing * std::max(0.0, std::ceil((nearest - reach - to_next) / spacing));
        for (; along <= std::min(length, nearest + reach); along += spacing) {
            const glm::dvec2 tip = run[k - 1] + along * direction;
            if (picture.contains(tip)) draw_chevron(frame, tip, direction, color);
        }
        to_next = spacing - std::fmod(length - to_next, spacing);
        if (to_next > spacing) to_next -= spacing;
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
