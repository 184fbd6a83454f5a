#include "app/editor/scene/finding_marks.h"

#include "app/editor/scene/text_size.h"

namespace batten::editor {

namespace {

constexpr double finding_radius = 5.0;
constexpr double outline_width = 2.0;
constexpr double mark_number_size = 11.0;
constexpr glm::dvec2 number_offset{8.0, -10.0};
// More would hide one another and the curve.
constexpr std::size_t most_numbers = 60;

// While a gesture shows another shape, the places are those of the old one.
std::span<const Finding> marked(const CanvasFrame& frame) {
    if (!frame.state.findings || frame.state.preview) return {};
    return frame.state.findings->rows;
}

render::PixelBox number_box(const CanvasFrame& frame, glm::dvec2 place, const std::string& number) {
    const glm::dvec2 left = place + frame.pen.px(1.0) * number_offset;
    const glm::dvec2 size = text_size(number, frame.pen.px(mark_number_size), render::LabelFont::number);
    return {left - glm::dvec2(0.0, 0.5 * size.y), left + glm::dvec2(size.x, 0.5 * size.y)};
}

}  // namespace

std::vector<render::PixelBox> finding_boxes(const CanvasFrame& frame) {
    const std::span<const Finding> rows = marked(frame);
    std::vector<render::PixelBox> boxes;
    if (rows.size() > most_numbers) return boxes;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i].point) continue;
        const glm::dvec2 place = frame.screen(*rows[i].point);
        const glm::dvec2 reach(frame.pen.px(finding_radius + outline_width));
        boxes.push_back({place - reach, place + reach});
        boxes.push_back(number_box(frame, place, std::to_string(i + 1)));
    }
    return boxes;
}

void draw_finding_marks(CanvasFrame& frame) {
    const std::span<const Finding> rows = marked(frame);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i].point) continue;
        const glm::dvec2 place = frame.screen(*rows[i].point);
        frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                                 .radius = finding_radius,
                                 .fill = frame.theme.canvas,
                                 .outline = frame.theme.accent,
                                 .outline_width = outline_width});
        if (rows.size() > most_numbers) continue;
        frame.pen.text(place + frame.pen.px(1.0) * number_offset, std::to_string(i + 1),
                       {.color = frame.theme.accent, .size = mark_number_size, .font = render::LabelFont::number});
    }
}

}  // namespace batten::editor
