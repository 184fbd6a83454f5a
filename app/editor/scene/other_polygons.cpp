#include "app/editor/scene/other_polygons.h"

#include <fmt/core.h>

#include <array>
#include <string_view>

namespace batten::editor {

namespace {

constexpr std::size_t most_other_points = 200;
constexpr double share_of_color = 0.6;
constexpr double other_name_size = 12.0;

/// The letters of the other curves' points; C is the curve itself.
std::string_view letters_after(PointLetter letter) {
    switch (letter) {
        case PointLetter::P:
            return "QRS";
        case PointLetter::V:
            return "WXY";
        case PointLetter::B:
            return "DEF";
        case PointLetter::d:
            break;
    }
    return "efg";
}

void draw_polygon(CanvasFrame& frame, const core::Curve& curve, char letter) {
    std::vector<glm::dvec2> places = frame.screen(curve.control_points());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const render::Color color = render::blended(frame.theme.point(i), share_of_color, frame.theme.canvas);
        frame.pen.symbol(places[i], {.shape = render::MarkerShape::disc,
                                     .radius = 3.5,
                                     .fill = color,
                                     .outline = frame.theme.canvas,
                                     .outline_width = 1.0});
        frame.marks.push_back(places[i]);
        if (frame.shows(Overlay::labels))
            frame.labels.push_back({.place = places[i],
                                    .words = {{fmt::format("{}_{{{}}}", letter, i),
                                               {.color = frame.theme.dim, .size = other_name_size}}}});
    }
    if (curve.is_periodic()) places.push_back(places.front());
    frame.pen.line(places, {.color = render::blended(frame.theme.polygon, share_of_color, frame.theme.canvas),
                            .width = 1.25,
                            .dash = 6.0,
                            .gap = 5.0});
    frame.lines.push_back(std::move(places));
}

}  // namespace

void draw_other_polygons(CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    const std::string_view letters = letters_after(frame.state.view.notation.points);
    std::size_t drawn = 0;
    std::size_t points = 0;
    for (std::size_t i = 0; i < document.curves.size() && points <= most_other_points; ++i) {
        const core::DocumentCurve& item = document.curves[i];
        if (i == document.active || !item.visible) continue;
        points += item.curve->control_points().size();
        if (points <= most_other_points) draw_polygon(frame, *item.curve, letters[drawn++ % letters.size()]);
    }
}

}  // namespace batten::editor
