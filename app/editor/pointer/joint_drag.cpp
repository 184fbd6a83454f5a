#include "app/editor/pointer/joint_drag.h"

#include <algorithm>
#include <cmath>

#include "app/editor/commands/corner_commands.h"
#include "app/editor/commands/shape_commands.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/pointer/place_text.h"
#include "app/editor/pointer/point_drag.h"
#include "app/editor/pointer/typed_place.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/closing.h"
#include "core/measure/continuity.h"

namespace batten::editor {
namespace {

constexpr double corner_reach = 12.0;  ///< design pixels

/// Of the size of a curve, how near its end another one must end to make a corner with it.
constexpr double meeting_share = 1e-6;

const core::Curve& curve_picked(const EditorState& state, const PickedCurvePlace& place) {
    return *state.history.present().curves[place.curve].curve;
}

/// The inner corner of the curve that is nearest to the pointer, within reach.
std::optional<double> inner_corner(const Gesture& gesture, const PickedCurvePlace& place, double reach) {
    const core::Curve& curve = curve_picked(gesture.state, place);
    const core::Interval domain = curve.domain();
    const double speed = core::length(core::derivatives_at(curve, place.u, 1)[1]);
    const double away = speed > 0.0 ? std::min(2.0 * reach / speed, domain.length()) : domain.length();
    Nearest<double> nearest(reach);
    for (const core::JointContinuity& joint : core::joint_continuity_within(curve, {place.u - away, place.u + away}))
        if (joint.geometric < 1)
            nearest.offer(joint.u, core::distance(core::point_at(curve, joint.u), world_at_pointer(gesture)));
    return nearest.found();
}

/// The end of another visible curve where this one ends.
std::optional<PickedCurvePlace> end_beside(const EditorState& state, const PickedCurvePlace& place, core::Point tip) {
    const auto& curves = state.history.present().curves;
    const double reach = meeting_share * state.derived.of(curve_picked(state, place))->size;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (i == place.curve || !curves[i].visible || curves[i].curve->is_periodic()) continue;
        for (const core::CurveEnd end : {core::CurveEnd::start, core::CurveEnd::end}) {
            const double u = core::parameter_of(curves[i].curve->domain(), end);
            const core::Point point = core::point_at(*curves[i].curve, u);
            if (core::distance(point, tip) <= reach) return PickedCurvePlace{i, u, end, point, curves[i].curve};
        }
    }
    return std::nullopt;
}

std::optional<JointDrag> begin_corner_drag(const Gesture& gesture, PickedCurvePlace& place) {
    const core::Curve& curve = curve_picked(gesture.state, place);
    const double reach = pixels(gesture.state, corner_reach) / gesture.state.view.camera.scale;
    JointDrag drag{.press_px = gesture.event.position_px};
    if (const auto corner = inner_corner(gesture, place, reach)) {
        place.u = *corner;
    } else {
        const double u = core::parameter_of(curve.domain(), place.end);
        const core::Point tip = core::point_at(curve, u);
        if (curve.is_periodic() || core::distance(tip, world_at_pointer(gesture)) > reach) return std::nullopt;
        drag.other = end_beside(gesture.state, place, tip);
        // Of a curve whose ends meet in a corner this is one of its corners.
        if (!drag.other && core::continuity_of_ends(curve).geometric != 0) return std::nullopt;
        place.u = u;
    }
    drag.from = place.point = core::point_at(curve, place.u);
    return drag;
}

/// The distance of a place from the curve, negative on its right.
double signed_distance(const EditorState& state, const PickedCurvePlace& curve_place, core::Point place) {
    const auto& curve = state.history.present().curves[curve_place.curve].curve;
    const core::CurveSample foot = state.derived.near_parts(curve)->nearest(place).value();
    const core::Side side = foot.u < curve->domain().upper ? core::Side::right : core::Side::left;
    const core::Vector way = place - foot.point;
    const auto tangent = core::tangent_at(*curve, foot.u, side);
    const bool is_right = tangent && core::cross(*tangent, way) < 0.0;
    return is_right ? -core::length(way) : core::length(way);
}

TypedFor size_of_drag(const EditorState& state) {
    switch (state.view.joint.operation) {
        case JointOperation::fillet:
            return TypedFor::radius;
        case JointOperation::chamfer:
            return TypedFor::sides;
        default:
            return TypedFor::distance;
    }
}

}  // namespace

std::string size_words(const EditorState& state, const JointDrag& drag) {
    const core::Place size("size", length_text(state, std::abs(drag.distance)));
    if (size_of_drag(state) == TypedFor::radius) return core::sentence("Radius {size}", {size});
    if (drag.second)
        return core::sentence("Distances {size} and {second}",
                              {size, {"second", length_text(state, std::abs(*drag.second))}});
    return core::sentence("Distance {size}", {size});
}

std::optional<JointDrag> begin_joint_drag(const Gesture& gesture, PickedCurvePlace& place) {
    switch (gesture.state.view.joint.operation) {
        case JointOperation::fillet:
        case JointOperation::chamfer:
            return begin_corner_drag(gesture, place);
        case JointOperation::offset:
            return JointDrag{.press_px = gesture.event.position_px, .from = place.point};
        default:
            return std::nullopt;
    }
}

JointDrag dragged_joint(const Gesture& gesture, const PickedCurvePlace& place, JointDrag drag) {
    const core::Point target = pointed_at(gesture, drag.from);
    const TypedPlace& typed = typed_for(gesture);
    const Units& units = gesture.state.shown().units;
    const bool has_sides = size_of_drag(gesture.state) == TypedFor::sides;
    const std::optional<double> length = has_sides ? typed_length_in(typed, 0, units) : typed_length(typed, units);
    drag.second = has_sides ? typed_length_in(typed, 1, units) : std::nullopt;
    const bool is_offset = gesture.state.view.joint.operation == JointOperation::offset;
    drag.distance = is_offset ? signed_distance(gesture.state, place, target) : core::distance(drag.from, target);
    if (length) drag.distance = std::copysign(*length, drag.distance);
    if (gesture.place != nullptr && *gesture.place) {
        (*gesture.place)->typed_for = size_of_drag(gesture.state);
        (*gesture.place)->reading = size_words(gesture.state, drag);
    }
    return drag;
}

Command command_of_drag(const EditorState& state, const PickedCurvePlace& place, const JointDrag& drag) {
    const JointTool& tool = state.view.joint;
    if (tool.operation == JointOperation::offset)
        return Offset{.distance = drag.distance,
                      .tolerance = core::absolute_tolerance(curve_picked(state, place), suggest::offset_tolerance),
                      .side = tool.offsets_both_sides ? core::OffsetSide::both : core::OffsetSide::left,
                      .corners = tool.corners,
                      .caps = tool.caps};
    std::optional<std::string> other;
    std::optional<double> other_u;
    if (drag.other) {
        other = state.history.present().curves[drag.other->curve].name;
        other_u = drag.other->u;
    }
    if (tool.operation == JointOperation::fillet)
        return Fillet{.radius = drag.distance, .u = place.u, .other = other, .other_u = other_u};
    return Chamfer{.distance = drag.distance,
                   .other_distance = drag.second.value_or(drag.distance),
                   .u = place.u,
                   .other = other,
                   .other_u = other_u};
}

}  // namespace batten::editor
