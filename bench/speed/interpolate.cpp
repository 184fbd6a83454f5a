// The cubic spline through points, at given parameters.
#include "core/make/interpolate.h"

#include <BSplCLib.hxx>
#include <memory>
#include <unsupported/Eigen/Splines>

#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

extern "C" void s1891(double etau[], double epoint[], int idim, int inbpnt, int iright, int eder[], int iopen,
                      double et[], double* ebcoef[], int* in, int ik, int inlr, int inrc, int* jstat);

namespace batten::bench {

namespace {

// Eigen's matrix is a full one.
constexpr std::size_t most_dense_points = 100;

struct InterpolatedPoints {
    Numbers operator()(const core::Result<core::Interpolation>& result) const { return ControlPoints()(result->curve); }
};

void add_interpolation_of(Contests& contests, std::size_t count) {
    const std::vector<core::Point> through = points_on_spiral(count);
    core::InterpolationRequest request{.parameters = sorted_parameters(count)};
    // Uneven.
    const std::vector<double> shifts = random_parameters(count);
    for (std::size_t i = 1; i + 1 < count; ++i)
        request.parameters[i] += 0.3 * shifts[i] / static_cast<double>(count - 1);
    const core::Curve expected = core::interpolate(through, request)->curve;
    Contest contest("interpolate/n:" + std::to_string(count), 1.0, 1e-12);
    contest.share("points", through);
    contest.share("parameters", request.parameters);
    contest.share("knots", expected.knots().values());
    contest.enter(
        "Batten", [through, request] { return core::interpolate(through, request); }, InterpolatedPoints());

    Numbers coordinates;
    for (const core::Point& point : through) coordinates.insert(coordinates.end(), {point.x, point.y});
    contest.enter("SISL", [coordinates, parameters = request.parameters,
                           knots = Numbers(expected.knots().values().begin(), expected.knots().values().end()),
                           orders = std::vector<int>(count, 0)]() mutable {
        double* coefficients = nullptr;
        int n = 0;
        int status = 0;
        s1891(parameters.data(), coordinates.data(), 2, static_cast<int>(parameters.size()), 1, orders.data(), 1,
              knots.data(), &coefficients, &n, 4, 0, 0, &status);
        const SislNumbers owner(coefficients);
        return Numbers(coefficients, coefficients + 2 * static_cast<std::ptrdiff_t>(n));
    });
    contest.enter("OpenCASCADE",
                  [through = occt_array(through), parameters = occt_array<TColStd_Array1OfReal>(request.parameters),
                   knots = occt_array<TColStd_Array1OfReal>(expected.knots().values()),
                   orders = occt_array<TColStd_Array1OfInteger>(std::vector<int>(count, 0))] {
                      TColgp_Array1OfPnt2d poles = through;
                      int problem = 0;
                      BSplCLib::Interpolate(3, knots, parameters, orders, poles, problem);
                      Numbers numbers;
                      for (const gp_Pnt2d& pole : poles) numbers.insert(numbers.end(), {pole.X(), pole.Y()});
                      return numbers;
                  });
    if (count <= most_dense_points) {
        using Spline = Eigen::Spline<double, 2, 3>;
        const auto columns = static_cast<Eigen::Index>(count);
        Eigen::Matrix2Xd points(2, columns);
        for (Eigen::Index i = 0; i < columns; ++i) {
            const core::Point& point = through[static_cast<std::size_t>(i)];
            points.col(i) << point.x, point.y;
        }
        const Spline::KnotVectorType parameters =
            Eigen::Map<const Eigen::RowVectorXd>(request.parameters.data(), columns);
        contest.enter("Eigen", [points, parameters] {
            const Spline spline = Eigen::SplineFitting<Spline>::Interpolate(points, 3, parameters);
            return Numbers(spline.ctrls().data(), spline.ctrls().data() + spline.ctrls().size());
        });
    }
    contests.push_back(std::move(contest));
}

}  // namespace

void add_interpolate(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL, 100'000UL}) add_interpolation_of(contests, n);
}

}  // namespace batten::bench
