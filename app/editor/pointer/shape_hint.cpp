#include "app/editor/pointer/shape_hint.h"

#include <algorithm>
#include <vector>

namespace batten::editor {
namespace {

std::vector<const char*> step_hints(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::line:
            return {"Click where the line begins, or type x,y",
                    "Click where it ends, or type its length · Shift keeps to an axis"};
        case ShapeKind::rectangle:
            return {"Click on a corner of the rectangle, or type x,y",
                    "Click on the opposite corner, or type width and height with Tab between · Shift makes a square"};
        case ShapeKind::polygon:
            return {"Click on the center of the polygon, or type x,y", "Click on a corner, or type the radius"};
        case ShapeKind::circle:
            return {"Click on the center of the circle, or type x,y", "Click on the circle, or type its radius"};
        case ShapeKind::circle_through_points:
            return {"Click on the first of three places of the circle", "Click on the second place of the circle",
                    "Click on the third place of the circle"};
        case ShapeKind::arc:
            return {"Click on the center of the arc, or type x,y", "Click where it begins, or type radius and angle",
                    "Go around and click where it ends, or type < and the angle"};
        case ShapeKind::arc_through_points:
            return {"Click where the arc begins, or type x,y", "Click where it ends", "Click on a place between"};
        case ShapeKind::ellipse:
            return {"Click on the center of the ellipse, or type x,y",
                    "Click on the end of an axis, or type its length",
                    "Click as far from that axis as the ellipse is to reach, or type how far"};
        case ShapeKind::conic:
            break;
    }
    return {"Click where the conic begins, or type x,y", "Click where it ends", "Click where its end tangents meet",
            "Click how near to that corner it is to pass"};
}

}  // namespace

std::string shape_hint(ShapeKind kind, std::size_t count) {
    const std::vector<const char*> hints = step_hints(kind);
    return hints[std::min(count, hints.size() - 1)];
}

}  // namespace batten::editor
