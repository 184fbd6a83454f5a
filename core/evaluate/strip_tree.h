/// What a long line looks like from any distance: strips about the chords of its stretches, joined two by two.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

/// A stretch of a line between two of its points, near their chord. Without a box it is empty: a stretch of no length.
struct Strip {
    Point first{};
    Point last{};
    Box box;                 ///< contains the stretch
    double deviation = 0.0;  ///< no place of the stretch is farther than this from the segment first..last
    bool is_whole = true;    ///< it does not come apart between its ends
    double length = 0.0;     ///< of the stretch, if it is one of a polygon
};

/// The strip of `a` followed by `b`. Its deviation is a bound: what the parts deviate and what their common end does,
/// or what the box allows; where the line comes apart, the size of the box.
Strip joined(const Strip& a, const Strip& b);

/// The strip of the polygon through `points` (at least one).
Strip strip_of(const std::vector<Point>& points);

/// What is wanted of a line.
struct StripRequest {
    double tolerance = 0.0;       ///< > 0: what is left out is nearer than this to what is drawn
    Box view;                     ///< stretches whose box is outside are left out
    std::size_t most_places = 0;  ///< of all polylines together; where they do not suffice the tolerance grows
};

/// Polylines; one ends where the line leaves the view or comes apart.
using PointRuns = std::vector<std::vector<Point>>;

/// Collects chords, those that meet in one polyline.
class RunCollector {
  public:
    explicit RunCollector(std::size_t most_places) : most_places_(most_places) {}

    /// The chord from a to b; a polyline that begins with it begins at `along`.
    void add(Point a, Point b, double along = 0.0);

    /// The place of a stretch whose box is thin, as the box's extent between its ends.
    void add_extent(const Strip& strip, double along);

    bool is_full() const { return count_ > most_places_; }
    bool is_nearly_full() const { return count_ > most_places_ - most_places_ / 5; }
    PointRuns take() { return std::move(runs_); }

    /// Where each polyline begins along the line.
    std::vector<double> take_starts() { return std::move(starts_); }

  private:
    std::size_t most_places_;
    std::size_t count_ = 0;
    PointRuns runs_;
    std::vector<double> starts_;
};

/// Whether a chord or the extent of a thin box shows `strip` within `tolerance`; if so it is added.
bool add_if_simple(const Strip& strip, double tolerance, RunCollector& runs, double along = 0.0);

/// How near a strip must be to be drawn as its chord. Where there are more places than wanted the longer the nearer, so
/// that also of a line that swings to and fro everywhere all parts are shown alike.
class StripTolerance {
  public:
    StripTolerance(double tolerance, bool is_crowded) {
        const double share = is_crowded ? std::cbrt(0.5) : 1.0;
        for (double& of_level : levels_) {
            of_level = tolerance;
            tolerance *= share;
        }
    }

    double of_single() const { return levels_.front(); }
    double of(std::size_t stretches) const { return levels_[static_cast<std::size_t>(std::bit_width(stretches)) - 1]; }

  private:
    std::array<double, 64> levels_{};  ///< of 1, 2, 4... stretches
};

/// What `search(tolerance, is_crowded)`, which gives a RunCollector, finds within `tolerance`, or within nearly the
/// least one above it for which the collector is not full. Cost: a dozen searches.
template <class Search>
RunCollector runs_within(double tolerance, Search search) {
    RunCollector runs = search(StripTolerance(tolerance, false));
    double too_fine = tolerance;
    double coarse = tolerance;
    // Faster and faster, so that coordinates of any size are reached soon.
    for (double growth = 1.5; runs.is_full(); growth *= 1.25) {
        too_fine = coarse;
        coarse *= growth;
        runs = search(StripTolerance(coarse, true));
    }
    for (int k = 0; k < 12 && 1.02 * too_fine < coarse && !runs.is_nearly_full(); ++k) {
        const double between = 0.5 * too_fine + 0.5 * coarse;
        RunCollector finer = search(StripTolerance(between, true));
        (finer.is_full() ? too_fine : coarse) = between;
        if (!finer.is_full()) runs = std::move(finer);
    }
    return runs;
}

/// Strips of neighboring stretches and, above them, of every two, four, eight... Source: Ballard 1981, Strip trees.
class StripTree {
  public:
    explicit StripTree(std::vector<Strip> stretches = {});

    std::size_t size() const { return levels_.front().size(); }
    const Strip& stretch(std::size_t i) const { return levels_.front()[i]; }

    /// The strip of 2^level stretches, the last one of fewer; the last level has one strip.
    const Strip& strip(std::size_t level, std::size_t i) const { return levels_[level][i]; }
    std::size_t level_count() const { return levels_.size(); }

    /// Puts another strip in the place of stretch `i`. Cost logarithmic.
    void replace(std::size_t i, const Strip& strip);

    /// Goes down from the whole line: `enter(strip, first, last)` says whether to look closer at the strip of the
    /// stretches first..last; where it does at a single one, `open(first)` is called. In order of the line. Empty
    /// stretches are skipped.
    template <class Enter, class Open>
    void visit(Enter enter, Open open) const {
        if (size() > 0) visit(levels_.size() - 1, 0, enter, open);
    }

  private:
    template <class Enter, class Open>
    void visit(std::size_t level, std::size_t i, Enter& enter, Open& open) const {
        const Strip& strip = levels_[level][i];
        const std::size_t first = i << level;
        const std::size_t last = std::min(((i + 1) << level) - 1, size() - 1);
        if (strip.box.is_empty() || !enter(strip, first, last)) return;
        if (level == 0) return open(i);
        visit(level - 1, 2 * i, enter, open);
        if (2 * i + 1 < levels_[level - 1].size()) visit(level - 1, 2 * i + 1, enter, open);
    }

    void join(std::size_t level, std::size_t i);

    std::vector<std::vector<Strip>> levels_;
};

}  // namespace batten::core
