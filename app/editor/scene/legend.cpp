#include "app/editor/scene/legend.h"

#include <algorithm>
#include <string>

#include "app/editor/scene/panel_box.h"
#include "app/editor/scene/text_size.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double left = 14.0;
constexpr double bottom = 28.0;  // leaves room for the numbers of the grid
constexpr double legend_height = 30.0;
constexpr double legend_padding = 13.0;
constexpr double text = 12.5;
constexpr double disc_space = 22.0;  // from the end of a text to the next disc
constexpr double disc_to_text = 10.0;
const char* const title = "de Boor";

/// What stands beside the disc of the color of level r: colors repeat after three levels.
std::string entry_text(std::size_t r, std::size_t degree, std::size_t color_count) {
    const std::size_t second = r + color_count;
    if (second > degree) return core::sentence("level {level}", {{"level", r}});
    const char* pattern = second + color_count <= degree ? "levels {level}, {next}, …" : "levels {level}, {next}";
    return core::sentence(pattern, {{"level", r}, {"next", second}});
}

std::vector<std::string> entries(const CanvasFrame& frame) {
    const auto degree = static_cast<std::size_t>(frame.curve->degree());
    const std::size_t color_count = frame.theme.levels.size();
    std::vector<std::string> texts;
    for (std::size_t r = 1; r <= std::min(degree, color_count); ++r)
        texts.push_back(entry_text(r, degree, color_count));
    return texts;
}

double width_of(const std::string& label) {
    return text_size(label, text).x;
}

}  // namespace

render::PixelBox legend_box(const CanvasFrame& frame) {
    double width = legend_padding + width_of(title) + legend_padding;
    for (const std::string& entry : entries(frame)) width += disc_space + disc_to_text + width_of(entry);
    const glm::dvec2 lower{frame.pen.px(left), frame.pen.size_px().y - frame.pen.px(bottom + legend_height)};
    return {lower, lower + glm::dvec2(frame.pen.px(width), frame.pen.px(legend_height))};
}

void draw_legend(CanvasFrame& frame) {
    const render::PixelBox box = legend_box(frame);
    Pen& pen = frame.pen;
    draw_panel_box(pen, frame.theme, box);
    const double y = 0.5 * (box.lower_px.y + box.upper_px.y);
    double x = box.lower_px.x + pen.px(legend_padding);
    pen.text({x, y}, title, {.color = frame.theme.dim, .size = text});
    x += pen.px(width_of(title));
    std::size_t r = 0;
    for (const std::string& entry : entries(frame)) {
        ++r;
        x += pen.px(disc_space);
        pen.symbol({x, y}, {.radius = 5.0, .fill = frame.theme.level(r), .outline = no_color});
        x += pen.px(disc_to_text);
        pen.text({x, y}, entry, {.color = frame.theme.text, .size = text});
        x += pen.px(width_of(entry));
    }
}

}  // namespace batten::editor
