#include "app/editor/scene/joint_tool_marks.h"

#include "app/editor/pointer/joint_reading.h"
#include "app/editor/scene/curve_strokes.h"
#include "app/editor/scene/reading_box.h"
#include "core/refine/split.h"

namespace batten::editor {

namespace {

constexpr double pick_radius = 7.0;
constexpr double most_reading_share = 0.5;  // of the picture's height

void draw_pick(CanvasFrame& frame, const PickedCurvePlace& place, bool is_taken) {
    frame.pen.symbol(frame.screen(place.point), {.radius = pick_radius,
                                                 .fill = is_taken ? frame.theme.accent : frame.theme.canvas,
                                                 .outline = is_taken ? frame.theme.canvas : frame.theme.accent,
                                                 .outline_width = 2.5});
}

void draw_part(CanvasFrame& frame, const core::Curve& curve, core::Interval range) {
    const auto part = core::sub_curve(curve, range.lower, range.upper);
    if (!part) return;
    KeptCurve kept(std::make_shared<const core::Curve>(*part));
    const Stroke stroke{.color = frame.theme.error, .width = 5.0};
    draw_line(frame, seen_curve(frame, kept, stroke), stroke);
}

/// What jumps; in a low picture only the first row of each meeting, so that the ends can be seen beside them.
std::vector<ReadingRow> rows_of_joint(const CanvasFrame& frame, const PickingJoint& mode) {
    const std::vector<std::string> reading = joint_reading(frame.state, mode);
    const double most_px = most_reading_share * frame.pen.size_px().y;
    const std::size_t step = reading_height_px(frame.pen, reading.size()) <= most_px ? 1 : rows_of_meeting;
    std::vector<ReadingRow> rows;
    for (std::size_t k = 0; k < reading.size(); k += step) rows.push_back({reading[k], frame.theme.text});
    return rows;
}

}  // namespace

void draw_picked_joint(CanvasFrame& frame, const PickingJoint& mode) {
    const core::Document& document = frame.state.history.present();
    if (mode.hovered && mode.part && mode.hovered->curve < document.curves.size())
        draw_part(frame, *document.curves[mode.hovered->curve].curve, *mode.part);
    if (mode.first) draw_pick(frame, *mode.first, true);
    if (!mode.hovered || mode.drag) return;
    draw_pick(frame, *mode.hovered, false);
    const std::vector<ReadingRow> rows = rows_of_joint(frame, mode);
    if (!rows.empty()) draw_reading(frame, frame.screen(mode.hovered->point), rows);
}

}  // namespace batten::editor
