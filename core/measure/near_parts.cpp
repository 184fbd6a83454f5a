#include "core/measure/near_parts.h"

#include <cassert>
#include <cmath>

#include "core/curve/detail/span_range.h"
#include "core/measure/detail/chord_tree.h"
#include "core/measure/nearest.h"

namespace batten::core {

namespace {

// Distances closer than this part of them are equal.
constexpr double equal_distances = 1e-14;

}  // namespace

// Keeps the nearest point that was found so far.
class NearParts::Search {
  public:
    Search(const NearParts& parts, Point query, double reach) : parts_(parts), query_(query), reach_(reach) {}

    bool is_too_far(double squared) const { return squared > reach_ * reach_; }

    // The spans over points first..end-1 and the p after each of these.
    void search_stretch(std::size_t first, std::size_t end) {
        const KnotVector& knots = parts_.curve_.knots();
        const std::size_t p = parts_.degree();
        const std::size_t span_end = std::min(end + p, parts_.point_count());
        for (std::size_t s = first + p; s < span_end; ++s) {
            if (!is_near(s)) continue;
            const std::size_t begin = s;
            while (s + 1 < span_end && is_near(s + 1)) ++s;
            if (knots[begin] < knots[s + 1]) offer(nearest_point(curve_over_spans(parts_.curve_, begin, s), query_));
        }
    }

    std::optional<CurveSample> found() const { return best_; }

  private:
    bool is_near(std::size_t span) const {
        const KnotVector& knots = parts_.curve_.knots();
        if (knots[span] == knots[span + 1]) return false;
        const Chord chord = chord_of(parts_.points_of(span - parts_.degree(), span + 1));
        // In doubt, where numbers overflow, it may be near.
        return !(std::sqrt(squared_distance(chord, query_)) > reach_ + chord.width);
    }

    void offer(const CurveSample& sample) {
        const double away = distance(sample.point, query_);
        if (away > reach_) return;
        const bool is_nearer = !best_ || away < distance(best_->point, query_) * (1.0 - equal_distances);
        if (is_nearer || sample.u < best_->u) best_ = sample;
        reach_ = std::min(reach_, away * (1.0 + equal_distances));
    }

    const NearParts& parts_;
    Point query_;
    double reach_;  ///< what is farther away is not looked for
    std::optional<CurveSample> best_;
};

NearParts::NearParts(Curve curve) : curve_(std::move(curve)), boxes_(boxes_of_stretches()) {}

std::vector<Point> NearParts::points_of(std::size_t first, std::size_t end) const {
    const auto all = curve_.control_points();
    std::vector<Point> points;
    points.reserve(end - first);
    for (std::size_t i = first; i < end; ++i) points.push_back(all[i < all.size() ? i : i % all.size()]);
    return points;
}

std::vector<Box> NearParts::boxes_of_stretches() const {
    std::vector<Box> boxes;
    boxes.reserve(point_count() / points_per_stretch + 1);
    for (std::size_t i = 0; i < point_count(); i += points_per_stretch) {
        Box& box = boxes.emplace_back();
        for (const Point& point : points_of(i, std::min(i + points_per_stretch + degree(), point_count())))
            box.include(point);
    }
    return boxes;
}

std::vector<std::size_t> NearParts::stretches_near(Point place, double distance, std::size_t* looks) const {
    std::vector<std::size_t> near;
    std::size_t counted = 0;
    boxes_.visit_near(
        place,
        [&](double squared) {
            ++counted;
            return squared > distance * distance;
        },
        [&](std::size_t stretch) { near.push_back(stretch); });
    if (looks != nullptr) *looks += counted;
    std::sort(near.begin(), near.end());
    return near;
}

bool NearParts::is_crowded(Point place, double distance, std::size_t most) const {
    std::size_t points = 0;
    boxes_.visit_near(
        place, [&](double squared) { return points > most || squared > distance * distance; },
        [&](std::size_t) { points += points_per_stretch; });
    return points > most;
}

std::optional<std::vector<Curve>> NearParts::parts_near(Point place, double distance, std::size_t most_spans) const {
    const std::size_t most_points = most_spans + 32 * points_per_stretch;
    if (is_crowded(place, distance, most_points)) return std::nullopt;
    const std::size_t p = degree();
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    std::size_t count = 0;
    visit_near(place, distance, [&](std::size_t i) {
        const std::size_t span = i + p;
        if (span + p + 1 >= curve_.knots().size() || curve_.knots()[span] == curve_.knots()[span + 1]) return;
        Box box;
        for (const Point& point : points_of(i, span + 1)) box.include(point);
        if (squared_distance(box, place) > distance * distance) return;
        ++count;
        if (!runs.empty() && curve_.knots()[runs.back().second + 1] == curve_.knots()[span])
            runs.back().second = span;
        else
            runs.emplace_back(span, span);
    });
    if (count > most_spans) return std::nullopt;
    std::vector<Curve> parts;
    for (const auto& [first, last] : runs) parts.push_back(curve_over_spans(curve_, first, last));
    return parts;
}

std::optional<CurveSample> NearParts::nearest(Point query, double reach, std::size_t* looks) const {
    assert(is_finite(query));
    Search search(*this, query, reach);
    std::size_t counted = 0;
    boxes_.visit_near(
        query,
        [&](double squared) {
            ++counted;
            return search.is_too_far(squared);
        },
        [&](std::size_t stretch) { search.search_stretch(stretch * points_per_stretch, end_of(stretch)); });
    if (looks != nullptr) *looks += counted;
    return search.found();
}

}  // namespace batten::core
