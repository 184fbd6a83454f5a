/// What pictures keep from one to the next: computed once for a curve, and followed where it changes.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/scene/basis_cache.h"
#include "app/editor/scene/filled_shapes.h"
#include "app/editor/scene/kept_ink.h"
#include "app/editor/scene/label_spots.h"
#include "app/editor/scene/other_curves.h"
#include "core/document/document.h"
#include "core/evaluate/curve_strips.h"
#include "core/evaluate/lifted.h"
#include "core/evaluate/polygon_strips.h"

namespace batten::editor {

struct KeptHodograph {
    std::shared_ptr<const core::Curve> differentiated;  ///< the curve whose hodograph is there
    std::optional<core::CurveStrips> strips;
};

/// What is kept of one curve that is drawn.
class KeptCurve {
  public:
    explicit KeptCurve(std::shared_ptr<const core::Curve> curve) : strips_(std::move(curve)) {}

    void follow(const std::shared_ptr<const core::Curve>& curve) { strips_.follow(curve); }

    core::CurveStrips& strips() { return strips_; }

    /// The strips of the control polygon, made when they are asked for.
    core::PolygonStrips& polygon();

    KeptInk& curve_ink() { return curve_ink_; }
    KeptInk& polygon_ink() { return polygon_ink_; }

    /// The strips of the hodograph C' (order 1) or C'' (order 2), made when they are asked for; null where it is
    /// refused.
    core::CurveStrips* hodograph(std::size_t order);

    /// The lifted curve as it is shown in `view`, sampled when it is asked for.
    const std::vector<std::vector<core::LiftedSample>>& lifted(const core::LiftView& view,
                                                               const core::LiftedFineness& fineness);

    /// How many hodographs were made so far.
    std::size_t hodograph_count() const { return hodograph_count_; }

  private:
    core::CurveStrips strips_;
    std::optional<core::PolygonStrips> polygon_;
    KeptInk curve_ink_;
    KeptInk polygon_ink_;
    std::array<KeptHodograph, 2> hodographs_;
    std::size_t hodograph_count_ = 0;
    std::shared_ptr<const core::Curve> lifted_curve_;  ///< the curve whose samples are there
    core::LiftView lifted_view_;
    core::LiftedFineness lifted_fineness_;
    std::vector<std::vector<core::LiftedSample>> lifted_;
};

/// Belongs to whoever shows pictures of one editor; what it keeps is a function of what is shown, so a new one gives
/// the same pictures; but for the spots of labels, which are handed from frame to frame of an animation.
class SceneCache {
  public:
    /// What is kept of curve `index` of the shown document, which now is `curve`.
    KeptCurve& curve(std::size_t index, const std::shared_ptr<const core::Curve>& curve);

    /// What is kept of the ghost.
    KeptCurve& ghost(const std::shared_ptr<const core::Curve>& curve);

    OtherInk& others() { return others_; }
    OtherInk& selected_others() { return selected_others_; }

    FilledShapes& fills() { return fills_; }

    /// The graphs of the dock.
    BasisCache& basis() { return basis_; }

    /// The labels that the last picture of the canvas, or that and the plot of a figure, had no room for.
    std::vector<std::string>& unplaced() { return unplaced_; }

    /// Sentences that tell of what a figure draws not all.
    std::vector<std::string>& thinned() { return thinned_; }

    /// Where the labels of an animation stood before; empty in the window and for figures that stand still.
    LabelSpots& label_spots() { return label_spots_; }

    /// Forgets curves beyond the first `count`.
    void forget_beyond(std::size_t count);

  private:
    std::vector<std::unique_ptr<KeptCurve>> curves_;
    std::unique_ptr<KeptCurve> ghost_;
    OtherInk others_;
    OtherInk selected_others_;
    FilledShapes fills_;
    BasisCache basis_;
    std::vector<std::string> unplaced_;
    std::vector<std::string> thinned_;
    LabelSpots label_spots_;
};

}  // namespace batten::editor
