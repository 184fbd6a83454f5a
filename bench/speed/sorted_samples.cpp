// A million points at sorted parameters.
#include <Geom2dAdaptor_Curve.hxx>
#include <memory>

#include "bench/peers/occt_curve.h"
#include "bench/peers/sisl_curve.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/samples.h"
#include "eigen_curve.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

struct Samples {
    core::Curve curve;
    std::vector<double> parameters = sorted_parameters(1'000'000);
    Numbers points = Numbers(2 * parameters.size());

    explicit Samples(core::Curve of) : curve(std::move(of)) {}
};

template <int Degree>
void enter_eigen(Contest& contest, const std::shared_ptr<Samples>& samples) {
    const auto run = [samples](auto spline, auto project) -> const Numbers& {
        double* out = samples->points.data();
        for (const double u : samples->parameters) {
            const auto point = project(spline(u));
            *out++ = point.x;
            *out++ = point.y;
        }
        return samples->points;
    };
    if (samples->curve.is_rational())
        contest.enter("Eigen", [run, spline = eigen_curve<3, Degree>(samples->curve)]() -> const Numbers& {
            return run(spline, [](const auto& p) { return core::Point(p[0] / p[2], p[1] / p[2]); });
        });
    else
        contest.enter("Eigen", [run, spline = eigen_curve<2, Degree>(samples->curve)]() -> const Numbers& {
            return run(spline, [](const auto& p) { return core::Point(p[0], p[1]); });
        });
}

void add_samples_of(Contests& contests, std::size_t n, int degree, bool is_rational) {
    const auto samples = std::make_shared<Samples>(spiral(n, degree, is_rational));
    Contest contest("sorted_samples/p:" + std::to_string(degree) + "/rational:" + std::to_string(is_rational ? 1 : 0) +
                        "/n:" + std::to_string(n),
                    static_cast<double>(samples->parameters.size()), 1e-13);
    if (degree == 3 && !is_rational) {
        contest.share(samples->curve);
        contest.share("parameters", samples->parameters);
    }
    contest.enter("Batten", [samples]() -> const Numbers& {
        double* out = samples->points.data();
        for (const double u : samples->parameters) {
            const core::Point point = core::point_at(samples->curve, u);
            *out++ = point.x;
            *out++ = point.y;
        }
        return samples->points;
    });
    contest.enter("Batten_prepared",
                  [samples, points = std::vector<core::Point>(
                                samples->parameters.size())]() mutable -> const std::vector<core::Point>& {
                      core::sample(samples->curve, samples->parameters, points);
                      return points;
                  });
    const auto sisl = std::make_shared<SislCurve>(sisl_curve(samples->curve));
    contest.enter("SISL", [samples, sisl]() -> const Numbers& {
        double* out = samples->points.data();
        int left = 0;
        int status = 0;
        for (const double u : samples->parameters) {
            s1221(sisl->get(), 0, u, &left, out, &status);
            out += 2;
        }
        return samples->points;
    });
    contest.enter("OpenCASCADE",
                  [samples, adaptor = Geom2dAdaptor_Curve(occt_curve(samples->curve))]() -> const Numbers& {
                      double* out = samples->points.data();
                      gp_Pnt2d point;
                      for (const double u : samples->parameters) {
                          adaptor.D0(u, point);
                          *out++ = point.X();
                          *out++ = point.Y();
                      }
                      return samples->points;
                  });
    if (degree == 3) enter_eigen<3>(contest, samples);
    if (degree == 5) enter_eigen<5>(contest, samples);
    if (degree == 10) enter_eigen<10>(contest, samples);
    const auto finished = std::make_shared<Numbers>();
    contest.enter("writing", [samples, finished]() -> const Numbers& {
        if (finished->empty()) *finished = samples->points;
        std::copy(finished->begin(), finished->end(), samples->points.begin());
        return samples->points;
    });
    contests.push_back(std::move(contest));
}

}  // namespace

void add_sorted_samples(Contests& contests) {
    for (const bool is_rational : {false, true})
        for (const int degree : {3, 5, 10}) add_samples_of(contests, 1000, degree, is_rational);
    for (const std::size_t n : {10UL, 100UL, 10'000UL, 100'000UL, 1'000'000UL}) add_samples_of(contests, n, 3, false);
}

}  // namespace batten::bench
