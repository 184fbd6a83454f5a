#include "core/measure/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/evaluate/detail/subdivide.h"
#include "core/measure/detail/difference_piece.h"

namespace batten::core {

namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();

// The bound may be this part above a distance that was found; and in twice the precision is computed what rounding
// makes larger by more than that.
constexpr double bound_looseness = 5e-5;
constexpr double tolerable_rounding = 1e-5;

// After so many halvings, and some more for each span, the bound is taken as it is.
constexpr std::size_t least_halvings = 4096;
constexpr std::size_t halvings_of_span = 16;

// So many of the last pieces are computed again without rounding, so that 1 is 1 and not 1.00000000000001.
constexpr int most_polished = 32;

// A piece of the difference with a bound that halving never raises.
struct BoundedPiece {
    double bound = boundless;
    DifferencePiece piece;
    CommonSpan common;
    bool is_precise = false;  ///< by twofold precision
};

class DeviationSearch {
  public:
    DeviationSearch(const Curve& a, const Curve& b, const std::vector<CommonSpan>& spans) : a_(a), b_(b) {
        for (const CommonSpan& common : spans)
            add({boundless, difference_piece(a, b, common, Precision::plain), common});
        most_halvings_ = least_halvings + halvings_of_span * queue_.size();
    }

    double run() {
        for (std::size_t count = 0; !queue_.empty() && count < most_halvings_; ++count) {
            BoundedPiece top = take_largest();
            const double rounding = top.piece.rounding * top.piece.unit;
            const bool is_near = top.bound - 2.0 * rounding <= (1.0 + bound_looseness) * found_;
            if (!top.is_precise && (rounding > tolerable_rounding * top.bound || (is_near && may_polish())))
                add({top.bound, difference_piece(a_, b_, top.common, Precision::twofold), top.common, true});
            else if (is_near)
                return std::max(top.bound, found_);
            else
                add_halves(top);
        }
        return queue_.empty() ? 0.0 : std::max(queue_.front().bound, found_);
    }

  private:
    bool may_polish() { return polished_++ < most_polished; }

    static bool is_lower(const BoundedPiece& a, const BoundedPiece& b) { return a.bound < b.bound; }

    void add(BoundedPiece piece) {
        piece.bound = std::min(piece.bound, piece.piece.bound());
        found_ = std::max(found_, piece.piece.distance_at_ends());
        queue_.push_back(std::move(piece));
        std::push_heap(queue_.begin(), queue_.end(), is_lower);
    }

    void add_halves(const BoundedPiece& whole) {
        auto [left, right] = whole.piece.halves();
        const CommonSpan& common = whole.common;
        const double half_of_a = middle(common.part_of_a);
        const double half_of_b = middle(common.part_of_b);
        CommonSpan first = common;
        CommonSpan second = common;
        first.part_of_a.upper = second.part_of_a.lower = half_of_a;
        first.part_of_b.upper = second.part_of_b.lower = half_of_b;
        add({whole.bound, std::move(left), first, whole.is_precise});
        add({whole.bound, std::move(right), second, whole.is_precise});
    }

    BoundedPiece take_largest() {
        std::pop_heap(queue_.begin(), queue_.end(), is_lower);
        BoundedPiece top = std::move(queue_.back());
        queue_.pop_back();
        return top;
    }

    const Curve& a_;
    const Curve& b_;
    std::vector<BoundedPiece> queue_;
    double found_ = 0.0;
    int polished_ = 0;
    std::size_t most_halvings_ = 0;
};

// The knots of `knots` strictly inside `part`, once each.
std::vector<double> knots_inside(const KnotVector& knots, Interval part) {
    std::vector<double> found;
    const auto values = knots.values();
    for (auto knot = std::ranges::upper_bound(values, part.lower); knot != values.end() && *knot < part.upper; ++knot)
        if (found.empty() || found.back() != *knot) found.push_back(*knot);
    return found;
}

// Both parts cut where either has a knot, at equal shares.
void add_matched(std::vector<CommonSpan>& spans, const Curve& a, const Curve& b, Interval part_of_a,
                 Interval part_of_b) {
    std::vector<MatchedParameters> cuts{{part_of_a.lower, part_of_b.lower}};
    for (const double u : knots_inside(a.knots(), part_of_a))
        cuts.push_back({u, part_of_b.lower + (u - part_of_a.lower) / part_of_a.length() * part_of_b.length()});
    for (const double v : knots_inside(b.knots(), part_of_b))
        cuts.push_back({part_of_a.lower + (v - part_of_b.lower) / part_of_b.length() * part_of_a.length(), v});
    cuts.push_back({part_of_a.upper, part_of_b.upper});
    std::ranges::sort(cuts, {}, &MatchedParameters::of_a);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const Interval of_a{cuts[k].of_a, cuts[k + 1].of_a};
        const Interval of_b{cuts[k].of_b, cuts[k + 1].of_b};
        spans.push_back({a.knots().span_at(middle(of_a)), b.knots().span_at(middle(of_b)), of_a, of_b});
    }
}

std::vector<CommonSpan> matched_spans(const Curve& a, const Curve& b, std::span<const MatchedParameters> matches) {
    std::vector<CommonSpan> spans;
    for (std::size_t k = 0; k + 1 < matches.size(); ++k)
        add_matched(spans, a, b, {matches[k].of_a, matches[k + 1].of_a}, {matches[k].of_b, matches[k + 1].of_b});
    return spans;
}

}  // namespace

double largest_deviation(const Curve& a, const Curve& b) {
    return DeviationSearch(a, b, differing_spans(a, b)).run();
}

std::optional<double> quick_deviation(const Curve& a, const Curve& b, std::size_t most_spans) {
    const std::vector<CommonSpan> spans = differing_spans(a, b);
    if (spans.size() > most_spans) return std::nullopt;
    return DeviationSearch(a, b, spans).run();
}

double largest_deviation(const Curve& a, const Curve& b, std::span<const MatchedParameters> matches) {
    return DeviationSearch(a, b, matched_spans(a, b, matches)).run();
}

}  // namespace batten::core
