#include "app/editor/scene/plot_intervals.h"

#include <algorithm>
#include <cmath>

namespace batten::editor {

std::vector<PlotInterval> plot_intervals(const core::KnotVector& knots, core::Interval range, double width_px,
                                         double spacing_px) {
    const core::Interval shown{std::max(range.lower, knots.domain().lower),
                               std::min(range.upper, knots.domain().upper)};
    if (!(shown.lower < shown.upper)) return {};
    const std::size_t first = knots.span_at(shown.lower);
    const std::size_t last = knots.span_at(shown.upper, core::Side::left);
    if (static_cast<double>(last - first) > width_px / spacing_px) return {};
    std::vector<PlotInterval> intervals;
    for (std::size_t s = first; s <= last; ++s) {
        const core::Interval part{std::max(knots[s], shown.lower), std::min(knots[s + 1], shown.upper)};
        if (!(part.lower < part.upper)) continue;
        const double share = part.length() / range.length();
        const int count = std::max(1, static_cast<int>(std::ceil(share * width_px / spacing_px)));
        double lower = part.lower;
        for (int k = 1; k <= count; ++k) {
            const double upper = k == count ? part.upper : part.lower + part.length() * k / count;
            intervals.push_back({{lower, upper}, s});
            lower = upper;
        }
    }
    return intervals;
}

}  // namespace batten::editor
