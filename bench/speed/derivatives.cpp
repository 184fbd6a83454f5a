// A point with its first and second derivative, at a random parameter.
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

void write(double* out, const core::Jet& jet) {
    const double numbers[] = {jet.point.x, jet.point.y, jet[1].x, jet[1].y, jet[2].x, jet[2].y};
    std::copy(std::begin(numbers), std::end(numbers), out);
}

void write_occt(double* out, const gp_Pnt2d& point, const gp_Vec2d& first, const gp_Vec2d& second) {
    const double numbers[] = {point.X(), point.Y(), first.X(), first.Y(), second.X(), second.Y()};
    std::copy(std::begin(numbers), std::end(numbers), out);
}

void add_jets_of(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    Contest contest("derivatives/n:" + std::to_string(n), random_parameter_count, 1e-12);
    contest.share(curve);
    contest.share("parameters", random_parameters(random_parameter_count));
    contest.enter("Batten", at_random_parameters<6>(
                                [curve](double u, double* out) { write(out, core::derivatives_at(curve, u, 2)); }));
    contest.enter("Batten_prepared",
                  at_random_parameters<6>([evaluator = core::Evaluator(curve)](double u, double* out) {
                      write(out, evaluator.derivatives_at(u, 2));
                  }));
    contest.enter(
        "SISL", at_random_parameters<6>([sisl = std::make_shared<SislCurve>(sisl_curve(curve))](double u, double* out) {
            int left = 0;
            int status = 0;
            s1221(sisl->get(), 2, u, &left, out, &status);
        }));
    contest.enter("OpenCASCADE", at_random_parameters<6>([occt = occt_curve(curve)](double u, double* out) {
                      gp_Pnt2d point;
                      gp_Vec2d first;
                      gp_Vec2d second;
                      occt->D2(u, point, first, second);
                      write_occt(out, point, first, second);
                  }));
    contest.enter("OpenCASCADE_prepared",
                  at_random_parameters<6>([adaptor = Geom2dAdaptor_Curve(occt_curve(curve))](double u, double* out) {
                      gp_Pnt2d point;
                      gp_Vec2d first;
                      gp_Vec2d second;
                      adaptor.D2(u, point, first, second);
                      write_occt(out, point, first, second);
                  }));
    contest.enter("Eigen", at_random_parameters<6>([spline = eigen_curve<2, 3>(curve)](double u, double* out) {
                      const auto jet = spline.derivatives<2>(u);
                      for (int k = 0; k <= 2; ++k) {
                          *out++ = jet(0, k);
                          *out++ = jet(1, k);
                      }
                  }));
    contests.push_back(std::move(contest));
}

}  // namespace

void add_derivatives(Contests& contests) {
    for (const std::size_t n : {1000UL, 100'000UL}) add_jets_of(contests, n);
}

}  // namespace batten::bench
