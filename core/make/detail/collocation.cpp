#include "core/make/detail/collocation.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/shared_array.h"
#include "core/make/detail/cubic_rows.h"

namespace batten::core {

namespace {

constexpr std::size_t band = CubicRows::band;

// So many roundings of the largest coordinate may be the error.
constexpr double most_roundings = 2.0;

// Two numbers side by side: of row r, and of the row that is as far from the end as r is from the beginning.
using DoublePair = double __attribute__((vector_size(16)));

// What is wanted of an unknown: both coordinates, and how far errors of one unit in every row would move it. That is
// the solution for a right side of alternating signs, since the inverse of a totally positive matrix has them too.
template <class Number>
struct Sides {
    Number x;
    Number y;
    Number reach;
};

template <class Number>
Sides<Number> without(const Sides<Number>& from, Number factor, const Sides<Number>& other) {
    return {from.x - factor * other.x, from.y - factor * other.y, from.reach - factor * other.reach};
}

// Unknown r plus after[0] times the next one and after[1] times the one after it is `right`.
template <class Number>
struct SolvedRow {
    std::array<Number, band> after;
    Sides<Number> right;
};

template <class Number>
struct OpenRow {
    std::array<Number, 2 * band + 1> coefficients;
    Sides<Number> right;
};

// The last two rows solved, and what after[0] of the last is the quotient of.
template <class Number>
struct Front {
    SolvedRow<Number> second{};
    SolvedRow<Number> first{};
    Number numerator{};
    Number pivot = Number{} + 1.0;
};

// `row` without the unknowns of the two rows in front of it; it joins them. From pivot to pivot there is a division and
// a difference; the rest need not be waited for.
template <class Number>
SolvedRow<Number> eliminated(const OpenRow<Number>& row, Front<Number>& front) {
    const auto& [c0, c1, c2, c3, c4] = row.coefficients;
    const auto& [second, first, numerator, pivot] = front;
    const Number factor = c1 - c0 * second.after[0];
    const Number next_pivot = (c2 - c0 * second.after[1]) - (factor * numerator) / pivot;
    const Number next_numerator = c3 - factor * first.after[1];
    const Number share = 1.0 / next_pivot;
    const Sides<Number> right = without(without(row.right, c0, second.right), factor, first.right);
    const SolvedRow<Number> solved{{share * next_numerator, share * c4},
                                   {share * right.x, share * right.y, share * right.reach}};
    front = {first, solved, next_numerator, next_pivot};
    return solved;
}

template <class Number>
Sides<Number> substituted(const SolvedRow<Number>& row, const Sides<Number>& next, const Sides<Number>& after_next) {
    return without(without(row.right, row.after[1], after_next), row.after[0], next);
}

DoublePair larger(DoublePair a, DoublePair b) {
    return a < b ? b : a;
}

DoublePair size_of(DoublePair a) {
    return larger(a, -a);
}

// The equations of consecutive rows.
class RowBlock {
  public:
    static constexpr std::size_t capacity = CubicRows::capacity;

    RowBlock(const CubicCollocation& given, std::size_t first, std::size_t count) : first_(first), count_(count) {
        const std::size_t n = given.points.size();
        std::array<double, capacity + 2 * band> x;
        std::array<double, capacity + 2 * band> y;
        // Beyond the ends there are points of no influence.
        x.fill(0.0);
        y.fill(0.0);
        const std::size_t from = std::max(first, band) - band;
        const std::size_t to = std::min(first + count + band, n);
        for (std::size_t i = from; i < to; ++i) {
            x[i + band - first] = given.points[i].x;
            y[i + band - first] = given.points[i].y;
        }
        // The first and the last row are known and have no six knots around them.
        const std::size_t begin = first == 0 ? 1 : 0;
        const std::size_t end = first + count == n ? count - 1 : count;
        fill_cubic_rows(rows_,
                        {given.knots.data() + first, given.sites.data() + first, x.data() + band, y.data() + band},
                        begin, end);
        for (const KnownPoint& known : given.ends.known) set(known.index, {0.0, 0.0, 1.0, 0.0, 0.0}, {0.0, 0.0});
        for (const BoundPoint& bound : given.ends.bound) bind(bound, given.points);
    }

    double coefficient(std::size_t r, std::size_t j) const { return rows_.coefficients[j][r - first_]; }
    double x(std::size_t r) const { return rows_.x[r - first_]; }
    double y(std::size_t r) const { return rows_.y[r - first_]; }

  private:
    void set(std::size_t r, const std::array<double, 2 * band + 1>& coefficients, Vector right) {
        if (r < first_ || r >= first_ + count_) return;
        for (std::size_t j = 0; j < coefficients.size(); ++j) rows_.coefficients[j][r - first_] = coefficients[j];
        rows_.x[r - first_] = right.x;
        rows_.y[r - first_] = right.y;
    }

    // The bound point is seen from where it is bound to.
    void bind(const BoundPoint& bound, std::span<const Point> points) {
        const Vector right = bound.share * (points[bound.to] - bound.from);
        const bool is_after = bound.to > bound.index;
        set(bound.index, {0.0, is_after ? 0.0 : -bound.share, 1.0, is_after ? -bound.share : 0.0, 0.0}, right);
    }

    CubicRows rows_;
    std::size_t first_;
    std::size_t count_;
};

double sign_of(std::size_t r) {
    return r % 2 == 0 ? 1.0 : -1.0;
}

// How far the control points are from the points, and what is known of them.
struct SolutionSizes {
    DoublePair sum{};  ///< finite where all are
    DoublePair away{};
    DoublePair reach{};
    DoublePair largest{};

