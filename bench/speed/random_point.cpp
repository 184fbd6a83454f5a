// One point at a random parameter.
#include <Geom2dAdaptor_Curve.hxx>
#include <memory>

#include "at_random_parameters.h"
#include "bench/peers/occt_curve.h"
#include "bench/peers/sisl_curve.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/evaluator.h"
#include "eigen_curve.h"
#include "works.h"

namespace batten::bench {

namespace {

// The points at all parameters, by a function that gives one.
template <class PointAt>
auto each(PointAt point_at) {
    return at_random_parameters<2>([point_at](double u, double* out) mutable {
        const core::Point point = point_at(u);
        out[0] = point.x;
        out[1] = point.y;
    });
}

void add_points_of(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    Contest contest("random_point/n:" + std::to_string(n), random_parameter_count, 1e-13);
    contest.enter("Batten", each([curve](double u) { return core::point_at(curve, u); }));
    contest.enter("Batten_prepared",
                  each([evaluator = core::Evaluator(curve)](double u) { return evaluator.point_at(u); }));
    contest.enter("SISL", each([sisl = std::make_shared<SislCurve>(sisl_curve(curve))](double u) {
                      double point[2];
                      int left = 0;
                      int status = 0;
                      s1221(sisl->get(), 0, u, &left, point, &status);
                      return core::Point(point[0], point[1]);
                  }));
    contest.enter("OpenCASCADE", each([occt = occt_curve(curve)](double u) {
                      gp_Pnt2d point;
                      occt->D0(u, point);
                      return core::Point(point.X(), point.Y());
                  }));
    contest.enter("OpenCASCADE_prepared", each([adaptor = Geom2dAdaptor_Curve(occt_curve(curve))](double u) {
                      gp_Pnt2d point;
                      adaptor.D0(u, point);
                      return core::Point(point.X(), point.Y());
                  }));
    contest.enter("Eigen", each([spline = eigen_curve<2, 3>(curve)](double u) {
                      const auto point = spline(u);
                      return core::Point(point[0], point[1]);
                  }));
    contests.push_back(std::move(contest));
}

}  // namespace

void add_random_point(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL, 100'000UL, 1'000'000UL}) add_points_of(contests, n);
}

}  // namespace batten::bench
