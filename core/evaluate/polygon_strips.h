/// A control polygon as polylines of any fineness, at a cost that depends on what is seen and not on the polygon.
#pragma once

#include <memory>

#include "core/curve/curve.h"
#include "core/evaluate/strip_tree.h"

namespace batten::core {

/// Keeps strips of every sixteen legs of the control polygon of one curve, and joined strips above them.
class PolygonStrips {
  public:
    /// Cost O(n).
    explicit PolygonStrips(std::shared_ptr<const Curve> curve);

    const std::shared_ptr<const Curve>& curve() const { return curve_; }

    /// From now on these are the strips of the polygon of `curve`. Cost: comparing the points, and the stretches with
    /// changed ones anew; all of it anew where there are more or fewer points.
    void follow(std::shared_ptr<const Curve> curve);

    /// The visible part of the polygon, closed when the curve is periodic. All its legs when they are no more than
    /// most_places allows, whatever the tolerance; else within the tolerance, > 0, which grows as far as needed.
    PointRuns runs(const StripRequest& request) const;

    /// Calls `take(index, point, count)` for the control points in `view`, ascending: for each with a count of 1, but
    /// for a stretch of no more than `size` only for its first point, with the number of its points.
    template <class Take>
    void visit_points(const Box& view, double size, Take take) const {
        const auto points = curve_->control_points();
        tree_.visit(
            [&](const Strip& strip, std::size_t first, std::size_t last) {
                if (!strip.box.intersects(view)) return false;
                const Vector extent = strip.box.size();
                if (!(std::max(extent.x, extent.y) <= size)) return true;
                const std::size_t end = last + 1 < tree_.size() ? (last + 1) * legs_per_stretch : points.size();
                take(first * legs_per_stretch, points[first * legs_per_stretch], end - first * legs_per_stretch);
                return false;
            },
            [&](std::size_t stretch) {
                const std::size_t first = stretch * legs_per_stretch;
                const std::size_t end = stretch + 1 < tree_.size() ? first + legs_per_stretch : points.size();
                for (std::size_t i = first; i < end; ++i)
                    if (view.contains(points[i])) take(i, points[i], 1);
            });
    }

    static constexpr std::size_t legs_per_stretch = 16;

    /// How many stretches got a strip so far.
    std::size_t stretch_count() const { return stretch_count_; }

  private:
    /// The corners of the polygon; of a closed one the first counts once more.
    std::size_t corner_count() const { return curve_->control_points().size() + (curve_->is_periodic() ? 1U : 0U); }
    Point corner(std::size_t i) const { return curve_->control_points()[i % curve_->control_points().size()]; }

    /// The corners of a stretch, with the one where the next begins.
    std::vector<Point> corners_of(std::size_t stretch) const;
    Strip strip_of_stretch(std::size_t stretch);
    RunCollector search(const StripRequest& request, double tolerance) const;

    std::shared_ptr<const Curve> curve_;
    StripTree tree_;
    std::size_t stretch_count_ = 0;
};

}  // namespace batten::core
