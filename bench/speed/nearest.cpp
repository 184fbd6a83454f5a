// The point of a curve nearest to a given one, of the whole curve.
#include "core/measure/nearest.h"

#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <memory>

#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

constexpr std::size_t query_count = 64;

// The nearest points to all queries, by a function that finds one.
template <class Nearest>
auto each(Nearest nearest) {
    std::vector<core::Point> queries;
    const std::vector<double> numbers = random_parameters(2 * query_count);
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        queries.emplace_back(3.0 * numbers[i] - 1.5, 3.0 * numbers[i + 1] - 1.5);
    return [nearest, queries, found = Numbers()]() mutable -> const Numbers& {
        found.clear();
        for (const core::Point& query : queries) found.push_back(core::distance(nearest(query), query));
        return found;
    };
}

void add_queries_to(Contests& contests, std::size_t n) {
    const core::Curve curve = spiral(n);
    Contest contest("nearest/n:" + std::to_string(n), query_count, 1e-6);
    contest.enter("Batten", each([curve](core::Point query) { return core::nearest_point(curve, query).point; }));
    contest.enter("Batten_prepared", each([finder = std::make_shared<core::NearestFinder>(curve)](core::Point query) {
                      return finder->nearest(query).point;
                  }));
    contest.enter("SISL", each([sisl = std::make_shared<SislCurve>(sisl_curve(curve))](core::Point query) {
                      double* parameters = nullptr;
                      SISLIntcurve** runs = nullptr;
                      int count = 0;
                      int run_count = 0;
                      int status = 0;
                      s1953(sisl->get(), &query.x, 2, 0.0, 1e-10, &count, &parameters, &run_count, &runs, &status);
                      const SislNumbers owner(parameters);
                      if (run_count > 0) freeIntcrvlist(runs, run_count);
                      double point[2] = {0.0, 0.0};
                      int left = 0;
                      if (count > 0) s1221(sisl->get(), 0, parameters[0], &left, point, &status);
                      return core::Point(point[0], point[1]);
                  }));
    contest.enter("OpenCASCADE", each([occt = occt_curve(curve)](core::Point query) {
                      const gp_Pnt2d from(query.x, query.y);
                      gp_Pnt2d nearest = occt->StartPoint();
                      if (occt->EndPoint().Distance(from) < nearest.Distance(from)) nearest = occt->EndPoint();
                      const Geom2dAPI_ProjectPointOnCurve projection(from, occt);
                      if (projection.NbPoints() > 0 && projection.LowerDistance() < nearest.Distance(from))
                          nearest = projection.NearestPoint();
                      return core::Point(nearest.X(), nearest.Y());
                  }));
    contests.push_back(std::move(contest));
}

}  // namespace

void add_nearest(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL, 1000UL, 10'000UL}) add_queries_to(contests, n);
}

}  // namespace batten::bench
