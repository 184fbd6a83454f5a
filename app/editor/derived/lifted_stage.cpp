#include "app/editor/derived/lifted_stage.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/editor/pointer/point_drag.h"

namespace batten::editor {

namespace {

constexpr double least_plane = 0.15;
constexpr double plane_margin = 1.2;
constexpr double lifted_reach = 10.0;  ///< design pixels
constexpr std::size_t most_lifted_points = 100;
constexpr double stage_title_room = 46.0;  ///< design pixels
constexpr double stage_margin = 22.0;

/// Places that are to be seen: the origin, the corners of the plane and the control points.
std::vector<glm::dvec3> seen_places(const core::Curve& curve, const LiftedStage& stage) {
    std::vector<glm::dvec3> places{{0.0, 0.0, 0.0}};
    for (const glm::dvec3& corner : stage.plane) places.push_back(corner);
    for (std::size_t i = 0; i < curve.control_points().size(); i += lifted_stride(curve))
        places.push_back(stage.view.place(curve.control_points()[i], curve.weights()[i]));
    return places;
}

std::array<glm::dvec3, 4> plane_about(const core::LiftView& view, const core::Box& box) {
    const core::Vector half = (box.upper - view.apex) / view.unit;
    const double x = plane_margin * std::max(half.x, least_plane);
    const double y = plane_margin * std::max(half.y, least_plane);
    return {glm::dvec3{-x, -y, 1.0}, {x, -y, 1.0}, {x, y, 1.0}, {-x, y, 1.0}};
}

/// The camera moved and scaled so that all of it is in the middle of `box`.
render::OrbitCamera fitted(render::OrbitCamera camera, const std::vector<glm::dvec3>& places,
                           const render::PixelBox& box) {
    render::PixelBox shown = render::PixelBox::between(render::screen_from_space(camera, places.front()),
                                                       render::screen_from_space(camera, places.front()));
    for (const glm::dvec3& place : places) {
        const glm::dvec2 at = render::screen_from_space(camera, place);
        shown = {glm::min(shown.lower_px, at), glm::max(shown.upper_px, at)};
    }
    const glm::dvec2 extent = glm::max(shown.upper_px - shown.lower_px, glm::dvec2(1e-6));
    const glm::dvec2 shares = (box.upper_px - box.lower_px) / extent;
    camera.scale *= std::min(shares.x, shares.y);
    camera.center_px = 0.5 * (box.lower_px + box.upper_px) - camera.scale * 0.5 * (shown.lower_px + shown.upper_px);
    return camera;
}

}  // namespace

LiftedStage lifted_stage(const EditorState& state, const render::PixelBox& box) {
    const auto* lifted = std::get_if<HoveredLifted>(&state.hover);
    const bool may_be_lifting = lifted != nullptr && lifted->index;
    const core::Document& document = may_be_lifting ? state.history.present() : state.shown();
    const core::Curve& curve = *document.active_curve()->curve;
    const auto facts = state.derived.of(curve);
    const auto weights = state.derived.weights_of(curve);
    const Orbit& orbit = state.view.orbit;
    LiftedStage stage{.view = core::lift_view(facts->control_box, {weights->lightest, weights->heaviest}),
                      .camera = {.yaw = orbit.yaw, .pitch = orbit.pitch},
                      .plane = {}};
    stage.plane = plane_about(stage.view, facts->control_box);
    const double px = state.view.interface_scale;
    const render::PixelBox room{box.lower_px + px * glm::dvec2(stage_margin, stage_title_room),
                                box.upper_px - px * stage_margin};
    stage.camera = fitted(stage.camera, seen_places(curve, stage), room);
    // About the middle of the box.
    const glm::dvec2 middle = 0.5 * (room.lower_px + room.upper_px);
    stage.camera.scale *= orbit.zoom;
    stage.camera.center_px = middle + orbit.zoom * (stage.camera.center_px - middle);
    return stage;
}

std::size_t lifted_stride(const core::Curve& curve) {
    return (curve.control_points().size() - 1) / most_lifted_points + 1;
}

std::optional<std::size_t> lifted_point_at(const EditorState& state, const LiftedStage& stage, glm::dvec2 position_px) {
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return std::nullopt;
    std::optional<std::size_t> found;
    double least = lifted_reach * state.view.interface_scale;
    for (std::size_t i = 0; i < curve->control_points().size(); i += lifted_stride(*curve)) {
        const glm::dvec2 place = stage.screen(curve->control_points()[i], curve->weights()[i]);
        const double distance = glm::distance(place, position_px);
        if (!(distance < least)) continue;
        least = distance;
        found = i;
    }
    return found;
}

std::optional<double> lifted_weight_at(const LiftedStage& stage, core::Point shadow, glm::dvec2 position_px) {
    const auto height = render::nearest_along(stage.camera, {0.0, 0.0, 0.0}, stage.view.place(shadow), position_px);
    if (!height) return std::nullopt;
    return dragged_weights.clamp(stage.view.weight_at(std::max(*height, 0.0)));
}

}  // namespace batten::editor
