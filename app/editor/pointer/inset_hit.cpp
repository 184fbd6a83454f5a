#include "app/editor/pointer/inset_hit.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/editor/derived/lifted_stage.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/scene/hodograph_inset.h"
#include "app/editor/scene/inset_map.h"
#include "core/curve/control_box.h"
#include "core/evaluate/hodograph.h"
#include "core/measure/nearest.h"

namespace batten::editor {

namespace {

// How near the pointer must be, in design pixels.
constexpr double point_reach = 7.0;
constexpr double curve_reach = 6.0;

/// A hodograph as its inset shows it.
class ShownHodograph {
  public:
    ShownHodograph(const EditorState& state, const render::PixelBox& box, core::Curve curve)
        : curve_(std::move(curve)), scale_(state.view.interface_scale), map_(hodograph_area(box, scale_), seen()) {}

    std::optional<std::size_t> point_at(glm::dvec2 position_px) const {
        Nearest<std::size_t> nearest(point_reach * scale_);
        for (std::size_t i = 0; i < curve_.control_points().size(); ++i)
            nearest.offer(i, glm::distance(map_(curve_.control_points()[i]), position_px));
        return nearest.found();
    }

    std::optional<double> parameter_at(glm::dvec2 position_px) const {
        const core::CurveSample nearest = core::nearest_point(curve_, map_.shown_at(position_px));
        const double distance = glm::distance(map_(nearest.point), position_px);
        return distance <= curve_reach * scale_ ? std::optional(nearest.u) : std::nullopt;
    }

    const core::Curve& curve() const { return curve_; }

  private:
    core::Box seen() const {
        core::Box box = core::control_box(curve_);
        box.include({0.0, 0.0});
        return box;
    }

    core::Curve curve_;
    double scale_;
    InsetMap map_;
};

Hover hit_hodograph(const EditorState& state, const render::PixelBox& box, std::size_t order, glm::dvec2 position_px) {
    HoveredHodograph hit{.order = order, .index = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr || curve->control_points().size() > most_hodograph_points) return hit;
    auto made = order == 1 ? core::hodograph(*curve) : core::second_hodograph(*curve);
    if (!made || made->control_points().size() > most_hodograph_points) return hit;
    const ShownHodograph shown(state, box, *std::move(made));
    if (has_differences(shown.curve(), *curve, order)) hit.index = shown.point_at(position_px);
    if (!hit.index) hit.u = shown.parameter_at(position_px);
    return hit;
}

double distance_to_chord(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b, double& share) {
    const glm::dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    share = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + share * along);
}

/// Where the lifted curve or its shadow passes the pointer.
std::optional<double> lifted_parameter_at(const core::Curve& curve, const LiftedStage& stage, glm::dvec2 position_px,
                                          double reach_px) {
    std::optional<double> found;
    const auto offer = [&](const core::LiftedSample& a, const core::LiftedSample& b, glm::dvec2 from, glm::dvec2 to) {
        double share = 0.0;
        const double distance = distance_to_chord(position_px, from, to, share);
        if (!(distance < reach_px)) return;
        reach_px = distance;
        found = a.u + share * (b.u - a.u);
    };
    for (const auto& run : core::lifted_samples(curve, stage.view, {}))
        for (std::size_t k = 0; k + 1 < run.size(); ++k) {
            const core::LiftedSample& a = run[k];
            const core::LiftedSample& b = run[k + 1];
            offer(a, b, stage.screen(a.point, a.weight), stage.screen(b.point, b.weight));
            offer(a, b, stage.screen(a.point, 1.0), stage.screen(b.point, 1.0));
        }
    return found;
}

Hover hit_lifted(const EditorState& state, const render::PixelBox& box, glm::dvec2 position_px) {
    const LiftedStage stage = lifted_stage(state, box);
    if (const auto index = lifted_point_at(state, stage, position_px)) return HoveredLifted{index};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return HoveredLifted{};
    return HoveredLifted{std::nullopt,
                         lifted_parameter_at(*curve, stage, position_px, curve_reach * state.view.interface_scale)};
}

}  // namespace

Hover hit_inset(const EditorState& state, const InsetPlace& inset, glm::dvec2 position_px) {
    if (inset.overlay == Overlay::homogeneous) return hit_lifted(state, inset.box, position_px);
    const std::size_t order = inset.overlay == Overlay::hodograph ? 1 : 2;
    return hit_hodograph(state, inset.box, order, position_px);
}

}  // namespace batten::editor
