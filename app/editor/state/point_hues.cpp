#include "app/editor/state/point_hues.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/curve/knot_analysis.h"

namespace batten::editor {

namespace {

using Hues = std::vector<std::uint8_t>;

constexpr std::uint8_t no_hue = hue_count;

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

void fill_gaps(Hues& hues, std::size_t old_count) {
    std::size_t next = old_count;
    for (std::size_t i = 0; i < hues.size(); ++i) {
        if (hues[i] != no_hue) continue;
        const std::size_t first = i > hue_neighbors ? i - hue_neighbors : 0;
        const std::size_t end = std::min(hues.size(), i + hue_neighbors + 1);
        hues[i] = static_cast<std::uint8_t>(free_hue(std::span(hues).subspan(first, end - first), next++));
    }
}

/// The colors of the points of `after`, which came of the curve of `before` and has another number of them.
Hues hues_after(const core::DocumentCurve& before, const core::Curve& after) {
    const auto old_points = before.curve->control_points();
    const auto points = after.control_points();
    const std::size_t fewer = std::min(old_points.size(), points.size());
    const auto begins = static_cast<std::size_t>(std::ranges::mismatch(old_points, points).in1 - old_points.begin());
    std::size_t ends = 0;
    while (ends < fewer - begins && old_points[old_points.size() - 1 - ends] == points[points.size() - 1 - ends])
        ++ends;

    Hues hues(points.size(), no_hue);
    const auto keep = [&](std::size_t from, std::size_t to) {
        hues[to] = static_cast<std::uint8_t>(point_hue(before, from));
    };
    for (std::size_t i = 0; i < begins; ++i) keep(i, i);
    for (std::size_t i = 1; i <= ends; ++i) keep(old_points.size() - i, points.size() - i);
    const Part old_part{*before.curve, begins, old_points.size() - begins - ends};
    const Part part{after, begins, points.size() - begins - ends};
    const bool is_more = part.count >= old_part.count;
    const std::vector<std::size_t> found = is_more ? partners(old_part, part) : partners(part, old_part);
    for (std::size_t k = 0; k < found.size(); ++k)
        keep(begins + (is_more ? k : found[k]), begins + (is_more ? found[k] : k));
    fill_gaps(hues, old_points.size());
    return hues;
}

}  // namespace

std::size_t free_hue(std::span<const std::uint8_t> near, std::size_t start) {
    for (std::size_t k = 0; k < hue_count; ++k)
        if (std::ranges::find(near, (start + k) % hue_count) == near.end()) return (start + k) % hue_count;
    return start % hue_count;
}

std::size_t point_hue(const core::DocumentCurve& entry, std::size_t i) {
    const bool has_hues = entry.point_hues != nullptr && i < entry.point_hues->size();
    return has_hues ? (*entry.point_hues)[i] : i % hue_count;
}

void replace_curve(core::DocumentCurve& entry, std::shared_ptr<const core::Curve> curve) {
    if (curve->control_points().size() != entry.curve->control_points().size())
        entry.point_hues = std::make_shared<const Hues>(hues_after(entry, *curve));
    entry.curve = std::move(curve);
}

}  // namespace batten::editor
