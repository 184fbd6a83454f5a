/// A curve as polylines of any fineness, at a cost that depends on what is seen and not on the curve.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/stretches.h"
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

    /// Contains the curve.
    const Box& box() const { return stretches_.strip(stretches_.level_count() - 1, 0).box; }

    /// Below this tolerance there is no finer: what coordinates of such a size round. Not finite where they overflow.
    double rounding() const;

    /// From now on these are the strips of `curve`. Cost: comparing knots, points and weights, and the changed spans
    /// and their stretches anew; all of it anew where the degree is another, or more than a few knots were inserted or
    /// removed in one place.
    void follow(std::shared_ptr<const Curve> curve);

    /// The visible part of the curve over `range`, which should begin and end at knots: the spans that have more than
    /// an end in common with it. The distance from what is seen of the curve to the polylines is bounded by the
    /// tolerance, > 0 (convex hulls), never only sampled; below the rounding of the coordinates there is no finer. None
    /// where that takes more than most_places. Places are points of the curve as point_at gives them, but for the ends
    /// of thin boxes. No chord is much longer than 64 views. Cost: that of the places, and of what is looked at closely
    /// for the first time.
    std::optional<PointRuns> runs(const StripRequest& request, Interval range);

    /// The whole curve as polylines that are as true in the view, and outside of it run round each place of the view as
    /// often as the curve does. None where that takes more than most_places. Cost likewise.
    std::optional<PointRuns> outline(const StripRequest& request);

    /// Hands out chords of all that is seen and not hidden of the curve over `range`, as runs() would have them but for
    /// thin boxes, in no order. Leaves out the spans `left_out` (ascending). Keeps nothing. Cost: that of the spans
    /// that are neither in one chord with others nor hidden with them.
    void visit_chords(const ChordRequest& request, Interval range, std::span<const std::size_t> left_out = {}) const;

    /// Those of one span, none of an empty one.
    void visit_span_chords(const ChordRequest& request, std::size_t span) const;

    const StripChange& change() const { return change_; }

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
            [&](std::size_t stretch) { seen += stretch_spans_[stretch].size(); });
        const auto take_stretches = [&](std::size_t first, std::size_t last, Point point) {
            const ItemRange spans = stretch_spans_.items(first, last);
            take(non_empty(spans.first), point, spans.size());
        };
        visit_strips(stretches_, view, size_of_stretch, take_stretches, [&](std::size_t stretch) {
            if (seen > most)
                take_stretches(stretch, stretch, stretches_.stretch(stretch).first);
            else
                visit_stretch(stretch, view, size_of_stretch / Stretches::usual_size, take);
        });
        drop_unused();
    }

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
        const std::size_t base = stretch_spans_[stretch].first;
        visit_strips(
            spans, view, size,
            [&](std::size_t first, std::size_t last, Point point) {
                take(non_empty(base + first), point, last + 1 - first);
            },
            [&](std::size_t k) { take(base + k, spans.stretch(k).first, 1); });
    }

    /// The spans that have more than an end in common with `range`.
    ItemRange spans_over(Interval range) const;
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
    Box box_of(std::span<const std::size_t> spans) const;
    void make_anew(std::shared_ptr<const Curve> curve);
    void follow_points(std::shared_ptr<const Curve> curve);
    bool follow_renumbered(const std::shared_ptr<const Curve>& curve);
    void renew(std::size_t stretch);

    std::shared_ptr<const Curve> curve_;
    Stretches stretch_spans_;
    StripTree stretches_;
    std::vector<std::unique_ptr<OpenStretch>> open_;
    std::size_t open_count_ = 0;
    std::uint64_t use_ = 0;
    std::size_t span_count_ = 0;
    std::size_t stretch_count_ = 0;
    StripChange change_;
};

}  // namespace batten::core
