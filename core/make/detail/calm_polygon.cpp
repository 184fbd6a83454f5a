#include "core/make/detail/calm_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace batten::core {

namespace {

// The points first..last, which turn to the same side or not at all.
struct TurnRun {
    std::size_t first;
    std::size_t last;
    int side;
};

// How far `point` is to the left of the line from `a` to `b`.
double height(Point point, Point a, Point b) {
    const Vector leg = b - a;
    const double size = length(leg);
    return size > 0.0 ? cross(leg, point - a) / size : 0.0;
}

int side_of(double height) {
    constexpr double least = 1e-7;
    return height > least ? 1 : height < -least ? -1 : 0;
}

std::vector<TurnRun> runs_of(std::span<const Point> points) {
    std::vector<TurnRun> runs;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const int side = side_of(height(points[i], points[i - 1], points[i + 1]));
        if (side == 0) continue;
        if (runs.empty() || runs.back().side != side) runs.push_back({i, i, side});
        runs.back().last = i;
    }
    return runs;
}

// Puts `b` onto the line between its neighbors with the least moves of the three.
void flatten(Point& a, Point& b, Point& c) {
    const Vector leg = c - a;
    const double square = dot(leg, leg);
    if (!(square > 0.0)) return;
    const double share = std::clamp(dot(b - a, leg) / square, 0.0, 1.0);
    const Vector off = b - (a + share * leg);
    const double sum = 1.0 + share * share + (1.0 - share) * (1.0 - share);
    b -= (1.0 / sum) * off;
    a += ((1.0 - share) / sum) * off;
    c += (share / sum) * off;
}

// The points from before to behind a run when it is straight; `is_fixed` are the ends of the whole.
std::vector<Point> straightened(std::span<const Point> points, bool is_first_fixed, bool is_last_fixed) {
    std::vector<Point> moved(points.begin(), points.end());
    constexpr int sweeps = 30;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 1; i + 1 < moved.size(); ++i) {
            flatten(moved[i - 1], moved[i], moved[i + 1]);
            if (is_first_fixed) moved.front() = points.front();
            if (is_last_fixed) moved.back() = points.back();
        }
    const Point a = moved.front();
    const Vector leg = moved.back() - a;
    const double square = dot(leg, leg);
    for (std::size_t i = 1; i + 1 < moved.size() && square > 0.0; ++i)
        moved[i] = a + std::clamp(dot(moved[i] - a, leg) / square, 0.0, 1.0) * leg;
    return moved;
}

double largest_height(std::span<const Point> points, const TurnRun& run) {
    double largest = 0.0;
    for (std::size_t i = run.first; i <= run.last; ++i)
        largest = std::max(largest, std::abs(height(points[i], points[i - 1], points[i + 1])));
    return largest;
}

}  // namespace

void calm_polygon(std::span<Point> points, double tolerance) {
    const std::vector<Point> given(points.begin(), points.end());
    const auto calm_one = [&](const TurnRun& run) {
        const std::span<Point> part = points.subspan(run.first - 1, run.last - run.first + 3);
        const std::vector<Point> moved = straightened(part, run.first == 1, run.last + 2 == points.size());
        for (std::size_t i = 0; i < moved.size(); ++i)
            if (!(distance(moved[i], given[run.first - 1 + i]) <= tolerance)) return false;
        std::ranges::copy(moved, part.begin());
        return true;
    };
    for (std::size_t rounds = 0; rounds < 4 * points.size(); ++rounds) {
        std::vector<TurnRun> runs = runs_of(points);
        if (runs.size() < 2) return;
        std::ranges::stable_sort(runs, {}, [&](const TurnRun& run) { return largest_height(points, run); });
        if (std::ranges::none_of(runs, calm_one)) return;
    }
}

}  // namespace batten::core
