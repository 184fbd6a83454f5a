/// How the lifted curve stands in its box on the screen, and what a pointer does there.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "app/editor/state/state.h"
#include "core/evaluate/lifted.h"
#include "render/orbit_camera.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// Space and the camera that looks at it.
struct LiftedStage {
    core::LiftView view;
    render::OrbitCamera camera;
    std::array<glm::dvec3, 4> plane;  ///< the corners of what is drawn of the plane w = 1

    /// Where the point with that shadow and weight (> 0) is on the screen.
    glm::dvec2 screen(core::Point shadow, double weight) const {
        return render::screen_from_space(camera, view.place(shadow, weight));
    }
};

/// The stage for the active curve, which must be there, in the inset `box`, as large as it fits there: that of the
/// committed curve while the pointer holds a lifted point, so that it stands still under it, else of the shown one.
LiftedStage lifted_stage(const EditorState& state, const render::PixelBox& box);

/// Every so manieth control point of `curve` is shown in space: 1 up to 100 of them.
std::size_t lifted_stride(const core::Curve& curve);

/// The control point that is shown lifted within 10 design pixels of `position_px`, the nearest in front; none where
/// there is none.
std::optional<std::size_t> lifted_point_at(const EditorState& state, const LiftedStage& stage, glm::dvec2 position_px);

/// The weight (within dragged_weights) with which the point over `shadow` would be shown nearest to `position_px`; none
/// where its ray is seen from its end.
std::optional<double> lifted_weight_at(const LiftedStage& stage, core::Point shadow, glm::dvec2 position_px);

}  // namespace batten::editor
