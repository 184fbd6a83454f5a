#include "core/edit/knot_merging.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/detail/edit_checks.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

// Equal knots side by side.
struct Run {
    double value = 0.0;
    std::size_t count = 0;
};

std::vector<Run> runs_within(std::span<const double> knots, Interval domain) {
    std::vector<Run> runs;
    for (const double knot : knots) {
        if (!domain.contains(knot)) continue;
        if (runs.empty() || runs.back().value != knot) runs.push_back({knot, 0});
        ++runs.back().count;
    }
    return runs;
}

// What merges knots of one curve: where its ends are, and how many knots may be equal.
class Merger {
  public:
    Merger(const Curve& curve, double tolerance)
        : knots_(curve.knots()),
          domain_(curve.domain()),
          reach_(tolerance * domain_.length()),
          seam_multiplicity_(static_cast<std::size_t>(knots_.multiplicity(domain_.lower))) {}

    // One value for each run, in their order.
    std::vector<double> targets(std::span<const Run> runs) {
        std::vector<double> values;
        for (std::size_t first = 0; first < runs.size();) {
            std::size_t end = first + 1;
            while (end < runs.size() && may_join(runs.subspan(first, end + 1 - first))) ++end;
            const double value = common_value(runs.subspan(first, end - first));
            values.insert(values.end(), end - first, value);
            if (value == domain_.lower)
                for (std::size_t i = first + 1; i < end; ++i) seam_multiplicity_ += runs[i].count;
            first = end;
        }
        return values;
    }

  private:
    bool is_end(double u) const { return u == domain_.lower || u == domain_.upper; }

    std::size_t most_equal(double u) const {
        const auto p = static_cast<std::size_t>(knots_.degree());
        return is_end(u) && !knots_.is_periodic() ? p + 1 : p;
    }

    bool may_join(std::span<const Run> runs) const {
        if (runs.back().value - runs.front().value > reach_) return false;
        if (runs.front().value == domain_.lower && runs.back().value == domain_.upper) return false;
        std::size_t count = 0;
        for (const Run& run : runs) count += run.count;
        // A seam has knots at both ends of the period, one of them twice.
        if (knots_.is_periodic() && is_end(common_value(runs))) {
            const Run& end = runs.front().value == domain_.lower ? runs.front() : runs.back();
            count += seam_multiplicity_ - end.count;
        }
        return count <= most_equal(common_value(runs));
    }

    double common_value(std::span<const Run> runs) const {
        if (runs.front().value == domain_.lower) return domain_.lower;
        if (runs.back().value == domain_.upper) return domain_.upper;
        return std::max_element(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.count < b.count; })
            ->value;
    }

    const KnotVector& knots_;
    Interval domain_;
    double reach_;
    std::size_t seam_multiplicity_;  // as merged so far
};

}  // namespace

Result<KnotMerging> merge_knots(const Curve& curve, double tolerance) {
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    const std::vector<Run> runs = runs_within(curve.knots().stored(), curve.domain());
    const std::vector<double> targets = Merger(curve, tolerance).targets(runs);
    CurveDefinition definition = curve.definition();
    int count = 0;
    std::size_t run = 0;
    for (double& knot : definition.knots) {
        if (!curve.domain().contains(knot)) continue;
        if (knot != runs[run].value) ++run;
        if (knot != targets[run]) ++count;
        knot = targets[run];
    }
    return Curve::make(std::move(definition)).map([&](const Curve& merged) {
        return KnotMerging{merged, count, largest_deviation(curve, merged)};
    });
}

}  // namespace batten::core
