#include "core/evaluate/lifted.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/curve/detail/bspline.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

constexpr int least_depth = 2;
constexpr int greatest_depth = 12;

using Runs = std::vector<std::vector<LiftedSample>>;

class LiftedSampler {
  public:
    LiftedSampler(const Curve& curve, const LiftView& view, double tolerance)
        : curve_(curve), view_(view), tolerance_(tolerance) {}

    void add_span(std::size_t span) {
        const KnotVector& knots = curve_.knots();
        const bool is_torn = knots[span - static_cast<std::size_t>(curve_.degree())] == knots[span];
        const LiftedSample first = lifted_at(curve_, knots[span]);
        if (runs_.empty() || is_torn) runs_.push_back({first});
        add_chord(first, lifted_at(curve_, knots[span + 1], Side::left), 0);
    }

    Runs take_runs() { return std::move(runs_); }

  private:
    glm::dvec3 place(const LiftedSample& sample) const { return view_.place(sample.point, sample.weight); }

    void add_chord(const LiftedSample& from, const LiftedSample& to, int depth) {
        const LiftedSample half = lifted_at(curve_, from.u + 0.5 * (to.u - from.u));
        const bool is_divisible = depth < greatest_depth && from.u < half.u && half.u < to.u;
        const double distance = glm::distance(place(half), 0.5 * (place(from) + place(to)));
        if (is_divisible && (depth < least_depth || distance > tolerance_)) {
            add_chord(from, half, depth + 1);
            add_chord(half, to, depth + 1);
        } else {
            runs_.back().push_back(to);
        }
    }

    const Curve& curve_;
    const LiftView& view_;
    double tolerance_;
    Runs runs_;
};

}  // namespace

glm::dvec3 LiftView::place(Point shadow, double weight) const {
    const double height = exponent == 1.0 ? weight : std::pow(weight, exponent);
    return height * glm::dvec3((shadow.x - apex.x) / unit, (shadow.y - apex.y) / unit, 1.0);
}

double LiftView::weight_at(double height) const {
    return exponent == 1.0 ? height : std::pow(height, 1.0 / exponent);
}

LiftView lift_view(const Box& box, Interval weights) {
    assert(!box.is_empty() && weights.lower > 0.0);
    LiftView view{.apex = middle(box.lower, box.upper)};
    const double half = std::max(0.5 * box.upper.x - 0.5 * box.lower.x, 0.5 * box.upper.y - 0.5 * box.lower.y);
    if (half > 0.0) view.unit = std::min(2.0 * half, std::numeric_limits<double>::max());
    const double extreme = std::max(std::abs(std::log(weights.lower)), std::abs(std::log(weights.upper)));
    if (extreme > std::log(greatest_lift)) view.exponent = std::log(greatest_lift) / extreme;
    return view;
}

LiftedSample lifted_at(const Curve& curve, double u, Side side) {
    const Location location = located(curve.knots(), u, side);
    LocalPoints<double> weights;
    const std::size_t n = curve.control_points().size();
    for (std::size_t j = 0; j <= location.at.p; ++j)
        weights[j] = curve.weights()[(location.at.s - location.at.p + j) % n];
    return {location.u, point_at(curve, u, side), de_boor(weights, location.at, location.u)};
}

Runs lifted_samples(const Curve& curve, const LiftView& view, LiftedFineness fineness) {
    assert(fineness.tolerance > 0.0 && fineness.most_spans > 0);
    const KnotVector& knots = curve.knots();
    const auto first = static_cast<std::size_t>(curve.degree());
    const std::size_t end = knots.size() - first - 1;
    const std::size_t spans = end - first;
    if (spans > fineness.most_spans) {
        Runs runs(1);
        for (std::size_t k = 0; k <= fineness.most_spans; ++k)
            runs[0].push_back(lifted_at(curve, knots[first + k * spans / fineness.most_spans]));
        return runs;
    }
    LiftedSampler sampler(curve, view, fineness.tolerance);
    for (std::size_t span = first; span < end; ++span)
        if (knots[span] < knots[span + 1]) sampler.add_span(span);
    return sampler.take_runs();
}

}  // namespace batten::core
