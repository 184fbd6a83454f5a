#include "core/evaluate/polygon_strips.h"

#include <algorithm>
#include <cassert>
#include <utility>

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

PolygonStrips::PolygonStrips(std::shared_ptr<const Curve> curve)
    : curve_(std::move(curve)), stretch_legs_({0, corner_count() - 1}) {
    std::vector<Strip> stretches;
    for (std::size_t i = 0; i < stretch_legs_.size(); ++i) stretches.push_back(strip_of_stretch(i));
    tree_ = StripTree(std::move(stretches));
}

std::vector<Point> PolygonStrips::corners_of(std::size_t stretch) const {
    const ItemRange legs = stretch_legs_[stretch];
    std::vector<Point> corners;
    corners.reserve(legs.size() + 1);
    for (std::size_t i = legs.first; i <= legs.end; ++i) corners.push_back(corner(i));
    return corners;
}

Strip PolygonStrips::strip_of_stretch(std::size_t stretch) {
    ++stretch_count_;
    return strip_of(corners_of(stretch));
}

RunCollector PolygonStrips::search(const StripRequest& request, double tolerance) const {
    RunCollector runs(request.most_places);
    double along = 0.0;
    tree_.visit(
        [&](const Strip& strip, std::size_t, std::size_t) {
            if (runs.is_full()) return false;
            if (strip.box.intersects(request.view) && !add_if_simple(strip, tolerance, runs, along)) return true;
            along += strip.length;
            return false;
        },
        [&](std::size_t stretch) { add_legs(corners_of(stretch), tolerance, runs, along); });
    return runs;
}

std::optional<PolygonRuns> PolygonStrips::runs(const StripRequest& request) const {
    assert(request.tolerance > 0.0);
    constexpr double nothing_left_out = -1.0;
    RunCollector runs = search(request, nothing_left_out);
    if (runs.is_full()) runs = search(request, request.tolerance);
    if (runs.is_full()) return std::nullopt;
    return PolygonRuns{runs.take(), runs.take_starts()};
}

void PolygonStrips::visit_chords(const ChordRequest& request, std::span<const std::size_t> left_out) const {
    assert(request.tolerance > 0.0);
    const auto enter = [&](const Strip& strip, std::size_t first, std::size_t last) {
        if (!is_seen(strip, request)) return false;
        const ItemRange legs = stretch_legs_.items(first, last);
        if (strip.deviation > request.tolerance || has_any(left_out, legs.first, legs.end - 1)) return true;
        request.take(strip.first, strip.last);
        return false;
    };
    tree_.visit_scattered(enter, [&](std::size_t stretch) {
        const ItemRange legs = stretch_legs_[stretch];
        for (std::size_t leg = legs.first; leg < legs.end; ++leg)
            if (!has_any(left_out, leg, leg)) visit_leg_chord(request, leg);
    });
}

void PolygonStrips::visit_leg_chord(const ChordRequest& request, std::size_t leg) const {
    Strip strip{.first = corner(leg), .last = corner(leg + 1), .box = {}};
    strip.box.include(strip.first);
    strip.box.include(strip.last);
    if (is_seen(strip, request)) request.take(strip.first, strip.last);
}

Box PolygonStrips::box_of(std::span<const std::size_t> legs) const {
    Box box;
    for (const std::size_t leg : legs) {
        box.include(corner(leg));
        box.include(corner(leg + 1));
    }
    return box;
}

void PolygonStrips::follow(std::shared_ptr<const Curve> curve) {
    if (curve == curve_) return;
    const bool is_alike = curve->is_periodic() == curve_->is_periodic();
    const bool is_as_long = curve->control_points().size() == curve_->control_points().size();
    if (is_alike && is_as_long) return follow_points(std::move(curve));
    if (!is_alike || curve->is_periodic() || !follow_renumbered(curve)) make_anew(std::move(curve));
}

void PolygonStrips::make_anew(std::shared_ptr<const Curve> curve) {
    PolygonStrips anew(std::move(curve));
    anew.stretch_count_ += stretch_count_;
    anew.change_.number = change_.number + 1;
    *this = std::move(anew);
}

void PolygonStrips::follow_points(std::shared_ptr<const Curve> curve) {
    const auto points = curve_->control_points();
    const auto others = curve->control_points();
    std::vector<std::size_t> legs;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] == others[i]) continue;
        if (i > 0 && (legs.empty() || legs.back() != i - 1)) legs.push_back(i - 1);
        if (i + 1 < corner_count()) legs.push_back(i);
    }
    const bool is_seam_moved = curve->is_periodic() && points.front() != others.front();
    if (is_seam_moved && legs.back() != corner_count() - 2) legs.push_back(corner_count() - 2);
    const Box before = box_of(legs);
    curve_ = std::move(curve);
    std::vector<std::size_t> stretches;
    for (const std::size_t leg : legs)
        if (stretches.empty() || leg >= stretch_legs_[stretches.back()].end)
            stretches.push_back(stretch_legs_.stretch_of(leg));
    tree_.replace_all(std::move(stretches), [this](std::size_t stretch) { return strip_of_stretch(stretch); });
    change_ = {change_.number + 1, false, false, std::move(legs), before};
}

// The legs at the points that differ lie in one or a few stretches; those after them only get other numbers.
bool PolygonStrips::follow_renumbered(const std::shared_ptr<const Curve>& curve) {
    const auto before_points = curve_->control_points();
    const auto after_points = curve->control_points();
    const Difference points =
        difference(common_ends(before_points, after_points), before_points.size(), after_points.size());
    const std::size_t first = points.first - std::min<std::size_t>(points.first, 1);
    const ItemRange old_legs{first, std::min(points.end_of_old, before_points.size() - 1)};
    const ItemRange legs{first, std::min(points.end_of_new, after_points.size() - 1)};
    if (!stretch_legs_.exchange(old_legs, legs)) return false;
    const Box before = box_of(old_legs.numbers());
    curve_ = curve;
    for (std::size_t k = stretch_legs_.stretch_of(first); k <= stretch_legs_.stretch_of(legs.end - 1); ++k)
        tree_.replace(k, strip_of_stretch(k));
    change_ = {change_.number + 1, false, true, legs.numbers(), before};
    return true;
}

}  // namespace batten::core
