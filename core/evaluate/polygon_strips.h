/// A control polygon as polylines of any fineness, at a cost that depends on what is seen and not on the polygon.
#pragma once

#include <memory>
#include <optional>

#include "core/curve/curve.h"
#include "core/evaluate/stretches.h"
#include "core/evaluate/strip_tree.h"

namespace batten::core {

/// Polylines, and how far along the polygon each begins.
struct PolygonRuns {
    PointRuns runs;
    std::vector<double> starts;
};

/// Keeps strips of every sixteen legs of the control polygon of one curve, and joined strips above them.
class PolygonStrips {
  public:
    /// Cost O(n).
    explicit PolygonStrips(std::shared_ptr<const Curve> curve);

    const std::shared_ptr<const Curve>& curve() const { return curve_; }

    /// From now on these are the strips of the polygon of `curve`. Cost: comparing the points, and the stretches with
    /// changed ones anew; all of it anew where more than a few points were added or taken away in one place.
    void follow(std::shared_ptr<const Curve> curve);

    /// The visible part of the polygon, closed when the curve is periodic. All its legs when they are no more than
    /// most_places allows, whatever the tolerance; else within the tolerance, > 0. None where that takes more places.
    std::optional<PolygonRuns> runs(const StripRequest& request) const;

    /// Hands out chords of all that is seen of the polygon and not hidden, in no order. Leaves out the legs `left_out`
    /// (ascending). Cost: that of the legs that are neither in one chord with others nor hidden with them.
    void visit_chords(const ChordRequest& request, std::span<const std::size_t> left_out = {}) const;

    /// The one of one leg.
    void visit_leg_chord(const ChordRequest& request, std::size_t leg) const;

    const StripChange& change() const { return change_; }

    /// Calls `take(index, point, count)` for the control points in `view`, ascending: for each with a count of 1, but
    /// for a stretch of no more than `size` only for one point, with the number of its points; of one of no more than
    /// four times that for points that are `size` apart, each with the number of those that follow. Where more than
    /// about `most` are left, every so manieth.
    template <class Take>
    void visit_points(const Box& view, double size, std::size_t most, Take take) const {
        std::size_t seen = 0;
        visit(
            view, size, [](std::size_t, std::size_t) {},
            [&](std::size_t stretch) { seen += stretch_legs_[stretch].size(); });
        const std::size_t stride = std::min(seen / most + 1, Stretches::usual_size);
        visit(
            view, size,
            [&](std::size_t first, std::size_t last) {
                const std::size_t begin = stretch_legs_[first].first;
                // Each time another one of sixteen, so that what is shown is not all of one kind.
                const std::size_t i = std::min(begin + first % Stretches::usual_size, point_end(last) - 1);
                take(i, curve_->control_points()[i], point_end(last) - begin);
            },
            [&](std::size_t stretch) {
                const bool is_dense = extent(tree_.stretch(stretch)) <= 4.0 * size;
                visit_stretch(stretch, view, is_dense ? size : 0.0, stride, take);
            });
    }

    /// How many stretches got a strip so far.
    std::size_t stretch_count() const { return stretch_count_; }

  private:
    /// The corners of the polygon; of a closed one the first counts once more.
    std::size_t corner_count() const { return curve_->control_points().size() + (curve_->is_periodic() ? 1U : 0U); }
    Point corner(std::size_t i) const { return curve_->control_points()[i % curve_->control_points().size()]; }

    /// The end of the points of a stretch, those where its legs begin; of the last one with the end of the polygon.
    std::size_t point_end(std::size_t stretch) const {
        return stretch + 1 < tree_.size() ? stretch_legs_[stretch].end : curve_->control_points().size();
    }

    static double extent(const Strip& strip) {
        const Vector size = strip.box.size();
        return std::max(size.x, size.y);
    }

    /// Calls `merge(first, last)` for stretches in view that together are no more than `size`, `open` for single
    /// others.
    template <class Merge, class Open>
    void visit(const Box& view, double size, Merge merge, Open open) const {
        tree_.visit(
            [&](const Strip& strip, std::size_t first, std::size_t last) {
                if (!strip.box.intersects(view)) return false;
                if (extent(strip) > size) return true;
                merge(first, last);
                return false;
            },
            open);
    }

    template <class Take>
    void visit_stretch(std::size_t stretch, const Box& view, double apart, std::size_t stride, Take& take) const {
        const auto points = curve_->control_points();
        const std::size_t end = point_end(stretch);
        for (std::size_t i = stretch_legs_[stretch].first; i < end;) {
            std::size_t next = std::min(i + stride, end);
            while (next < end && distance(points[next], points[i]) < apart) ++next;
            if (view.contains(points[i])) take(i, points[i], next - i);
            i = next;
        }
    }

    /// The corners of a stretch, with the one where the next begins.
    std::vector<Point> corners_of(std::size_t stretch) const;
    Strip strip_of_stretch(std::size_t stretch);
    void make_anew(std::shared_ptr<const Curve> curve);
    void follow_points(std::shared_ptr<const Curve> curve);
    bool follow_renumbered(const std::shared_ptr<const Curve>& curve);
    Box box_of(std::span<const std::size_t> legs) const;
    RunCollector search(const StripRequest& request, double tolerance) const;

    std::shared_ptr<const Curve> curve_;
    Stretches stretch_legs_;
    StripTree tree_;
    std::size_t stretch_count_ = 0;
    StripChange change_;
};

}  // namespace batten::core
