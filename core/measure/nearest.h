/// The point of a curve nearest to a given one.
#pragma once

#include <vector>

#include "core/evaluate/tessellate.h"
#include "core/measure/detail/chord_tree.h"
#include "core/measure/detail/squared_distance.h"

namespace batten::core {

/// The nearest curve point to `query`, which is finite, and its parameter, over the whole domain. A part of the curve
/// is left out only when the Bernstein form of its squared distance proves that it is no nearer, so the global minimum
/// is found; Newton's iteration finishes. The distance is right to about 1e-14 of the size of curve and query together.
/// Of points that are equally near up to that, the one with the least parameter. Cost: that of a NearestFinder and one
/// question. Source: Chen et al. 2008, Computing the minimum distance between a point and a NURBS curve.
CurveSample nearest_point(const Curve& curve, Point query);

/// Nearest points of one curve, for many questions.
class NearestFinder {
  public:
    /// Cost: that of the Bézier pieces and their chords, O(n p^2).
    explicit NearestFinder(const Curve& curve);

    /// What nearest_point says. Cost O(log n) chords and a few spans of O(p^2), and where many parts of the curve are
    /// nearly as near, one more for each of these. `looks`, where it is given, grows by the number of chords and parts
    /// of spans that were looked at.
    CurveSample nearest(Point query, std::size_t* looks = nullptr) const;

  private:
    friend class NearestSearch;

    std::size_t degree() const { return static_cast<std::size_t>(curve_.degree()); }
    std::vector<Chord> chords_of_spans();
    CurveSample polished(CurveSample found, Side side, Point query) const;

    // The pieces are seen from the origin in the middle of the curve, and in units in which its size is about 1.
    Curve curve_;
    Point origin_;
    double scale_ = 1.0;
    ProductBinomials binomials_;
    std::vector<Interval> spans_{};
    std::vector<HomogeneousPoint> points_{};  ///< p+1 Bézier points for each span
    Box box_{};                               ///< around them
    ChordTree chords_;                        ///< of the spans
};

}  // namespace batten::core
