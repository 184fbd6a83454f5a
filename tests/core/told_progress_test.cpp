/// Long operations on curves of many points tell how far they are, and stop when they are told to.
#include "tests/core/told_progress.h"

#include <cmath>

#include "core/curve/knot_kinds.h"
#include "core/edit/fair.h"
#include "core/edit/offset.h"
#include "core/make/interpolate.h"
#include "core/refine/degree.h"
#include "core/refine/knot_removal.h"

namespace batten::core {
namespace {

std::vector<Point> wave_points(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = 0.01 * static_cast<double>(i);
        points.emplace_back(x, std::sin(x));
    }
    return points;
}

Curve wave_of(int degree) {
    return Curve::make(make_knots(KnotKind::clamped_uniform, degree, 500).value(), wave_points(500), {}).value();
}

TEST(ToldProgress, of_fairing) {
    expect_progress([](const Progress& progress) { EXPECT_TRUE(fair(wave_of(3), 1e-3, progress)); });
}

TEST(ToldProgress, of_an_offset) {
    expect_progress([](const Progress& progress) { EXPECT_TRUE(offset(wave_of(3), 0.1, 1e-6, progress)); });
}

TEST(ToldProgress, of_removing_spare_knots) {
    expect_progress([](const Progress& progress) { EXPECT_TRUE(remove_knots(wave_of(3), 1e-3, progress)); });
}

TEST(ToldProgress, of_lowering_the_degree) {
    expect_progress([](const Progress& progress) { EXPECT_TRUE(reduce_degree(wave_of(5), 2, 1.0, progress)); });
    expect_progress([](const Progress& progress) { EXPECT_TRUE(reduce_degree(wave_of(3), 1, 1.0, progress)); });
}

TEST(ToldProgress, of_interpolation) {
    InterpolationRequest request;
    request.degree = 5;
    expect_progress([&](const Progress& progress) { EXPECT_TRUE(interpolate(wave_points(500), request, progress)); });
    request.ends = ClosedEnds{};
    expect_progress([&](const Progress& progress) { EXPECT_TRUE(interpolate(wave_points(500), request, progress)); });
}

}  // namespace
}  // namespace batten::core
