#include "core/make/detail/knots_by_need.h"

#include <queue>

#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// Spans that have become one, with the mean of their third derivatives.
struct MergedSpans {
    double length = 0.0;
    Vector third{};
};

// What is lost where two runs become one.
double loss(const MergedSpans& a, const MergedSpans& b) {
    const double shared = a.length * b.length;
    return length(b.third - a.third) * shared * shared / (a.length + b.length);
}

MergedSpans joined(const MergedSpans& a, const MergedSpans& b) {
    const double whole = a.length + b.length;
    return {whole, (a.length / whole) * a.third + (b.length / whole) * b.third};
}

struct Candidate {
    double loss;
    std::size_t break_index;
    std::size_t version;  // of the runs beside it

    bool operator<(const Candidate& other) const {
        return loss > other.loss || (loss == other.loss && break_index > other.break_index);
    }
};

// A place between two runs.
struct Meeting {
    double knot = 0.0;
    bool is_free = false;
    std::size_t before = 0;  // the breaks beside it that are left
    std::size_t after = 0;
    std::size_t version = 0;
};

std::vector<Meeting> breaks_of(const Curve& curve) {
    const Interval domain = curve.domain();
    std::vector<Meeting> breaks;
    for (const double knot : curve.knots().stored()) {
        if (!breaks.empty() && breaks.back().knot == knot) {
            breaks.back().is_free = false;
            continue;
        }
        const std::size_t k = breaks.size();
        breaks.push_back({.knot = knot,
                          .is_free = domain.lower < knot && knot < domain.upper,
                          .before = k == 0 ? 0 : k - 1,
                          .after = k + 1});
    }
    return breaks;
}

}  // namespace

std::vector<double> knots_by_need(const Curve& curve) {
    std::vector<Meeting> breaks = breaks_of(curve);
    std::vector<MergedSpans> runs;  // run k lies behind break k
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const double a = breaks[k].knot;
        const double b = breaks[k + 1].knot;
        runs.push_back({b - a, derivatives_at(curve, a + 0.5 * (b - a), 3)[3]});
    }
    std::priority_queue<Candidate> queue;
    const auto offer = [&](std::size_t k) {
        if (breaks[k].is_free) queue.push({loss(runs[breaks[k].before], runs[k]), k, breaks[k].version});
    };
    for (std::size_t k = 0; k < breaks.size(); ++k) offer(k);
    std::vector<double> order;
    while (!queue.empty()) {
        const Candidate next = queue.top();
        queue.pop();
        Meeting& gone = breaks[next.break_index];
        if (!gone.is_free || next.version != gone.version) continue;
        gone.is_free = false;
        order.push_back(gone.knot);
        runs[gone.before] = joined(runs[gone.before], runs[next.break_index]);
        breaks[gone.before].after = gone.after;
        breaks[gone.after].before = gone.before;
        for (const std::size_t beside : {gone.before, gone.after}) {
            ++breaks[beside].version;
            offer(beside);
        }
    }
    return order;
}

}  // namespace batten::core
