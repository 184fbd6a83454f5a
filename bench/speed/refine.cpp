// A thousand knots inserted at once.
#include <memory>

#include "core/refine/knot_refinement.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

void add_refinement_of(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    std::vector<double> knots = random_parameters(1000);
    std::sort(knots.begin(), knots.end());
    Contest contest("refine/n:" + std::to_string(n), 1.0, 1e-13);
    contest.enter(
        "Batten", [curve, knots] { return core::refine_knots(curve, knots); }, ControlPoints());
    contest.enter(
        "SISL",
        [sisl = std::make_shared<SislCurve>(sisl_curve(curve)), knots]() mutable {
            SISLCurve* result = nullptr;
            int status = 0;
            s1018(sisl->get(), knots.data(), static_cast<int>(knots.size()), &result, &status);
            return SislCurve(result);
        },
        ControlPoints());
    contest.enter(
        "OpenCASCADE",
        [occt = occt_curve(curve), values = occt_array<TColStd_Array1OfReal>(knots),
         counts = occt_array<TColStd_Array1OfInteger>(std::vector<int>(knots.size(), 1))] {
            const OcctCurve copy = OcctCurve::DownCast(occt->Copy());
            copy->InsertKnots(values, counts, 0.0, true);
            return copy;
        },
        ControlPoints());
    contests.push_back(std::move(contest));
}

}  // namespace

void add_refine(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL, 100'000UL, 1'000'000UL}) add_refinement_of(contests, n);
}

}  // namespace batten::bench
