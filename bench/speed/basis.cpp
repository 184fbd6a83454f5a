// The basis functions that do not vanish at a random parameter.
#include <gsl/gsl_bspline.h>

#include <memory>

#include "at_random_parameters.h"
#include "bench/peers/sisl_curve.h"
#include "core/evaluate/basis_evaluator.h"
#include "eigen_curve.h"
#include "works.h"

extern "C" void s1220(double* et, int ik, int in, int* ileft, double ax, int ider, double ebder[], int* jstat);

namespace batten::bench {

namespace {

struct GslDeleter {
    void operator()(gsl_bspline_workspace* workspace) const { gsl_bspline_free(workspace); }
    void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
};

}  // namespace

void add_basis(Contests& contests) {
    const std::size_t n = 1000;
    const core::Curve curve = spiral(n);
    Contest contest("basis/n:" + std::to_string(n), random_parameter_count, 1e-14);
    contest.share(curve);
    contest.share("parameters", random_parameters(random_parameter_count));
    contest.enter("Batten", at_random_parameters<4>([knots = curve.knots()](double u, double* out) {
                      const core::BasisValues basis = core::basis_functions(knots, u);
                      std::copy(basis.derivatives[0].begin(), basis.derivatives[0].end(), out);
                  }));
    contest.enter("Batten_prepared",
                  at_random_parameters<4>([prepared = core::BasisEvaluator(curve.knots())](double u, double* out) {
                      const core::BasisValues basis = prepared.values_at(u);
                      std::copy(basis.derivatives[0].begin(), basis.derivatives[0].end(), out);
                  }));
    contest.enter(
        "SISL", at_random_parameters<4>([knots = Numbers(curve.knots().values().begin(), curve.knots().values().end()),
                                         n](double u, double* out) mutable {
            int left = 0;
            int status = 0;
            s1220(knots.data(), 4, static_cast<int>(n), &left, u, 0, out, &status);
        }));
    contest.enter("Eigen", at_random_parameters<4>([spline = eigen_curve<2, 3>(curve)](double u, double* out) {
                      const auto values = spline.basisFunctions(u);
                      for (int j = 0; j < 4; ++j) out[j] = values(j);
                  }));
    const std::shared_ptr<gsl_bspline_workspace> workspace(gsl_bspline_alloc(4, n - 2), GslDeleter());
    const std::shared_ptr<gsl_vector> breaks(gsl_vector_alloc(n - 2), GslDeleter());
    for (std::size_t i = 0; i < n - 2; ++i) gsl_vector_set(breaks.get(), i, curve.knots()[i + 3]);
    gsl_bspline_knots(breaks.get(), workspace.get());
    contest.enter("GSL",
                  at_random_parameters<4>([workspace, values = std::shared_ptr<gsl_vector>(
                                                          gsl_vector_alloc(4), GslDeleter())](double u, double* out) {
                      std::size_t first = 0;
                      std::size_t last = 0;
                      gsl_bspline_eval_nonzero(u, values.get(), &first, &last, workspace.get());
                      for (std::size_t j = 0; j < 4; ++j) out[j] = gsl_vector_get(values.get(), j);
                  }));
    contests.push_back(std::move(contest));
}

}  // namespace batten::bench
