#include "app/editor/state/point_origins.h"

#include <algorithm>
#include <cmath>

#include "core/curve/knot_analysis.h"

namespace batten::editor {

namespace {

/// The points of a curve that have to be matched with others.
struct Part {
    const core::Curve& curve;
    std::size_t first;
    std::size_t count;

    double abscissa(std::size_t k) const { return core::greville_abscissa(curve.knots(), first + k); }
};

/// For each point of `few` its partner of `many`, the nearest one that leaves enough for the others; ascending.
std::vector<std::size_t> partners(const Part& few, const Part& many) {
    std::vector<std::size_t> chosen;
    chosen.reserve(few.count);
    std::size_t next = 0;
    for (std::size_t k = 0; k < few.count; ++k) {
        const double wanted = few.abscissa(k);
        const std::size_t last = many.count - (few.count - k);
        while (next < last && std::abs(many.abscissa(next + 1) - wanted) < std::abs(many.abscissa(next) - wanted))
            ++next;
        chosen.push_back(next++);
    }
    return chosen;
}

}  // namespace

PointOrigins point_origins(const core::Curve& before, const core::Curve& after) {
    const auto old_points = before.control_points();
    const auto points = after.control_points();
    const std::size_t fewer = std::min(old_points.size(), points.size());
    const auto begins = static_cast<std::size_t>(std::ranges::mismatch(old_points, points).in1 - old_points.begin());
    std::size_t ends = 0;
    while (ends < fewer - begins && old_points[old_points.size() - 1 - ends] == points[points.size() - 1 - ends])
        ++ends;

    PointOrigins origins(points.size());
    for (std::size_t i = 0; i < begins; ++i) origins[i] = i;
    for (std::size_t i = 1; i <= ends; ++i) origins[points.size() - i] = old_points.size() - i;
    const Part old_part{before, begins, old_points.size() - begins - ends};
    const Part part{after, begins, points.size() - begins - ends};
    const bool is_more = part.count >= old_part.count;
    const std::vector<std::size_t> found = is_more ? partners(old_part, part) : partners(part, old_part);
    for (std::size_t k = 0; k < found.size(); ++k)
        origins[begins + (is_more ? found[k] : k)] = begins + (is_more ? k : found[k]);
    return origins;
}

}  // namespace batten::editor
