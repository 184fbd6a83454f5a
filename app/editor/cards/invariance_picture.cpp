#include "app/editor/cards/invariance_picture.h"

#include "app/editor/scene/inset_map.h"
#include "app/editor/state/point_hues.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double maps_height = 190.0;
constexpr double padding = 10.0;
constexpr double half_title_height = 18.0;
constexpr std::size_t dot_stride = 12;  // of the compared parameters
constexpr std::size_t most_mapped_legs = 400;
constexpr std::size_t most_large_points = 40;

// What both halves are drawn from.
struct Subject {
    MappedCurve mapped;
    std::shared_ptr<const MapCheck> check;
    Theme theme;
    double u;
    core::DocumentCurve entry;  // for the colors of its points
};

// One of the two pictures.
struct PictureHalf {
    glm::dvec2 title;
    InsetMap place;
};

PictureHalf half_of(const Pen& pen, bool is_right, const core::Box& world) {
    const double middle = 0.5 * pen.size_px().x;
    const glm::dvec2 lower(is_right ? middle : 0.0, pen.px(half_title_height));
    const glm::dvec2 upper(is_right ? pen.size_px().x : middle, pen.size_px().y);
    const render::PixelBox area{lower + pen.px(padding), upper - pen.px(padding)};
    return {{lower.x + (is_right ? pen.px(padding) : 0.0), 0.5 * pen.px(half_title_height)}, InsetMap(area, world)};
}

std::vector<glm::dvec2> mapped_places(std::span<const core::Point> points, const InsetMap& place,
                                      std::size_t stride = 1) {
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i < points.size(); i += stride) places.push_back(place(points[i]));
    if (!points.empty() && (points.size() - 1) % stride != 0) places.push_back(place(points.back()));
    return places;
}

std::vector<glm::dvec2> mapped_polygon(const core::Curve& curve, const InsetMap& place) {
    const auto points = curve.control_points();
    std::vector<glm::dvec2> places = mapped_places(points, place, points.size() / most_mapped_legs + 1);
    if (curve.is_periodic()) places.push_back(places.front());
    return places;
}

void draw_title(Pen& pen, const Theme& theme, const PictureHalf& half, const char* title) {
    pen.text(half.title, title, {.color = theme.text, .size = 13.0});
}

void draw_before(Pen& pen, const Theme& theme, const std::vector<glm::dvec2>& line) {
    pen.line(line, {.color = theme.dim, .width = 1.25, .dash = 5.0, .gap = 4.0});
}

void draw_point_at_parameter(Pen& pen, const Theme& theme, glm::dvec2 place) {
    pen.symbol(place, {.radius = 5.0, .fill = theme.parameter, .outline = theme.panel, .outline_width = 1.5});
}

void draw_dots(Pen& pen, render::Color color, std::span<const core::Point> points, const InsetMap& place) {
    for (std::size_t k = 0; k < points.size(); k += dot_stride)
        pen.symbol(place(points[k]), {.radius = 2.75, .fill = color, .outline = no_color});
}

// The points of the curve on their way to their images.
void draw_evaluated_first(Pen& pen, const PictureHalf& half, const Subject& subject) {
    const auto& [mapped, check, theme, u, entry] = subject;
    draw_title(pen, theme, half, "evaluate, then map");
    draw_before(pen, theme, mapped_places(check->points, half.place));
    for (std::size_t k = 0; k < check->points.size(); k += dot_stride)
        pen.segment(half.place(check->points[k]), half.place(check->evaluated_first[k]),
                    {.color = render::faded(theme.polygon, 0.6), .width = 1.0});
    draw_dots(pen, theme.curve, check->evaluated_first, half.place);
    const core::Point now = core::point_at(mapped.curve, u);
    const glm::dvec2 before = half.place(now);
    const glm::dvec2 after = half.place(core::mapped(mapped.map, now));
    pen.segment(before, after, {.color = theme.parameter, .width = 1.5});
    pen.symbol(before, {.radius = 4.0, .fill = theme.panel, .outline = theme.parameter, .outline_width = 1.5});
    draw_point_at_parameter(pen, theme, after);
}

// The polygon, its image, and the curve of that with points at the same parameters; where the weights are mapped too
// also the points that the old weights would give.
void draw_mapped_first(Pen& pen, const PictureHalf& half, const Subject& subject) {
    const auto& [mapped, check, theme, u, entry] = subject;
    draw_title(pen, theme, half, "map, then evaluate");
    draw_before(pen, theme, mapped_polygon(mapped.curve, half.place));
    pen.line(mapped_polygon(*check->image, half.place), {.color = theme.polygon, .width = 1.25});
    pen.line(mapped_places(check->mapped_first, half.place), {.color = theme.curve, .width = 1.75});
    draw_dots(pen, theme.error, check->weights_kept, half.place);
    draw_dots(pen, theme.curve, check->mapped_first, half.place);
    const auto points = check->image->control_points();
    if (points.size() <= most_large_points)
        for (std::size_t i = 0; i < points.size(); ++i)
            pen.symbol(half.place(points[i]),
                       {.radius = 4.0, .fill = theme.point(point_hue(entry, i)), .outline = no_color});
    draw_point_at_parameter(pen, theme, half.place(core::point_at(*check->image, u)));
}

}  // namespace

CardPicture invariance_picture(const EditorState& state, const MappedCurve& mapped,
                               std::shared_ptr<const MapCheck> check) {
    const Subject subject{mapped, std::move(check), shown_theme(state.view), state.parameter(),
                          *state.shown().active_curve()};
    const auto draw = [subject](glm::dvec2 size_px, double scale) {
        CardDrawing drawing;
        Pen pen(drawing.list, size_px, scale);
        pen.segment({0.5 * size_px.x, 0.0}, {0.5 * size_px.x, size_px.y}, {.color = subject.theme.line});
        draw_evaluated_first(pen, half_of(pen, false, subject.check->box), subject);
        draw_mapped_first(pen, half_of(pen, true, subject.check->box), subject);
        return drawing;
    };
    return {.height = maps_height, .draw = draw};
}

}  // namespace batten::editor
