// A cubic in degree 4.
#include <memory>

#include "core/refine/degree.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

void add_elevation_of(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    Contest contest("elevate/n:" + std::to_string(n), 1.0, 1e-13);
    contest.enter(
        "Batten", [curve] { return core::elevate_degree(curve); }, ControlPoints());
    contest.enter(
        "SISL",
        [sisl = std::make_shared<SislCurve>(sisl_curve(curve))] {
            SISLCurve* result = nullptr;
            int status = 0;
            s1750(sisl->get(), 5, &result, &status);
            return SislCurve(result);
        },
        ControlPoints());
    contest.enter(
        "OpenCASCADE",
        [occt = occt_curve(curve)] {
            const OcctCurve copy = OcctCurve::DownCast(occt->Copy());
            copy->IncreaseDegree(4);
            return copy;
        },
        ControlPoints());
    contests.push_back(std::move(contest));
}

}  // namespace

void add_elevate(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL, 100'000UL}) add_elevation_of(contests, n);
}

}  // namespace batten::bench
