#include "app/editor/scene/marked_joints.h"

#include "app/editor/scene/curve_knots.h"
#include "app/editor/state/kept_joints.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

// Around a control point, too.
constexpr double joint_radius = 10.0;
constexpr double second_joint_radius = 13.0;

void draw_joint_mark(CanvasFrame& frame, core::Point point, core::JointMark mark) {
    const glm::dvec2 place = frame.screen(point);
    Symbol symbol{.radius = joint_radius, .fill = no_color, .outline = frame.theme.curve, .outline_width = 1.5};
    if (mark == core::JointMark::corner) symbol.shape = render::MarkerShape::square;
    frame.pen.symbol(place, symbol);
    if (mark != core::JointMark::curvature) return;
    symbol.radius = second_joint_radius;
    frame.pen.symbol(place, symbol);
}

}  // namespace

void draw_marked_joints(CanvasFrame& frame) {
    const core::DocumentCurve& entry = *frame.state.shown().active_curve();
    if (!frame.shows(Overlay::knots) || entry.joints.is_empty()) return;
    if (!entry.joints.knots.empty())
        for (const SeenKnot& knot : seen_knots(frame))
            if (const auto mark = mark_of_knot(entry, knot.value)) draw_joint_mark(frame, knot.point, *mark);
    for (const core::EndMark& end : entry.joints.ends)
        draw_joint_mark(frame, core::point_at(*entry.curve, core::parameter_of(entry.curve->domain(), end.end)),
                        end.mark);
}

}  // namespace batten::editor
