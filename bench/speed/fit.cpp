// The curve near many points, within a tolerance.
#include "core/make/fit.h"

#include <Geom2dAPI_PointsToBSpline.hxx>
#include <algorithm>
#include <cmath>

#include "core/measure/nearest.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

constexpr double tolerance = 1e-3;

std::vector<core::Point> points_of_wave(std::size_t count) {
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 10.0 * static_cast<double>(i) / static_cast<double>(count - 1);
        points.emplace_back(t, std::sin(2.0 * t) + 0.3 * std::cos(5.0 * t));
    }
    return points;
}

// Whether all points are within the tolerance.
struct AreNear {
    std::vector<core::Point> points;

    Numbers operator()(const core::Result<core::Approximation>& result) const { return (*this)(result->curve); }
    Numbers operator()(const SislCurve& curve) const {
        std::vector<core::Point> control;
        for (int i = 0; i < curve->in; ++i) control.emplace_back(curve->ecoef[2 * i], curve->ecoef[2 * i + 1]);
        return (*this)(core::Curve::make({.degree = curve->ik - 1,
                                          .knots = {curve->et, curve->et + curve->in + curve->ik},
                                          .points = std::move(control)})
                           .value());
    }
    Numbers operator()(const OcctCurve& curve) const {
        std::vector<core::Point> control;
        for (const gp_Pnt2d& pole : curve->Poles()) control.emplace_back(pole.X(), pole.Y());
        const auto& knots = curve->KnotSequence();
        return (*this)(
            core::Curve::make(
                {.degree = curve->Degree(), .knots = {knots.begin(), knots.end()}, .points = std::move(control)})
                .value());
    }
    Numbers operator()(const core::Curve& curve) const {
        const core::NearestFinder finder(curve);
        const bool are_near = std::ranges::all_of(points, [&](const core::Point& point) {
            return core::distance(finder.nearest(point).point, point) <= 1.01 * tolerance;
        });
        return {are_near ? 1.0 : 0.0};
    }
};

void add_fit_of(Contests& contests, std::size_t count) {
    const std::vector<core::Point> points = points_of_wave(count);
    Contest contest("fit/n:" + std::to_string(count), 1.0, 0.0);
    contest.enter(
        "Batten", [points] { return core::fit_within(points, tolerance); }, AreNear{points});
    Numbers coordinates;
    for (const core::Point& point : points) coordinates.insert(coordinates.end(), {point.x, point.y});
    contest.enter(
        "SISL",
        [coordinates, count]() mutable {
            double parameter = 0.0;
            double allowed[2] = {0.7 * tolerance, 0.7 * tolerance};
            double errors[2] = {0.0, 0.0};
            SISLCurve* curve = nullptr;
            int status = 0;
            s1961(coordinates.data(), static_cast<int>(count), 2, 2, &parameter, allowed, 1, 1, 1, 1e-6, 20, 4, &curve,
                  errors, &status);
            return SislCurve(curve);
        },
        AreNear{points});
    contest.enter(
        "OpenCASCADE",
        [through = occt_array(points)] {
            return OcctCurve(Geom2dAPI_PointsToBSpline(through, 3, 3, GeomAbs_C2, tolerance).Curve());
        },
        AreNear{points});
    contests.push_back(std::move(contest));
}

}  // namespace

void add_fit(Contests& contests) {
    for (const std::size_t count : {100UL, 1000UL}) add_fit_of(contests, count);
}

}  // namespace batten::bench
