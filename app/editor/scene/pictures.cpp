#include "app/editor/scene/pictures.h"

#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double problem_size = 12.5;
constexpr double gauge_radius = 5.0;
constexpr double gauge_line = 1.5;

core::PicturePlace corner(double x, double y) {
    return {x, y};
}

void draw_frame_of_missing(CanvasFrame& frame, const core::Picture& picture, const std::string& problem) {
    const double w = picture.width;
    const double h = picture.height;
    std::vector<glm::dvec2> corners;
    for (const core::PicturePlace place : {corner(0, 0), corner(w, 0), corner(w, h), corner(0, h)})
        corners.push_back(frame.screen(core::plane_from_picture(picture, place)));
    frame.pen.outline(corners, {.color = frame.theme.dim, .width = 1.0, .dash = 6.0, .gap = 4.0});
    const glm::dvec2 middle = 0.5 * (corners[0] + corners[2]);
    const glm::dvec2 size = frame.pen.size_px();
    if (middle.x < 0.0 || middle.y < 0.0 || middle.x > size.x || middle.y > size.y) return;
    frame.pen.text(middle, problem, {.color = frame.theme.dim, .size = problem_size, .anchor = render::Anchor::center});
}

}  // namespace

void draw_pictures(CanvasFrame& frame, render::DrawList& list) {
    for (const core::Picture& picture : frame.state.shown().pictures) {
        if (!picture.visible) continue;
        const LoadedPicture& loaded = frame.state.pictures.of(picture.path);
        if (loaded.image == nullptr) {
            draw_frame_of_missing(frame, picture, loaded.problem);
            continue;
        }
        const auto place = [&](double x, double y) {
            return frame.screen(core::plane_from_picture(picture, corner(x, y)));
        };
        list.add(render::ImageQuad{loaded.image, place(0, 0), place(picture.width, 0), place(0, picture.height),
                                   picture.opacity});
    }
}

void draw_picture_gauge(CanvasFrame& frame) {
    if (!frame.state.gauge) return;
    std::vector<glm::dvec2> places;
    for (const core::Point point : frame.state.gauge->points) places.push_back(frame.screen(point));
    if (places.size() == 2) frame.pen.line(places, {.color = frame.theme.accent, .width = gauge_line});
    for (const glm::dvec2 place : places)
        frame.pen.symbol(place, {.radius = gauge_radius,
                                 .fill = frame.theme.canvas,
                                 .outline = frame.theme.accent,
                                 .outline_width = gauge_line});
}

}  // namespace batten::editor
