/// What of a curve and its control polygon is near a place, found without a look at the rest.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/evaluate/tessellate.h"
#include "core/measure/detail/place_tree.h"

namespace batten::core {

/// Boxes around every sixteen control points of one curve and what depends on them: small beside the curve, and quickly
/// made. A NearestFinder answers in less time, but holds many times what the curve does.
class NearParts {
  public:
    /// Cost O(n (p + log n)), and five bytes for each control point.
    explicit NearParts(Curve curve);

    const Curve& curve() const { return curve_; }

    /// Calls `visit(i)`, ascending, for control points (of a periodic curve those of the unrolled one), among them
    /// every one i for which the point itself, the leg from it to the next or the span over the points i..i+p comes
    /// within `distance` of `place`. Cost O(log n) and what is visited; `looks`, where it is given, grows by the
    /// number of boxes that were looked at.
    template <class Visit>
    void visit_near(Point place, double distance, Visit visit, std::size_t* looks = nullptr) const {
        for (const std::size_t stretch : stretches_near(place, distance, looks))
            for (std::size_t i = stretch * points_per_stretch; i < end_of(stretch); ++i) visit(i);
    }

    /// Whether more than `most` control points, legs or spans may come within `distance` of `place`. Cost O(log n +
    /// most).
    bool is_crowded(Point place, double distance, std::size_t most) const;

    /// The parts of the curve whose control points come within `distance` of `place`: open curves over runs of
    /// neighboring spans, with the same parameters, in order. None where these are more than `most_spans` spans, or
    /// where the place is crowded by some hundred more. Cost O(log n) and that of what is found.
    std::optional<std::vector<Curve>> parts_near(Point place, double distance, std::size_t most_spans) const;

    /// What nearest_point says of `query`, which is finite; none where that is farther than `reach`. Cost O(log n)
    /// boxes and a few stretches of O(p^2) for a point, and where many are nearly as near, one more for each of these.
    std::optional<CurveSample> nearest(Point query, double reach = Box::infinity, std::size_t* looks = nullptr) const;

  private:
    class Search;

    static constexpr std::size_t points_per_stretch = 16;

    std::size_t degree() const { return static_cast<std::size_t>(curve_.degree()); }
    /// Of the unrolled curve.
    std::size_t point_count() const { return curve_.knots().size() - degree() - 1; }
    std::size_t end_of(std::size_t stretch) const {
        return std::min((stretch + 1) * points_per_stretch, point_count());
    }
    std::vector<Point> points_of(std::size_t first, std::size_t end) const;
    std::vector<Box> boxes_of_stretches() const;
    std::vector<std::size_t> stretches_near(Point place, double distance, std::size_t* looks) const;

    Curve curve_;
    PlaceTree boxes_;
};

}  // namespace batten::core
