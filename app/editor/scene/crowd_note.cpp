#include "app/editor/scene/crowd_note.h"

#include "app/editor/scene/legend.h"
#include "app/editor/scene/text_size.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double note_side = 14.0;
constexpr double note_bottom = 43.0;  // in the middle of the row of the legend
constexpr double note_size = 12.5;
constexpr double ground_opacity = 0.94;  // over what is drawn there

std::string points_text(const ShownPoints& points) {
    return core::sentence("Showing {shown} of {count} points",
                          {{"shown", points.crowd.shown.size()}, {"count", points.seen}});
}

/// About points alone where there is no room for more.
std::string note_text(const CanvasMarks& marks, double room) {
    const std::size_t knots = knot_count(marks.knots);
    const bool has_all_points = !marks.points.crowd.is_thinned;
    if (has_all_points && !marks.knots.is_thinned) return "";
    if (!marks.knots.is_thinned) return points_text(marks.points);
    if (has_all_points)
        return core::sentence("Showing {shown} of {count} knots", {{"shown", knots}, {"count", marks.knots.seen}});
    const std::string both = core::sentence("Showing {shown} of {count} points and {knots} of {knot_count} knots",
                                            {{"shown", marks.points.crowd.shown.size()},
                                             {"count", marks.points.seen},
                                             {"knots", knots},
                                             {"knot_count", marks.knots.seen}});
    return text_size(both, note_size).x <= room ? both : points_text(marks.points);
}

}  // namespace

std::optional<render::PixelBox> draw_crowd_note(CanvasFrame& frame, const CanvasMarks& marks) {
    const std::string note = note_text(marks, frame.pen.size_px().x / frame.pen.px(1.0) - 2.0 * note_side);
    if (note.empty()) return std::nullopt;
    const bool is_left = has_legend(frame.state) && frame.state.view.legend_corner == Corner::lower_right;
    const glm::dvec2 size = text_size(note, frame.pen.px(note_size));
    const double left = is_left ? frame.pen.px(note_side) : frame.pen.size_px().x - frame.pen.px(note_side) - size.x;
    const double y = frame.pen.size_px().y - frame.pen.px(note_bottom);
    const render::PixelBox box{{left, y - 0.5 * size.y}, {left + size.x, y + 0.5 * size.y}};
    const glm::dvec2 around(frame.pen.px(4.0));
    frame.pen.fill(corners_of({box.lower_px - around, box.upper_px + around}),
                   render::faded(frame.theme.canvas, ground_opacity));
    const double x = is_left ? box.lower_px.x : box.upper_px.x;
    frame.pen.text({x, y}, note,
                   {.color = frame.theme.dim,
                    .size = note_size,
                    .anchor = is_left ? render::Anchor::left : render::Anchor::right});
    return box;
}

}  // namespace batten::editor
