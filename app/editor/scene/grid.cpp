#include "app/editor/scene/grid.h"

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/grid_step.h"
#include "app/editor/scene/grid_number.h"
#include "app/editor/scene/multiples.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/length.h"

namespace batten::editor {

namespace {

constexpr double number_size = 10.5;
constexpr double number_edge_distance = 7.0;
constexpr double number_gap = 18.0;

core::Point point_on_axis(int axis, double value) {
    return axis == 0 ? core::Point(value, 0.0) : core::Point(0.0, value);
}

double coordinate(core::Point point, int axis) {
    return axis == 0 ? point.x : point.y;
}

void draw_line(CanvasFrame& frame, int axis, double value, render::Color color) {
    const glm::dvec2 size = frame.pen.size_px();
    glm::dvec2 from{};
    from[axis] = frame.screen(point_on_axis(axis, value))[axis];
    glm::dvec2 to = size;
    to[axis] = from[axis];
    frame.pen.segment(from, to, {.color = color});
}

void draw_lines(CanvasFrame& frame, int axis, double step, render::Color color, double left_out_every) {
    const core::Box seen = frame.seen(0.0);
    const Multiples lines = multiples(coordinate(seen.lower, axis), coordinate(seen.upper, axis), step);
    for (int k = 0; k < lines.count; ++k) {
        const bool is_left_out = left_out_every > 0.0 && std::fmod(lines.index(k), left_out_every) == 0.0;
        if (!is_left_out) draw_line(frame, axis, lines.value(k), color);
    }
}

/// The numbers of one axis: 0 for x along the lower edge, 1 for y along the left one.
class NumberRow {
  public:
    NumberRow(CanvasFrame& frame, int axis, const std::optional<render::PixelBox>& covered,
              std::vector<render::PixelBox>& written)
        : frame_(frame), axis_(axis), covered_(covered), written_(written) {}

    void draw() {
        const core::Box seen = frame_.seen(0.0);
        const double major = unit_grid_steps(frame_.state).major;
        const double lower = in_units(units(), coordinate(seen.lower, axis_));
        const double upper = in_units(units(), coordinate(seen.upper, axis_));
        const double room = std::max(size_of(multiples(lower, upper, major))[axis_], frame_.pen.px(number_size));
        const double px_per_unit = frame_.state.view.camera.scale * world_per_length(units());
        const double stride = round_number_from((room + frame_.pen.px(number_gap)) / (major * px_per_unit));
        const Multiples shown = multiples(lower, upper, stride * major);
        for (int k = 0; k < shown.count; ++k) draw_number(shown.value(k), shown.step);
    }

  private:
    const Units& units() const { return frame_.state.shown().units; }

    glm::dvec2 text_px(const std::string& text) const {
        return text_size(text, frame_.pen.px(number_size), render::LabelFont::number);
    }

    glm::dvec2 size_of(const Multiples& lines) const {
        glm::dvec2 most{};
        for (int k = 0; k < lines.count; ++k) {
            const glm::dvec2 size = text_px(grid_number_text(lines.value(k), lines.step, units()));
            most = {std::max(most.x, size.x), std::max(most.y, size.y)};
        }
        return most;
    }

    void draw_number(double value, double step) {
        const std::string text = grid_number_text(value, step, units());
        const glm::dvec2 size = text_px(text);
        const glm::dvec2 picture = frame_.pen.size_px();
        const double edge = frame_.pen.px(number_edge_distance);
        glm::dvec2 lower = frame_.screen(point_on_axis(axis_, value * world_per_length(units()))) - 0.5 * size;
        if (axis_ == 0)
            lower.y = picture.y - edge - 0.75 * size.y;
        else
            lower.x = edge;
        const render::PixelBox box{lower, lower + size};
        const bool is_in_corner = axis_ == 1 && box.upper_px.y > picture.y - edge - size.y;
        const bool is_cut = box.lower_px.x < 0.5 * edge || box.upper_px.x > picture.x || box.lower_px.y < 0.0;
        if (is_in_corner || is_cut || (covered_ && box.overlaps(*covered_))) return;
        written_.push_back(box);
        frame_.pen.text({box.lower_px.x, 0.5 * (box.lower_px.y + box.upper_px.y)}, text,
                        {.color = frame_.theme.dim, .size = number_size, .font = render::LabelFont::number});
    }

    CanvasFrame& frame_;
    int axis_;
    const std::optional<render::PixelBox>& covered_;
    std::vector<render::PixelBox>& written_;
};

}  // namespace

void draw_grid(CanvasFrame& frame) {
    const GridSteps steps = canvas_grid_steps(frame.state);
    const double scale = frame.state.view.camera.scale / frame.state.view.interface_scale;
    const double strength = std::clamp((steps.minor * scale - 6.0) / 40.0, 0.2, 1.0);
    const render::Color faint = render::blended(frame.theme.grid_minor, strength, frame.theme.canvas);
    for (int axis = 0; axis < 2; ++axis)
        draw_lines(frame, axis, steps.minor, faint, std::round(steps.major / steps.minor));
    for (int axis = 0; axis < 2; ++axis) draw_lines(frame, axis, steps.major, frame.theme.grid_major, 0.0);
}

std::vector<render::PixelBox> draw_grid_numbers(CanvasFrame& frame, const std::optional<render::PixelBox>& covered) {
    std::vector<render::PixelBox> written;
    const bool are_on_rulers = frame.shows(Overlay::rulers) && frame.state.view.parts.window;
    if (are_on_rulers) return written;
    for (int axis = 0; axis < 2; ++axis) NumberRow(frame, axis, covered, written).draw();
    return written;
}

}  // namespace batten::editor
