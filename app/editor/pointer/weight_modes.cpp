#include "app/editor/pointer/weight_modes.h"

#include <cmath>

#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/weight_commands.h"
#include "app/editor/derived/active_conic.h"
#include "app/editor/derived/lifted_stage.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/hover_request.h"
#include "app/editor/scene/insets.h"
#include "core/evaluate/farin_points.h"

namespace batten::editor {

namespace {

constexpr double caught_part = 0.04;    // of a weight
constexpr double shares_of_leg = 12.0;  // to which Ctrl keeps
constexpr double plane_reach = 4.0;     // design pixels within which a lifted point is put into the plane w = 1

std::optional<double> dragged_share(const DraggingFarinPoint& mode, const Gesture& gesture, const core::Curve& curve) {
    const render::Camera& camera = gesture.state.view.camera;
    const glm::dvec2 start = render::screen_from_world(camera, core::farin_point(curve, mode.leg).point);
    const glm::dvec2 place = start + gesture.event.position_px - mode.press_px;
    const auto share =
        core::nearest_farin_share(curve, mode.leg, core::Point(render::world_from_screen(camera, place)));
    if (!share || !gesture.event.modifiers.ctrl) return share;
    return std::clamp(std::round(*share * shares_of_leg), 1.0, shares_of_leg - 1.0) / shares_of_leg;
}

void ask_to_move_farin_point(const DraggingFarinPoint& mode, const Gesture& gesture, Phase phase) {
    const core::Curve* curve = committed_curve(gesture.state);
    if (curve == nullptr || mode.leg >= core::leg_count(*curve)) return;
    const auto share = dragged_share(mode, gesture, *curve);
    if (!share || *share == core::farin_point(*curve, mode.leg).share)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, MoveFarinPoint{.leg = mode.leg, .share = *share});
}

std::optional<LiftedStage> shown_stage(const EditorState& state) {
    const auto box = inset_box(state, Overlay::homogeneous);
    if (!box || committed_curve(state) == nullptr) return std::nullopt;
    return lifted_stage(state, *box);
}

/// The weight of a point that was grabbed beside its place and is moved by the pointer.
std::optional<double> dragged_lifted_weight(const DraggingLiftedWeight& mode, const Gesture& gesture,
                                            const core::Curve& curve) {
    const auto stage = shown_stage(gesture.state);
    if (!stage || mode.index >= curve.control_points().size()) return std::nullopt;
    const core::Point shadow = curve.control_points()[mode.index];
    const glm::dvec2 place =
        stage->screen(shadow, curve.weights()[mode.index]) + gesture.event.position_px - mode.press_px;
    const auto weight = lifted_weight_at(*stage, shadow, place);
    if (!weight) return std::nullopt;
    const glm::dvec2 in_plane = stage->screen(shadow, 1.0);
    const glm::dvec2 on_ray = stage->screen(shadow, *weight);
    if (!is_drag(gesture.state, in_plane, on_ray)) return 1.0;
    return caught_weight(gesture.state, mode.index, *weight);
}

void ask_to_lift(const DraggingLiftedWeight& mode, const Gesture& gesture, Phase phase) {
    const core::Curve* curve = committed_curve(gesture.state);
    if (curve == nullptr) return;
    const auto weight = dragged_lifted_weight(mode, gesture, *curve);
    if (!weight || *weight == curve->weights()[mode.index])
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, SetWeight{.index = mode.index, .weight = *weight});
}

}  // namespace

CanvasMode step(DraggingFarinPoint mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move_farin_point, [](const auto&, const Gesture&) {});
}

CanvasMode step(DraggingLiftedWeight mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_lift, [](const auto&, const Gesture&) {});
}

CanvasMode step(TurningOrbit mode, const Gesture& gesture) {
    if (is_escape(gesture) || gesture.event.action == PointerAction::release) return CanvasIdle{};
    if (!is_move(gesture)) return mode;
    const glm::dvec2 drag = (gesture.event.position_px - mode.last_px) / gesture.state.view.interface_scale;
    if (drag != glm::dvec2(0.0)) gesture.queue.change(TurnOrbit{.drag = drag});
    return TurningOrbit{gesture.event.position_px};
}

CanvasMode begin_inset_gesture(const Gesture& gesture) {
    const auto inset = inset_at(gesture.state, gesture.event.position_px);
    if (!inset || inset->overlay != Overlay::homogeneous) return CanvasIdle{};
    const auto point =
        lifted_point_at(gesture.state, lifted_stage(gesture.state, inset->box), gesture.event.position_px);
    if (!point) return TurningOrbit{gesture.event.position_px};
    if (gesture.state.selection.points != std::vector{*point}) gesture.queue.run(SelectPoints{.points = {*point}});
    if (!can_edit_curve(gesture.state)) return CanvasIdle{};
    request_hover(HoveredLifted{point}, gesture.state, gesture.queue);
    return DraggingLiftedWeight{*point, gesture.event.position_px};
}

bool turn_wheel_over_inset(const Gesture& gesture) {
    const auto inset = inset_at(gesture.state, gesture.event.position_px);
    if (!inset) return false;
    if (inset->overlay == Overlay::homogeneous && gesture.event.wheel != 0.0)
        gesture.queue.change(TurnOrbit{.factor = std::pow(zoom_per_notch, gesture.event.wheel)});
    return true;
}

double caught_weight(const EditorState& state, std::size_t index, double weight) {
    const core::Curve* curve = committed_curve(state);
    if (curve == nullptr || !state.view.overlays.is_shown(Overlay::conic)) return weight;
    const auto conic = active_conic(*curve, state.view.parameter);
    if (!conic || conic->corner != index || !conic->has_own_ends) return weight;
    double caught = weight;
    double least = caught_part;
    for (const double standard : {1.0, conic->arc.circular_weight.value_or(1.0)}) {
        const double wanted = conic->end_scale * standard;
        const double difference = std::abs(std::log(weight / wanted));
        if (!(difference < least)) continue;
        least = difference;
        caught = wanted;
    }
    return caught;
}

}  // namespace batten::editor
