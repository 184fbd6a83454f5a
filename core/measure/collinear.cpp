#include "core/measure/collinear.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/measure/closing.h"

namespace batten::core {

namespace {

// Grows a run of points on one line. Points at its first one set no direction, and the farther the point that sets it,
// the better it is known.
class LineFollower {
  public:
    LineFollower(Point first, double tolerance) : first_(first), tolerance_(tolerance) {}

    // Whether `point` continues the run; the line follows it then.
    bool accepts(Point point) {
        const Vector to_point = point - first_;
        const double distance = length(to_point);
        if (farthest_ <= tolerance_ || distance <= tolerance_) {
            if (distance > farthest_) follow(to_point, distance);
            return true;
        }
        // The nearer of the two must lie on the line to the farther one.
        const double away = std::abs(cross(direction_, to_point));
        const double offset = distance > farthest_ ? away * (farthest_ / distance) : away;
        if (offset > tolerance_) return false;
        if (distance > farthest_) follow(to_point, distance);
        return true;
    }

  private:
    void follow(Vector to_point, double distance) {
        farthest_ = distance;
        direction_ = distance > 0.0 ? to_point / distance : Vector{};
    }

    Point first_;
    double tolerance_;
    Vector direction_{};
    double farthest_ = 0.0;
};

// The control points of a curve, counted on past the last one when it is periodic.
class PointRow {
  public:
    PointRow(const Curve& curve, double tolerance)
        : points_(curve.control_points()),
          end_(curve.is_periodic() ? std::numeric_limits<std::size_t>::max() : points_.size()),
          tolerance_(tolerance) {}

    std::size_t end() const { return end_; }

    // One past the last point of the run that begins at `first`; no run goes on after `most` points.
    std::size_t end_of_run(std::size_t first, std::size_t most) const {
        LineFollower line(at(first), tolerance_);
        std::size_t end = first + 1;
        while (end < end_ && end - first < most && line.accepts(at(end))) ++end;
        return end;
    }

    // The first point, not before `limit`, of the run that ends with `last`.
    std::size_t begin_of_run(std::size_t last, std::size_t limit) const {
        LineFollower line(at(last), tolerance_);
        std::size_t first = last;
        while (first > limit && line.accepts(at(first - 1))) --first;
        return first;
    }

  private:
    Point at(std::size_t i) const { return points_[i % points_.size()]; }

    std::span<const Point> points_;
    std::size_t end_;
    double tolerance_;
};

// The parameters over which only points of the run act; empty where equal knots leave no span.
Interval straight_part(const Curve& curve, std::size_t first, std::size_t count) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    if (!curve.is_periodic()) return {knots[first + p], knots[first + count]};
    const std::size_t n = curve.control_points().size();
    const auto t = [&](std::size_t k) {
        const auto stored = knots.stored();
        return stored[k % n] + static_cast<double>(k / n) * knots.domain().length();
    };
    return {t(first), t(first + count - p)};
}

}  // namespace

std::vector<CollinearRun> collinear_runs(const Curve& curve, double tolerance) {
    assert(tolerance >= 0.0);
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const std::size_t most = n + p;
    const PointRow row(curve, absolute_tolerance(curve, tolerance));
    std::size_t start = 0;
    if (curve.is_periodic()) {
        const std::size_t end = row.end_of_run(0, most);
        if (end >= n) return {{.first = 0, .count = most, .straight = curve.domain()}};
        // Point 0 may be in the middle of a run; the one that comes next begins with it.
        start = row.begin_of_run(end, 1);
    }
    std::vector<CollinearRun> runs;
    for (std::size_t first = start; first < start + n;) {
        const std::size_t end = row.end_of_run(first, most);
        const std::size_t count = end - first;
        if (count > p) {
            const Interval straight = straight_part(curve, first % n, count);
            if (straight.lower < straight.upper) runs.push_back({first % n, count, straight});
        }
        if (end == row.end()) break;
        first = row.begin_of_run(end, first + 1);
    }
    std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return runs;
}

bool are_collinear(std::span<const Point> points, double tolerance) {
    Box box;
    for (const Point& point : points) box.include(point);
    LineFollower line(points.front(), absolute_tolerance(box, tolerance));
    return std::ranges::all_of(points, [&](Point point) { return line.accepts(point); });
}

}  // namespace batten::core