    void include(DoublePair x, DoublePair y, const Sides<DoublePair>& unknown) {
        sum += x + y;
        away = larger(away, larger(size_of(unknown.x), size_of(unknown.y)));
        reach = larger(reach, size_of(unknown.reach));
        largest = larger(largest, larger(size_of(x), size_of(y)));
    }

    bool are_sharp() const {
        const auto greater = [](DoublePair pair) { return std::max(pair[0], pair[1]); };
        return std::isfinite(sum[0] + sum[1]) && greater(reach) * greater(away) <= most_roundings * greater(largest);
    }
};

class CubicSolver {
  public:
    explicit CubicSolver(const CubicCollocation& given)
        : given_(given), n_(given.sites.size()), half_(n_ / 2), pairs_(half_) {
        assert(n_ >= 2 * band);
    }

    std::optional<std::vector<Point>> solve() {
        Front<DoublePair> front;
        for (std::size_t from = 0; from < half_; from += RowBlock::capacity)
            eliminate_pairs(from, std::min(RowBlock::capacity, half_ - from), front);
        return substituted_from(middle_after(front));
    }

  private:
    // The unknowns from two before the halves meet to two after it.
    using Middle = std::vector<Sides<double>>;

    std::size_t mirrored(std::size_t r) const { return n_ - 1 - r; }
    bool has_middle() const { return n_ % 2 == 1; }

    void eliminate_pairs(std::size_t from, std::size_t count, Front<DoublePair>& front) {
        const RowBlock rows(given_, from, count);
        const RowBlock mirror(given_, n_ - from - count, count);
        Front<DoublePair> last = front;
        DoublePair reach{sign_of(from), sign_of(mirrored(from))};
        for (std::size_t r = from; r < from + count; ++r) {
            const std::size_t q = mirrored(r);
            OpenRow<DoublePair> row;
            for (std::size_t j = 0; j <= 2 * band; ++j)
                row.coefficients[j] = DoublePair{rows.coefficient(r, j), mirror.coefficient(q, 2 * band - j)};
            row.right = {DoublePair{rows.x(r), mirror.x(q)}, DoublePair{rows.y(r), mirror.y(q)}, reach};
            pairs_.values()[r] = eliminated(row, last);
            reach = -reach;
        }
        front = last;
    }

    // On from the front, over the row between the halves where there is one, to the first rows reached from the back.
    Middle middle_after(const Front<DoublePair>& pairs) const {
        Front<double> front{in_front(pairs.second), in_front(pairs.first), pairs.numerator[0], pairs.pivot[0]};
        std::vector<SolvedRow<double>> rows{front.second, front.first};
        if (has_middle()) rows.push_back(eliminated(row_at(half_), front));
        for (const SolvedRow<DoublePair>* const pair : {&pairs.first, &pairs.second})
            rows.push_back(eliminated(in_back(*pair), front));
        Middle middle(rows.size() + band, Sides<double>{});
        for (std::size_t k = rows.size(); k-- > 0;) middle[k] = substituted(rows[k], middle[k + 1], middle[k + 2]);
        middle.resize(rows.size());
        return middle;
    }

    OpenRow<double> row_at(std::size_t r) const {
        const RowBlock block(given_, r, 1);
        OpenRow<double> row{{}, {block.x(r), block.y(r), sign_of(r)}};
        for (std::size_t j = 0; j <= 2 * band; ++j) row.coefficients[j] = block.coefficient(r, j);
        return row;
    }

    static SolvedRow<double> in_front(const SolvedRow<DoublePair>& rows) {
        return {{rows.after[0][0], rows.after[1][0]}, {rows.right.x[0], rows.right.y[0], rows.right.reach[0]}};
    }

    // Seen from the front what comes after in the mirror comes before.
    static OpenRow<double> in_back(const SolvedRow<DoublePair>& rows) {
        return {{rows.after[1][1], rows.after[0][1], 1.0, 0.0, 0.0},
                {rows.right.x[1], rows.right.y[1], rows.right.reach[1]}};
    }

    std::optional<std::vector<Point>> substituted_from(const Middle& middle) const {
        std::vector<Point> points(n_);
        SolutionSizes sizes;
        if (has_middle()) place(points, half_, both(middle[band], middle[band]), sizes);
        const std::size_t last = middle.size() - 1;
        Sides<DoublePair> next = both(middle[band], middle[last - band]);
        Sides<DoublePair> after_next = both(middle[band + 1], middle[last - band - 1]);
        for (std::size_t r = half_; r-- > 0;) {
            const Sides<DoublePair> unknown = substituted(pairs_.values()[r], next, after_next);
            after_next = next;
            next = unknown;
            place(points, r, unknown, sizes);
        }
        if (!sizes.are_sharp()) return std::nullopt;
        return points;
    }

    static Sides<DoublePair> both(const Sides<double>& a, const Sides<double>& b) {
        return {DoublePair{a.x, b.x}, DoublePair{a.y, b.y}, DoublePair{a.reach, b.reach}};
    }

    void place(std::vector<Point>& points, std::size_t r, const Sides<DoublePair>& unknown,
               SolutionSizes& sizes) const {
        const std::size_t q = mirrored(r);
        const DoublePair x = DoublePair{given_.points[r].x, given_.points[q].x} + unknown.x;
        const DoublePair y = DoublePair{given_.points[r].y, given_.points[q].y} + unknown.y;
        points[r] = {x[0], y[0]};
        points[q] = {x[1], y[1]};
        sizes.include(x, y, unknown);
    }

    const CubicCollocation& given_;
    std::size_t n_;
    std::size_t half_;
    NewArray<SolvedRow<DoublePair>> pairs_;
};

}  // namespace

std::optional<std::vector<Point>> collocated(const CubicCollocation& given) {
    return CubicSolver(given).solve();
}

}  // namespace batten::core
