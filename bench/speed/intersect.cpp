// Where two curves that cross many times meet, and where their parameters are then.
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/measure/intersect_curves.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

constexpr double tolerance = 1e-9;

// Ups and downs of n control points, which begin at `phase`.
core::Curve wave(std::size_t n, double phase) {
    core::CurveDefinition definition = spiral(n).definition();
    for (std::size_t i = 0; i < n; ++i)
        definition.points[i] = {static_cast<double>(i), 2.0 * std::sin(0.9 * static_cast<double>(i) + phase)};
    return core::Curve::make(std::move(definition)).value();
}

void add_crossings_of(Contests& contests, std::size_t n) {
    const core::Curve first = wave(n, 0.0);
    const core::Curve second = wave(n, 1.0);
    Contest contest("intersect/n:" + std::to_string(n), 1.0, 1e-7);
    contest.enter("Batten", [first, second] {
        Numbers parameters;
        for (const core::CurveContact& contact : core::intersect_curves(first, second).contacts)
            parameters.push_back(contact.u);
        return parameters;
    });
    contest.enter("SISL", [one = std::make_shared<SislCurve>(sisl_curve(first)),
                           other = std::make_shared<SislCurve>(sisl_curve(second))] {
        int count = 0;
        int run_count = 0;
        int status = 0;
        double* on_first = nullptr;
        double* on_second = nullptr;
        SISLIntcurve** runs = nullptr;
        s1857(one->get(), other->get(), tolerance, tolerance, &count, &on_first, &on_second, &run_count, &runs,
              &status);
        const SislNumbers owner(on_first);
        const SislNumbers other_owner(on_second);
        if (run_count > 0) freeIntcrvlist(runs, run_count);
        Numbers parameters(on_first, on_first + count);
        std::sort(parameters.begin(), parameters.end());
        return parameters;
    });
    contest.enter("OpenCASCADE", [one = occt_curve(first), other = occt_curve(second)] {
        const Geom2dAPI_InterCurveCurve crossing(one, other, tolerance);
        Numbers parameters;
        for (int i = 1; i <= crossing.NbPoints(); ++i)
            parameters.push_back(crossing.Intersector().Point(i).ParamOnFirst());
        std::sort(parameters.begin(), parameters.end());
        return parameters;
    });
    contests.push_back(std::move(contest));
}

}  // namespace

void add_intersect(Contests& contests) {
    for (const std::size_t n : {10UL, 30UL, 100UL}) add_crossings_of(contests, n);
}

}  // namespace batten::bench
