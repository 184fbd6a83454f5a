// The curve at a distance beside another one, within a tolerance.
#include "core/edit/offset.h"

#include <cmath>
#include <memory>

#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "curve_numbers.h"
#include "inputs.h"
#include "works.h"

namespace batten::bench {

namespace {

constexpr double distance = 0.05;
constexpr double tolerance = 1e-6;
constexpr int sample_count = 200;

// A wave that bends less than the offset could follow.
core::Curve gentle(std::size_t n) {
    core::CurveDefinition definition = spiral(n).definition();
    for (std::size_t i = 0; i < n; ++i)
        definition.points[i] = {static_cast<double>(i), std::sin(0.4 * static_cast<double>(i))};
    return core::Curve::make(std::move(definition)).value();
}

// How far points of the offset are from the curve.
class DistancesFrom {
  public:
    explicit DistancesFrom(const core::Curve& curve) : finder_(std::make_shared<core::NearestFinder>(curve)) {}

    Numbers operator()(const core::Result<core::Approximation>& result) const {
        return sampled([&](double share) { return core::point_at(result->curve, share); });
    }
    Numbers operator()(const SislCurve& curve) const {
        const double lower = curve->et[0];
        const double length = curve->et[curve->in] - lower;
        return sampled([&](double share) {
            double point[2] = {0.0, 0.0};
            int left = 0;
            int status = 0;
            s1221(curve.get(), 0, lower + share * length, &left, point, &status);
            return core::Point(point[0], point[1]);
        });
    }

  private:
    template <class PointAt>
    Numbers sampled(const PointAt& point_at) const {
        Numbers distances;
        for (int i = 1; i < sample_count; ++i) {
            const core::Point point = point_at(static_cast<double>(i) / sample_count);
            distances.push_back(core::distance(finder_->nearest(point).point, point));
        }
        return distances;
    }

    std::shared_ptr<core::NearestFinder> finder_;
};

void add_offset_of(Contests& contests, std::size_t n) {
    const core::Curve curve = gentle(n);
    Contest contest("offset/n:" + std::to_string(n), 1.0, 10.0 * tolerance / distance);
    contest.enter(
        "Batten", [curve] { return core::offset(curve, distance, tolerance); }, DistancesFrom(curve));
    contest.enter(
        "SISL",
        [sisl = std::make_shared<SislCurve>(sisl_curve(curve))] {
            SISLCurve* beside = nullptr;
            int status = 0;
            double normal[3] = {0.0, 0.0, 1.0};
            s1360(sisl->get(), distance, tolerance, normal, 0.0, 2, &beside, &status);
            return SislCurve(beside);
        },
        DistancesFrom(curve));
    contests.push_back(std::move(contest));
}

}  // namespace

void add_offset(Contests& contests) {
    for (const std::size_t n : {10UL, 100UL}) add_offset_of(contests, n);
}

}  // namespace batten::bench
