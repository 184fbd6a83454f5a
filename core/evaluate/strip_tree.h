/// What a long line looks like from any distance: strips about the chords of its stretches, joined two by two.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <span>
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
    std::size_t most_places = 0;  ///< of all polylines together
};

/// What is wanted of a line that is drawn with as many chords as it takes.
struct ChordRequest {
    double tolerance = 0.0;                       ///< > 0: what is left out is nearer than this to a chord
    Box view;                                     ///< stretches whose box is outside are left out
    std::function<bool(const Strip&)> is_hidden;  ///< whether what the strip contains would not be seen; is left out
    std::function<void(Point a, Point b)> take;   ///< gets the chords
};

/// Whether something of the strip may be seen.
inline bool is_seen(const Strip& strip, const ChordRequest& request) {
    return strip.box.intersects(request.view) && !request.is_hidden(strip);
}

/// What following a line to another value has changed.
struct StripChange {
    std::uint64_t number = 0;          ///< how many changes there were so far
    bool is_all = true;                ///< the last one may have changed everything
    bool is_renumbered = false;        ///< later parts have other numbers than before
    std::vector<std::size_t> parts{};  ///< spans or legs that the last one changed or made, ascending
    Box before{};                      ///< contains what it changed or took away
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

/// Whether one of `ascending` lies in first..last.
bool has_any(std::span<const std::size_t> ascending, std::size_t first, std::size_t last);

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

    /// Puts `strip_of(i)` in the place of each of these stretches, ascending. Cost linear in how many there are, but at
    /// most logarithmic for each.
    template <class StripOf>
    void replace_all(std::vector<std::size_t> stretches, StripOf strip_of) {
        for (const std::size_t i : stretches) levels_.front()[i] = strip_of(i);
        join_above(std::move(stretches));
    }

    /// Goes down from the whole line: `enter(strip, first, last)` says whether to look closer at the strip of the
    /// stretches first..last; where it does at a single one, `open(first)` is called. In order of the line. Empty
    /// stretches are skipped.
    template <class Enter, class Open>
    void visit(Enter enter, Open open) const {
        if (size() > 0) visit(levels_.size() - 1, 0, enter, open);
    }

    /// The same, beginning not at the first stretch but with a few here and there, then with those between, so that
    /// soon some of all that there is has been visited.
    template <class Enter, class Open>
    void visit_scattered(Enter enter, Open open) const {
        if (size() == 0) return;
        std::size_t level = 0;
        while (levels_[level].size() > most_beginnings) ++level;
        const std::size_t count = levels_[level].size();
        const auto bits = static_cast<unsigned>(std::bit_width(count - 1));
        for (std::size_t k = 0; k < std::size_t{1} << bits; ++k) {
            const std::size_t i = reversed_bits(k, bits);
            if (i < count) visit(level, i, enter, open);
        }
    }

  private:
    static constexpr std::size_t most_beginnings = 1024;

    static std::size_t reversed_bits(std::size_t k, unsigned bits) {
        std::size_t reversed = 0;
        for (unsigned i = 0; i < bits; ++i) reversed = (reversed << 1U) | ((k >> i) & 1U);
        return reversed;
    }

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
    void join_above(std::vector<std::size_t> stretches);

    std::vector<std::vector<Strip>> levels_;
};

}  // namespace batten::core
