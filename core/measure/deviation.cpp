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
    DeviationSearch(const Curve& a, const Curve& b) : a_(a), b_(b) {
        for (const CommonSpan& common : differing_spans(a, b))
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

}  // namespace

double largest_deviation(const Curve& a, const Curve& b) {
    return DeviationSearch(a, b).run();
}

}  // namespace batten::core
