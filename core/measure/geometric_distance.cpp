#include "core/measure/geometric_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/detail/difference_piece.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

constexpr std::size_t most_differing_spans = 1000;
constexpr std::size_t most_halved_pairs = 400;
constexpr double pair_looseness = 0.01;

// What is less than this part of the deviation is not halved on for a smaller bound.
constexpr double negligible_part_of_deviation = 1e-3;

constexpr int nearest_samples = 8;
constexpr int golden_steps = 24;

// The parameter in `part` of the point nearest to `query`, as samples find it. Any parameter makes a bound, the nearest
// the smallest.
double nearest_parameter(const Curve& curve, Interval part, Point query) {
    const auto distance_at = [&](double u) { return distance(point_at(curve, u), query); };
    const double step = part.length() / nearest_samples;
    double best = part.lower;
    double least = distance_at(best);
    for (int k = 1; k <= nearest_samples; ++k) {
        const double u = k == nearest_samples ? part.upper : part.lower + k * step;
        if (const double found = distance_at(u); found < least) {
            least = found;
            best = u;
        }
    }
    constexpr double golden = 0.6180339887498949;
    Interval bracket{part.clamp(best - step), part.clamp(best + step)};
    for (int k = 0; k < golden_steps; ++k) {
        const double low = bracket.upper - golden * bracket.length();
        const double high = bracket.lower + golden * bracket.length();
        if (distance_at(low) < distance_at(high))
            bracket.upper = high;
        else
            bracket.lower = low;
    }
    const double found = middle(bracket);
    return distance_at(found) < least ? found : best;
}

// Parts of both curves that are passed through together; their ends are matched.
struct PiecePair {
    double bound = 0.0;
    CommonSpan parts;
};

double size_of_part(const Curve& curve, Interval part) {
    const Point half = point_at(curve, middle(part));
    return distance(point_at(curve, part.lower), half) + distance(half, point_at(curve, part.upper, Side::left));
}

class PassingTogether {
  public:
    PassingTogether(const Curve& a, const Curve& b) : a_(a), b_(b) {}

    // The parts of a run of spans in which the curves differ.
    void add_run(std::span<const CommonSpan> run) {
        double matched = run.front().part_of_b.lower;
        for (std::size_t k = 0; k < run.size(); ++k) {
            const double from = matched;
            const CommonSpan& here = run[k];
            matched = here.part_of_b.upper;
            if (k + 1 < run.size())
                matched = nearest_parameter(b_, {from, run[k + 1].part_of_b.upper}, point_at(a_, here.part_of_a.upper));
            add_across_knots(here, {from, matched});
        }
    }

    double run(double least) {
        for (std::size_t count = 0; !pairs_.empty() && count < most_halved_pairs; ++count) {
            if (pairs_.front().bound <= std::max((1.0 + pair_looseness) * found_, least)) break;
            std::pop_heap(pairs_.begin(), pairs_.end(), is_nearer);
            const CommonSpan parts = pairs_.back().parts;
            pairs_.pop_back();
            halve(parts);
        }
        return pairs_.empty() ? found_ : std::max(found_, pairs_.front().bound);
    }

  private:
    static bool is_nearer(const PiecePair& x, const PiecePair& y) { return x.bound < y.bound; }

    // The part of `a` in one span with the part of `b` matched to it, which may have knots inside.
    void add_across_knots(const CommonSpan& here, Interval part_of_b) {
        const KnotVector& knots = b_.knots();
        double from_a = here.part_of_a.lower;
        double from_b = part_of_b.lower;
        std::size_t s = knots.span_at(from_b);
        for (; knots[s + 1] < part_of_b.upper; s = knots.span_at(from_b)) {
            const double knot = knots[s + 1];
            const double to_a = nearest_parameter(a_, {from_a, here.part_of_a.upper}, point_at(b_, knot));
            add({here.span_of_a, s, {from_a, to_a}, {from_b, knot}});
            from_a = to_a;
            from_b = knot;
        }
        add({here.span_of_a, s, {from_a, here.part_of_a.upper}, {from_b, part_of_b.upper}});
    }

    void add(const CommonSpan& parts) {
        const DifferencePiece piece = difference_piece(a_, b_, parts, Precision::plain);
        found_ = std::max(found_, piece.distance_at_ends());
        pairs_.push_back({piece.bound(), parts});
        std::push_heap(pairs_.begin(), pairs_.end(), is_nearer);
    }

    // At the middle of the larger part, matched with the nearest point of the other.
    void halve(const CommonSpan& parts) {
        const bool halves_a = size_of_part(a_, parts.part_of_a) >= size_of_part(b_, parts.part_of_b);
        const double half = middle(halves_a ? parts.part_of_a : parts.part_of_b);
        const double of_a = halves_a ? half : nearest_parameter(a_, parts.part_of_a, point_at(b_, half));
        const double of_b = halves_a ? nearest_parameter(b_, parts.part_of_b, point_at(a_, half)) : half;
        add({parts.span_of_a, parts.span_of_b, {parts.part_of_a.lower, of_a}, {parts.part_of_b.lower, of_b}});
        add({parts.span_of_a, parts.span_of_b, {of_a, parts.part_of_a.upper}, {of_b, parts.part_of_b.upper}});
    }

    const Curve& a_;
    const Curve& b_;
    std::vector<PiecePair> pairs_;
    double found_ = 0.0;
};

// The differing parts that follow each other without another between.
std::vector<std::vector<CommonSpan>> runs_of(const std::vector<CommonSpan>& parts) {
    std::vector<std::vector<CommonSpan>> runs;
    for (const CommonSpan& part : parts) {
        const bool continues = !runs.empty() && runs.back().back().part_of_a.upper == part.part_of_a.lower &&
                               runs.back().back().part_of_b.upper == part.part_of_b.lower;
        if (!continues) runs.emplace_back();
        runs.back().push_back(part);
    }
    return runs;
}

}  // namespace

double geometric_distance(const Curve& a, const Curve& b) {
    const double deviation = largest_deviation(a, b);
    const std::vector<CommonSpan> parts = differing_spans(a, b);
    if (parts.size() > most_differing_spans || !std::isfinite(deviation)) return deviation;
    PassingTogether passing(a, b);
    for (const auto& run : runs_of(parts)) passing.add_run(run);
    return std::min(deviation, passing.run(negligible_part_of_deviation * deviation));
}

}  // namespace batten::core
