#include "app/editor/scene/end_marks.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/scene/arrow.h"
#include "core/evaluate/end_derivatives.h"

namespace batten::editor {

namespace {

constexpr double longest_end_vector = 180.0;
constexpr double end_name_size = 13.0;

void draw_named(CanvasFrame& frame, glm::dvec2 from, core::Vector v, const Stroke& stroke, std::string name) {
    const glm::dvec2 whole = vector_in_picture(frame, v);
    const double length = glm::length(whole);
    if (!(length > 0.0) || !std::isfinite(length)) return;
    const glm::dvec2 tip = from + std::min(1.0, frame.pen.px(longest_end_vector) / length) * whole;
    draw_arrow(frame, from, tip, stroke);
    frame.labels.push_back(
        {.place = tip, .words = {{std::move(name), {.color = stroke.color, .size = end_name_size}}}});
}

}  // namespace

void draw_end_marks(CanvasFrame& frame) {
    for (const core::CurveEnd end : {core::CurveEnd::start, core::CurveEnd::end}) {
        const auto at = core::end_derivatives(*frame.curve, end);
        if (!at) continue;
        const glm::dvec2 place = frame.screen(at->end_point.point);
        const std::string u = exact_text(frame.state.view.notation, at->end_knot.value);
        draw_named(frame, place, velocity_scale(*frame.curve) * at->first, {.color = frame.theme.comb, .width = 2.5},
                   fmt::format("C′({})", u));
        if (!at->second) continue;
        draw_named(frame, place, acceleration_scale(*frame.curve) * at->second->value,
                   {.color = frame.theme.comb, .width = 1.5, .dash = 5.0, .gap = 3.0}, fmt::format("C″({})", u));
    }
}

}  // namespace batten::editor
