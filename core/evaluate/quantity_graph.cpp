#include "core/evaluate/quantity_graph.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/detail/unit_interval.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

// Steps in a span, at the least where each has a run of its own.
constexpr std::size_t least_steps = 4;
constexpr std::size_t most_steps = 200;

class GraphMaker {
  public:
    GraphMaker(const Curve& curve, Quantity quantity) : curve_(curve), quantity_(quantity) {}

    void add(double u, Side side) {
        if (const auto value = quantity_at(curve_, quantity_, u, side))
            run_.push_back({u, *value});
        else
            end_run();
    }

    // The ends as the inside sees them.
    void add_evenly(Interval interval, std::size_t steps) {
        for (std::size_t k = 0; k <= steps; ++k)
            add(from_unit(interval, static_cast<double>(k) / static_cast<double>(steps)),
                k == steps ? Side::left : Side::right);
        end_run();
    }

    void end_run() {
        if (!run_.empty()) runs_.push_back(std::move(run_));
        run_.clear();
    }

    std::vector<GraphRun> take() { return std::move(runs_); }

  private:
    const Curve& curve_;
    Quantity quantity_;
    GraphRun run_;
    std::vector<GraphRun> runs_;
};

}  // namespace

std::optional<double> quantity_at(const Curve& curve, Quantity quantity, double u, Side side) {
    if (quantity == Quantity::curvature) return curvature_at(curve, u, side);
    const double speed = robust_length(derivatives_at(curve, u, 1, side)[1]);
    return std::isfinite(speed) ? std::optional(speed) : std::nullopt;
}

std::vector<GraphRun> quantity_graph(const Curve& curve, Quantity quantity, Interval range, std::size_t most) {
    assert(most >= 1);
    const KnotVector& knots = curve.knots();
    const Interval domain = curve.domain();
    const Interval shown{std::max(range.lower, domain.lower), std::min(range.upper, domain.upper)};
    if (!(shown.lower < shown.upper)) return {};
    GraphMaker graph(curve, quantity);
    const std::size_t first = knots.span_at(shown.lower);
    const std::size_t last = knots.span_at(shown.upper, Side::left);
    const std::size_t steps = most / (last - first + 1);
    if (steps < least_steps && first < last) {
        graph.add_evenly(shown, most);
        return graph.take();
    }
    for (std::size_t s = first; s <= last; ++s)
        if (knots[s] < knots[s + 1])
            graph.add_evenly({std::max(knots[s], shown.lower), std::min(knots[s + 1], shown.upper)},
                             std::clamp(steps, least_steps, most_steps));
    return graph.take();
}

}  // namespace batten::core
