#include "app/editor/state/point_hues.h"

#include <algorithm>
#include <utility>

#include "app/editor/state/point_origins.h"

namespace batten::editor {

namespace {

using Hues = std::vector<std::uint8_t>;

constexpr std::uint8_t no_hue = hue_count;

void fill_gaps(Hues& hues, std::size_t old_count) {
    std::size_t next = old_count;
    for (std::size_t i = 0; i < hues.size(); ++i) {
        if (hues[i] != no_hue) continue;
        const std::size_t first = i > hue_neighbors ? i - hue_neighbors : 0;
        const std::size_t end = std::min(hues.size(), i + hue_neighbors + 1);
        hues[i] = static_cast<std::uint8_t>(free_hue(std::span(hues).subspan(first, end - first), next++));
    }
}

/// The colors of `points`, which came of the curve of `before` and have these origins there.
Hues hues_after(const core::DocumentCurve& before, const PointOrigins& origins) {
    Hues hues;
    for (const std::optional<std::size_t>& origin : origins)
        hues.push_back(origin ? static_cast<std::uint8_t>(point_hue(before, *origin)) : no_hue);
    fill_gaps(hues, before.curve->control_points().size());
    return hues;
}

/// The pinned points among those with these origins.
std::vector<std::size_t> pinned_after(const core::DocumentCurve& before, const PointOrigins& origins) {
    std::vector<std::size_t> pinned;
    for (std::size_t i = 0; i < origins.size(); ++i)
        if (origins[i] && std::ranges::binary_search(before.pinned, *origins[i])) pinned.push_back(i);
    return pinned;
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
    if (curve->control_points().size() != entry.curve->control_points().size()) {
        const PointOrigins origins = point_origins(*entry.curve, *curve);
        entry.point_hues = std::make_shared<const Hues>(hues_after(entry, origins));
        entry.pinned = pinned_after(entry, origins);
    }
    entry.curve = std::move(curve);
    entry.fit.reset();
}

}  // namespace batten::editor
