/// What is derived from a curve for showing it, and kept beside it: a frame in which nothing changed computes nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/derived/kept.h"
#include "app/editor/derived/knot_questions.h"
#include "app/editor/derived/map_check.h"
#include "app/editor/derived/plot_basis.h"
#include "app/editor/derived/selected_box.h"
#include "app/editor/words/number_column.h"
#include "core/curve/curve.h"
#include "core/curve/knot_analysis.h"
#include "core/measure/near_parts.h"

namespace batten::editor {

/// Whether both have the same arrays, not only equal ones.
bool share_arrays(const core::KnotVector& a, const core::KnotVector& b);
bool share_arrays(const core::Curve& a, const core::Curve& b);

/// Whether the weights are one array.
bool share_weights(const core::Curve& a, const core::Curve& b);
bool share_arrays(const MappedCurve& a, const MappedCurve& b);

struct KnotFacts {
    std::vector<std::uint32_t> runs;  ///< where the runs of equal knots begin in stored(), for distinct_knot()
    std::size_t segment_count = 0;
    std::optional<int> least_continuity;  ///< at an interior knot; none when the curve is one polynomial piece
    core::KnotKind kind{};                ///< as the values say
    bool is_bezier = false;

    bool is_torn() const { return least_continuity && *least_continuity < 0; }
};

/// The control polygon after so many rounds of midpoint insertion, and a bound of its distance from the curve.
struct PolygonRound {
    std::shared_ptr<const core::Curve> curve;
    double distance = 0.0;
};

struct CurveFacts {
    core::Box control_box;
    double size = 0.0;  ///< the longer side of the box
};

/// What the weights of a curve say.
struct WeightFacts {
    NumberColumn column;
    double lightest = 1.0;  ///< the least weight
    double heaviest = 1.0;  ///< the greatest weight
};

/// Curves whose control points are dragged share their knots, and so the facts about these.
class Derived {
  public:
    /// Cost O(n) when first asked for.
    std::shared_ptr<const KnotFacts> of(const core::KnotVector& knots) const;
    std::shared_ptr<const CurveFacts> of(const core::Curve& curve) const;

    /// The same for curves that share their weights, whatever their points. Cost O(n) when first asked for.
    std::shared_ptr<const WeightFacts> weights_of(const core::Curve& curve) const;

    /// Cost as PlotBasis says when first asked for.
    std::shared_ptr<const PlotBasis> plot_basis(const core::KnotVector& knots) const;

    /// The present polygon and those of up to three rounds more, as long as they have few hundred points; none of a
    /// curve of very many points.
    std::shared_ptr<const std::vector<PolygonRound>> polygon_rounds(const core::Curve& curve) const;

    /// The curvature that nine tenths of the curve stay below; 0 for a straight line. Of very many spans some are
    /// measured.
    double large_curvature(const core::Curve& curve) const;

    /// What the questions about knots are answered by, and what a map makes of a curve.
    std::shared_ptr<const KnotAnswers> answers_about(const core::KnotVector& knots) const;
    std::shared_ptr<const MapCheck> map_check(const MappedCurve& mapped) const;

    /// For what is under the pointer; of any number of curves.
    std::shared_ptr<const core::NearParts> near_parts(const std::shared_ptr<const core::Curve>& curve) const;

    /// What is selected of all curves; see KeptSelection.
    std::shared_ptr<const SelectedBox> selected(const Selection& selection, const core::Document& document) const {
        return selected_.of(selection, document);
    }

  private:
    Kept<core::KnotVector, KnotFacts, share_arrays> of_knots_;
    Kept<core::Curve, CurveFacts, share_arrays> of_curves_;
    Kept<core::Curve, WeightFacts, share_weights> of_weights_;
    Kept<core::KnotVector, PlotBasis, share_arrays> plot_bases_;
    Kept<core::Curve, double, share_arrays> large_curvatures_;
    Kept<core::Curve, std::vector<PolygonRound>, share_arrays> polygon_rounds_;
    Kept<core::KnotVector, KnotAnswers, share_arrays> answers_;
    Kept<MappedCurve, MapCheck, share_arrays> map_checks_;
    KeptBeside<core::Curve, core::NearParts> near_parts_;
    KeptSelection selected_;
};

}  // namespace batten::editor
