/// Places of curves picked with the joint tool.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "app/editor/state/joint_tool.h"
#include "core/base/geometry.h"
#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::editor {

/// A place of a curve that is near the pointer.
struct PickedCurvePlace {
    std::size_t curve = 0;  ///< its index in the document
    double u = 0.0;
    core::CurveEnd end = core::CurveEnd::start;  ///< the nearer one
    core::Point point{};                         ///< the end, or the place at u, whichever the operation is about
    std::shared_ptr<const core::Curve> shape{};  ///< the curve as it was then
};

/// What is dragged out of the first place: the radius of a fillet, the distances of a chamfer or of an offset.
struct JointDrag {
    glm::dvec2 press_px{};
    core::Point from{};              ///< the corner, or the place of the curve
    double distance = 0.0;           ///< from there; of a curve above 0 on its left; 0 until the pointer has moved
    std::optional<double> second{};  ///< the distance along the other side of a corner, where it is typed
    std::optional<PickedCurvePlace> other{};  ///< the end of another curve at the corner; none: a corner of one curve
};

/// The joint tool: the first place where one was clicked, and what the pointer is over. Each operation is done by the
/// click that completes it, or by a drag, and previewed before. Escape gives up the first place, then the tool.
struct PickingJoint {
    std::optional<PickedCurvePlace> first{};
    std::optional<PickedCurvePlace> hovered{};
    std::optional<core::Interval> part{};   ///< of the hovered curve, that trimming would take away
    std::size_t tool_changes = 0;           ///< of the state when it began
    std::optional<JointDrag> drag{};        ///< while the button is held
    std::optional<glm::dvec2> panned_px{};  ///< where the pointer was while the view is being moved
};

}  // namespace batten::editor
