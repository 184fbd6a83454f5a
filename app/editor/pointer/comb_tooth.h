/// How long the teeth of the curvature comb are, for the picture and for its handle.
#pragma once

#include <optional>

#include "app/editor/state/state.h"

namespace batten::editor {

/// From curvature to pixels.
struct CombScale {
    double px_per_curvature = 0.0;
    double longest_px = 0.0;  ///< near cusps
};

/// The scale by which what is large along the curve has teeth of one length, times `factor`; none for a curve without
/// curvature.
std::optional<CombScale> comb_scale(const EditorState& state, const core::Curve& curve, double factor);

/// A tooth in the picture.
struct Tooth {
    core::Point foot{};
    glm::dvec2 direction{};  ///< of a positive length: to the right of the curve, in the picture
    double length_px = 0.0;  ///< signed, as the curvature

    glm::dvec2 tip(glm::dvec2 foot_px) const { return foot_px + length_px * direction; }
};

/// The tooth at `u`, seen from `side`; none where there is no curvature.
std::optional<Tooth> tooth_at(const core::Curve& curve, double u, core::Side side, const CombScale& scale);

/// The handle of the comb stands at the tip of the tooth at the view's parameter, or so far from the foot as to leave
/// the point C(u) free.
struct CombHandle {
    glm::dvec2 foot_px{};
    glm::dvec2 place_px{};
};

/// Where the handle is with the comb lengthened by `factor`; none where no comb or no tooth is shown.
std::optional<CombHandle> comb_handle(const EditorState& state, double factor);

/// What the comb is to be lengthened by after its handle was dragged by `moved_px`, so that it follows the pointer
/// along its tooth; `factor` was it before. Within comb_factors.
double dragged_comb_factor(const EditorState& state, double factor, glm::dvec2 moved_px);

}  // namespace batten::editor
