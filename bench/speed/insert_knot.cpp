// One knot inserted in the middle.
#include <memory>

#include "core/refine/knot_insertion.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

// The arrays that a curve is made of, which is all that a copy of them has to write.
struct CopiedArrays {
    explicit CopiedArrays(const core::Curve& curve)
        : knots(curve.knots().values().begin(), curve.knots().values().end()),
          points(curve.control_points().begin(), curve.control_points().end()),
          weights(curve.weights().begin(), curve.weights().end()) {}

    std::vector<double> knots;
    std::vector<core::Point> points;
    std::vector<double> weights;
};

struct CopiedPoints {
    Numbers operator()(const CopiedArrays& copy) const {
        Numbers numbers;
        for (const core::Point& point : copy.points) numbers.insert(numbers.end(), {point.x, point.y});
        return numbers;
    }
};

void add_insertion_into(Contests& contests, std::size_t n) {
    constexpr double u = 0.5;
    const core::Curve curve = spiral(n);
    Contest contest("insert_knot/n:" + std::to_string(n), 1.0, 1e-13);
    contest.share(curve);
    contest.share("knot", std::span(&u, 1));
    contest.enter(
        "Batten", [curve] { return core::insert_knot(curve, u); }, ControlPoints());
    contest.enter(
        "SISL",
        [sisl = std::make_shared<SislCurve>(sisl_curve(curve))] {
            SISLCurve* result = nullptr;
            int status = 0;
            s1017(sisl->get(), &result, u, &status);
            return SislCurve(result);
        },
        ControlPoints());
    contest.enter(
        "OpenCASCADE",
        [occt = occt_curve(curve)] {
            const OcctCurve copy = OcctCurve::DownCast(occt->Copy());
            copy->InsertKnot(u, 1, 0.0);
            return copy;
        },
        ControlPoints());
    contest.enter(
        "copying", [result = core::insert_knot(curve, u).value()] { return CopiedArrays(result); }, CopiedPoints());
    contests.push_back(std::move(contest));
}

}  // namespace

void add_insert_knot(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL, 100'000UL, 1'000'000UL}) add_insertion_into(contests, n);
}

}  // namespace batten::bench
