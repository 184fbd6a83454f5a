#include "core/evaluate/strip_tree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/evaluate/detail/subdivide.h"

namespace batten::core {

namespace {

// How many times longer than broad a box is that is drawn as a line.
constexpr double thinness = 4.0;

double diagonal(const Box& box) {
    return length(box.size());
}

// Where squares of coordinates overflow nothing is near.
double far_or_distance(Point point, Point a, Point b) {
    const double measured = distance_to_segment(point, a, b);
    return std::isnan(measured) ? Box::infinity : measured;
}

// The farthest corner of the box from the segment a..b.
double box_deviation(const Box& box, Point a, Point b) {
    double largest = 0.0;
    for (const Point corner : {box.lower, Point(box.upper.x, box.lower.y), box.upper, Point(box.lower.x, box.upper.y)})
        largest = std::max(largest, far_or_distance(corner, a, b));
    return largest;
}

}  // namespace

Strip joined(const Strip& a, const Strip& b) {
    if (a.box.is_empty()) return b;
    if (b.box.is_empty()) return a;
    Strip both = a;
    both.last = b.last;
    both.length = a.length + b.length;
    both.box.include(b.box.lower);
    both.box.include(b.box.upper);
    both.is_whole = a.is_whole && b.is_whole && a.last == b.first;
    if (!both.is_whole) {
        both.deviation = diagonal(both.box);
        return both;
    }
    // The chords of both parts stay as near to the new one as their common end.
    const double of_parts = std::max(a.deviation, b.deviation) + far_or_distance(a.last, both.first, both.last);
    both.deviation = std::min(of_parts, box_deviation(both.box, both.first, both.last));
    return both;
}

Strip strip_of(const std::vector<Point>& points) {
    Strip strip;
    strip.first = points.front();
    strip.last = points.back();
    for (std::size_t i = 0; i < points.size(); ++i) {
        strip.box.include(points[i]);
        strip.deviation = std::max(strip.deviation, far_or_distance(points[i], strip.first, strip.last));
        if (i > 0) strip.length += distance(points[i - 1], points[i]);
    }
    return strip;
}

void RunCollector::add(Point a, Point b, double along) {
    if (runs_.empty() || runs_.back().back() != a) {
        runs_.push_back({a});
        starts_.push_back(along);
        ++count_;
    }
    runs_.back().push_back(b);
    ++count_;
}

void RunCollector::add_extent(const Strip& strip, double along) {
    const Point middle = strip.box.center();
    const Vector size = strip.box.size();
    std::array ends{Point(strip.box.lower.x, middle.y), Point(strip.box.upper.x, middle.y)};
    if (size.x < size.y) ends = {Point(middle.x, strip.box.lower.y), Point(middle.x, strip.box.upper.y)};
    if (distance(strip.first, ends[1]) < distance(strip.first, ends[0])) std::swap(ends[0], ends[1]);
    add(strip.first, ends[0], along);
    add(ends[0], ends[1]);
    add(ends[1], strip.last);
}

bool add_if_simple(const Strip& strip, double tolerance, RunCollector& runs, double along) {
    if (strip.deviation <= tolerance) {
        runs.add(strip.first, strip.last, along);
        return true;
    }
    const Vector size = strip.box.size();
    const double breadth = std::min(size.x, size.y);
    const bool is_thin = breadth <= tolerance && thinness * breadth <= std::max(size.x, size.y);
    if (!strip.is_whole || !is_thin) return false;
    runs.add_extent(strip, along);
    return true;
}

bool has_any(std::span<const std::size_t> ascending, std::size_t first, std::size_t last) {
    const auto found = std::lower_bound(ascending.begin(), ascending.end(), first);
    return found != ascending.end() && *found <= last;
}

StripTree::StripTree(std::vector<Strip> stretches) {
    levels_.push_back(std::move(stretches));
    while (levels_.back().size() > 1) {
        levels_.emplace_back((levels_.back().size() + 1) / 2);
        for (std::size_t i = 0; i < levels_.back().size(); ++i) join(levels_.size() - 1, i);
    }
}

void StripTree::join(std::size_t level, std::size_t i) {
    const std::vector<Strip>& parts = levels_[level - 1];
    levels_[level][i] = 2 * i + 1 < parts.size() ? joined(parts[2 * i], parts[2 * i + 1]) : parts[2 * i];
}

// On each level every pair above what is new is joined once.
void StripTree::join_above(std::vector<std::size_t> stretches) {
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        for (std::size_t& i : stretches) i /= 2;
        stretches.erase(std::unique(stretches.begin(), stretches.end()), stretches.end());
        for (const std::size_t i : stretches) join(level, i);
    }
}

void StripTree::replace(std::size_t i, const Strip& strip) {
    levels_.front()[i] = strip;
    for (std::size_t level = 1; level < levels_.size(); ++level) join(level, i >> level);
}

}  // namespace batten::core
