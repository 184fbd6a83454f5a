#include "core/evaluate/polygon_strips.h"

#include <cassert>

namespace batten::core {

namespace {

// Halves the polygon through `corners` as far as needed; `along` goes on by its length.
void add_legs(const std::vector<Point>& corners, double tolerance, RunCollector& runs, double& along) {
    const Strip strip = strip_of(corners);
    if (corners.size() == 2) runs.add(strip.first, strip.last, along);
    if (corners.size() == 2 || add_if_simple(strip, tolerance, runs, along)) {
        along += strip.length;
        return;
    }
    const auto half = corners.begin() + static_cast<std::ptrdiff_t>(corners.size() / 2);
    add_legs({corners.begin(), half + 1}, tolerance, runs, along);
    add_legs({half, corners.end()}, tolerance, runs, along);
}

}  // namespace

PolygonStrips::PolygonStrips(std::shared_ptr<const Curve> curve) : curve_(std::move(curve)) {
    std::vector<Strip> stretches;
    const std::size_t legs = corner_count() - 1;
    for (std::size_t i = 0; i * legs_per_stretch < legs; ++i) stretches.push_back(strip_of_stretch(i));
    tree_ = StripTree(std::move(stretches));
}

std::vector<Point> PolygonStrips::corners_of(std::size_t stretch) const {
    const std::size_t first = stretch * legs_per_stretch;
    const std::size_t last = std::min(first + legs_per_stretch, corner_count() - 1);
    std::vector<Point> corners;
    corners.reserve(last - first + 1);
    for (std::size_t i = first; i <= last; ++i) corners.push_back(corner(i));
    return corners;
}

Strip PolygonStrips::strip_of_stretch(std::size_t stretch) {
    ++stretch_count_;
    return strip_of(corners_of(stretch));
}

RunCollector PolygonStrips::search(const StripRequest& request, const StripTolerance& tolerance) const {
    RunCollector runs(request.most_places);
    double along = 0.0;
    tree_.visit(
        [&](const Strip& strip, std::size_t first, std::size_t last) {
            if (runs.is_full()) return false;
            const double near = tolerance.of(last + 1 - first);
            if (strip.box.intersects(request.view) && !add_if_simple(strip, near, runs, along)) return true;
            along += strip.length;
            return false;
        },
        [&](std::size_t stretch) { add_legs(corners_of(stretch), tolerance.of_single(), runs, along); });
    return runs;
}

PolygonRuns PolygonStrips::runs(const StripRequest& request) const {
    assert(request.tolerance > 0.0);
    constexpr double nothing_left_out = -1.0;
    RunCollector runs = search(request, {nothing_left_out, false});
    if (runs.is_full())
        runs =
            runs_within(request.tolerance, [&](const StripTolerance& tolerance) { return search(request, tolerance); });
    return {runs.take(), runs.take_starts()};
}

void PolygonStrips::follow(std::shared_ptr<const Curve> curve) {
    if (curve == curve_) return;
    const auto points = curve_->control_points();
    const auto others = curve->control_points();
    const bool is_alike = points.size() == others.size() && curve->is_periodic() == curve_->is_periodic();
    if (!is_alike) {
        const std::size_t count = stretch_count_;
        *this = PolygonStrips(std::move(curve));
        stretch_count_ += count;
        return;
    }
    std::vector<std::size_t> changed;
    const auto note = [&](std::size_t leg) {
        const std::size_t stretch = leg / legs_per_stretch;
        if (changed.empty() || changed.back() != stretch) changed.push_back(stretch);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] == others[i]) continue;
        if (i > 0) note(i - 1);
        if (i + 1 < corner_count()) note(i);
        if (i == 0 && curve_->is_periodic()) note(corner_count() - 2);
    }
    curve_ = std::move(curve);
    for (const std::size_t stretch : changed) tree_.replace(stretch, strip_of_stretch(stretch));
}

}  // namespace batten::core
