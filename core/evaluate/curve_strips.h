/// A curve as polylines of any fineness, at a cost that depends on what is seen and not on the curve.
#pragma once

#include <cstdint>
#include <memory>

#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/strip_tree.h"

namespace batten::core {

/// Keeps what is found out about one curve: strips of every sixteen spans and joined strips above them; for stretches
/// that were looked at closely, strips of the spans and of the parts into which these were halved. Following the curve
/// to another value keeps all of it where knots, points and weights stay the same.
class CurveStrips {
  public:
    /// Cost O(n p), with a few points of the curve for every sixteen spans.
    explicit CurveStrips(std::shared_ptr<const Curve> curve);

    const std::shared_ptr<const Curve>& curve() const { return curve_; }

    /// From now on these are the strips of `curve`. Cost: comparing knots, points and weights, and the changed spans
    /// and their stretches anew; all of it anew where degree or number of knots are others.
    void follow(std::shared_ptr<const Curve> curve);

    /// The visible part of the curve over `range`, which should begin and end at knots: the spans that have more than
    /// an end in common with it. The distance from what is seen of the curve to the polylines is bounded by the
    /// tolerance, > 0 (convex hulls), never only sampled; below the rounding of the coordinates there is no finer. The
    /// tolerance grows as far as needed for no more than most_places. Places are points of the curve as point_at gives
    /// them, but for the ends of thin boxes. No chord is much longer than 64 views. Cost: that of the places, and of
    /// what is looked at closely for the first time.
    PointRuns runs(const StripRequest& request, Interval range);

    /// Calls `take(span, point, count)` for the non-empty spans that may be seen, ascending, with the point where the
    /// span begins and a count of 1; for a stretch of no more than `size_of_stretch`, and for neighboring spans of no
    /// more than a sixteenth of that, only for the first span, with their number, empty ones included; so for every
    /// stretch where more than about `most` are left. Cost: that of what is visited, and of what is for the first time.
    template <class Take>
    void visit_spans(const Box& view, double size_of_stretch, std::size_t most, Take take) {
        ++use_;
        std::size_t seen = 0;
        visit_strips(
            stretches_, view, size_of_stretch, [](std::size_t, std::size_t, Point) {},
            [&](std::size_t) { seen += spans_per_stretch; });
        const auto take_stretches = [&](std::size_t first, std::size_t last, Point point) {
            const std::size_t begin = first_span() + first * spans_per_stretch;
            const std::size_t end = std::min(first_span() + (last + 1) * spans_per_stretch, span_end());
            take(non_empty(begin), point, end - begin);
        };
        visit_strips(stretches_, view, size_of_stretch, take_stretches, [&](std::size_t stretch) {
            if (seen > most)
                take_stretches(stretch, stretch, stretches_.stretch(stretch).first);
            else
                visit_stretch(stretch, view, size_of_stretch / spans_per_stretch, take);
        });
        drop_unused();
    }

    /// The strips of every sixteen spans, from the first span of the domain on, empty ones included.
    const StripTree& stretches() const { return stretches_; }
    static constexpr std::size_t spans_per_stretch = 16;

    /// How many spans were made Bézier pieces so far.
    std::size_t span_count() const { return span_count_; }

    /// How many stretches got a strip so far.
    std::size_t stretch_count() const { return stretch_count_; }

  private:
    /// A part of a span: halved (its parts stand at `parts` and after it), or with the Bézier piece to be halved.
    struct Part {
        Strip strip;
        Interval interval;
        std::size_t parts = 0;
        std::vector<HomogeneousPoint> points{};
    };

    /// A span and what it was halved into.
    using SpanParts = std::vector<Part>;

    /// A stretch that was looked at closely.
    struct OpenStretch {
        StripTree spans;
        std::vector<SpanParts> parts;
        std::uint64_t last_use = 0;
    };

    class Search;

    /// Calls `merge(first, last, start)` for strips in view that together are no more than `size`, `open` for single
    /// others.
    template <class Merge, class Open>
    static void visit_strips(const StripTree& tree, const Box& view, double size, Merge merge, Open open) {
        tree.visit(
            [&](const Strip& strip, std::size_t first, std::size_t last) {
                if (!strip.box.intersects(view)) return false;
                const Vector extent = strip.box.size();
                if (!(std::max(extent.x, extent.y) <= size)) return true;
                merge(first, last, strip.first);
                return false;
            },
            open);
    }

    template <class Take>
    void visit_stretch(std::size_t stretch, const Box& view, double size, Take& take) {
        const StripTree& spans = opened(stretch).spans;
        const std::size_t base = first_span() + stretch * spans_per_stretch;
        visit_strips(
            spans, view, size,
            [&](std::size_t first, std::size_t last, Point point) {
                take(non_empty(base + first), point, last + 1 - first);
            },
            [&](std::size_t k) { take(base + k, spans.stretch(k).first, 1); });
    }

    std::size_t first_span() const { return static_cast<std::size_t>(curve_->degree()); }
    /// The first span from `span` on that is not empty.
    std::size_t non_empty(std::size_t span) const {
        while (curve_->knots()[span] == curve_->knots()[span + 1]) ++span;
        return span;
    }
    std::size_t span_end() const { return curve_->knots().size() - first_span() - 1; }
    bool is_torn_at(std::size_t span) const;
    Point start_of(std::size_t span) const;
    Strip strip_of_piece(const BezierPiece& piece, Point first) const;
    Strip strip_of_stretch(std::size_t stretch);
    SpanParts parts_of_span(std::size_t span);
    OpenStretch& opened(std::size_t stretch);
    void halve(SpanParts& parts, std::size_t part) const;
    void drop_unused();
    std::vector<std::size_t> changed_spans(const Curve& other) const;

    std::shared_ptr<const Curve> curve_;
    StripTree stretches_;
    std::vector<std::unique_ptr<OpenStretch>> open_;
    std::size_t open_count_ = 0;
    std::uint64_t use_ = 0;
    std::size_t span_count_ = 0;
    std::size_t stretch_count_ = 0;
};

}  // namespace batten::core
