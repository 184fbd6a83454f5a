// How long it takes to fit a stroke of 5000 samples anew: percentiles over strokes of several shapes.
#include "core/make/fit_stroke.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

namespace {

using batten::core::Point;

// A flourish of `waves` waves around a circle, with noise, as whole pixels.
std::vector<Point> stroke(int waves, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 0.7);
    std::vector<Point> points;
    constexpr int count = 5000;
    for (int k = 0; k < count; ++k) {
        const double angle = 5.0 * k / count;
        const double radius = 400.0 + 60.0 * std::sin(waves * angle);
        points.emplace_back(std::round(radius * std::cos(angle) + noise(random)),
                            std::round(radius * std::sin(angle) + noise(random)));
    }
    return points;
}

double milliseconds_of_fit(const std::vector<Point>& points, int smoothness) {
    // Of the processor, so that what else runs does not count.
    const std::clock_t start = std::clock();
    const auto curve = batten::core::fit_stroke(points, {.smoothness = smoothness});
    const double passed = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return curve ? passed : 1e9;
}

}  // namespace

int main() {
    std::mt19937 random(1);
    std::vector<double> times;
    for (int round = 0; round < 40; ++round) {
        const std::vector<Point> points = stroke(round % 12, random);
        for (int smoothness = 0; smoothness <= batten::core::most_smoothness; smoothness += 2)
            times.push_back(milliseconds_of_fit(points, smoothness));
    }
    std::ranges::sort(times);
    const auto percentile = [&](double share) {
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    };
    std::printf("5000 samples: median %.2f ms, 99th percentile %.2f ms, longest %.2f ms\n", percentile(0.5),
                percentile(0.99), times.back());
    return 0;
}
