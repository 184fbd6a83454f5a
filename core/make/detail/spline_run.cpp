#include "core/make/detail/spline_run.h"

#include "core/evaluate/detail/spline_system.h"

namespace batten::core {

namespace {

// Row i of the equations for derivatives: below d_{i-1} + 2 d_i + above d_{i+1} = right. Its own number is larger than
// the others together, so that elimination needs no pivots.
struct DerivativeRow {
    double below = 0.0;
    double above = 0.0;
    Vector right{};
};

class CubicRun {
  public:
    explicit CubicRun(const SplineRun& run) : run_(run), last_(run.places.size() - 1) {}

    std::vector<Point> control_points() const {
        const std::vector<Vector> d = derivatives();
        std::vector<Point> points{place(0), place(0) + length(0) / 3.0 * d[0]};
        points.reserve(last_ + 3);
        for (std::size_t i = 1; i < last_; ++i) {
            // The blossom at the parameters before, at and after point i, which is affine in the first of them.
            const Point near = place(i) + length(i) / 3.0 * d[i];
            const Point far = place(i + 1) - length(i) / 3.0 * d[i + 1];
            points.push_back(near - length(i - 1) / length(i) * (far - near));
        }
        points.push_back(place(last_) - length(last_ - 1) / 3.0 * d[last_]);
        points.push_back(place(last_));
        return points;
    }

  private:
    Point place(std::size_t i) const { return run_.places[i]; }
    double length(std::size_t i) const { return run_.parameters[i + 1] - run_.parameters[i]; }
    Vector slope(std::size_t i) const { return (1.0 / length(i)) * (place(i + 1) - place(i)); }

    DerivativeRow row(std::size_t i) const {
        if (i == 0 && run_.start) return {0.0, 0.0, 2.0 * *run_.start};
        if (i == last_ && run_.end) return {0.0, 0.0, 2.0 * *run_.end};
        if (i == 0) return {0.0, 1.0, 3.0 * slope(0)};
        if (i == last_) return {1.0, 0.0, 3.0 * slope(last_ - 1)};
        const double share = length(i) / (length(i - 1) + length(i));
        return {share, 1.0 - share, 3.0 * (share * slope(i - 1) + (1.0 - share) * slope(i))};
    }

    std::vector<Vector> derivatives() const {
        std::vector<Vector> right(last_ + 1);
        std::vector<double> above(last_ + 1);
        for (std::size_t i = 0; i <= last_; ++i) {
            const DerivativeRow own = row(i);
            const double pivot = i == 0 ? 2.0 : 2.0 - own.below * above[i - 1];
            above[i] = own.above / pivot;
            right[i] = (1.0 / pivot) * (i == 0 ? own.right : own.right - own.below * right[i - 1]);
        }
        for (std::size_t i = last_; i-- > 0;) right[i] -= above[i] * right[i + 1];
        return right;
    }

    const SplineRun& run_;
    std::size_t last_;
};

constexpr std::size_t fair_degree = 5;

// An end of a run of degree 5; its conditions count as much as others where they are in the units of the span there.
void require_end(SplineSystem& system, double u, double length, bool has_tangent) {
    const double cube = length * length * length;
    system.require_derivative(u, 3, {0.0, 0.0}, cube);
    if (!has_tangent) system.require_derivative(u, 4, {0.0, 0.0}, cube * length);
}

Point between(Point a, Point b, double share) {
    return a + share * (b - a);
}

}  // namespace

std::vector<Point> cubic_run(const SplineRun& run) {
    return CubicRun(run).control_points();
}

Result<std::vector<Point>> quintic_run(const SplineRun& run) {
    constexpr std::size_t p = fair_degree;
    const std::span<const double> u = run.parameters;
    const Point first = run.places.front();
    const Point last = run.places.back();
    if (u.size() == 2 && !run.start && !run.end) {
        std::vector<Point> line(p + 1, last);
        for (std::size_t j = 0; j < p; ++j) line[j] = between(first, last, static_cast<double>(j) / p);
        return line;
    }
    std::vector<double> knots(p, u.front());
    knots.insert(knots.end(), u.begin(), u.end());
    knots.insert(knots.end(), p, u.back());
    auto vector = KnotVector::make(static_cast<int>(p), std::move(knots));
    if (!vector) return refuse(vector.error());
    const std::size_t count = vector->control_point_count();
    const double first_length = u[1] - u[0];
    const double last_length = u.back() - u[u.size() - 2];
    EndPoints ends{.known = {{0, first}, {count - 1, last}}};
    if (run.start) ends.known.push_back({1, first + first_length / p * *run.start});
    if (run.end) ends.known.push_back({count - 2, last - last_length / p * *run.end});
    SplineSystem system(*std::move(vector), first, ends);
    require_end(system, u.front(), first_length, run.start.has_value());
    for (std::size_t k = 1; k + 1 < u.size(); ++k) system.require_point(u[k], run.places[k]);
    require_end(system, u.back(), last_length, run.end.has_value());
    auto points = system.solve();
    if (!points) return refuse({.code = CurveErrorCode::equations_singular});
    points->front() = first;
    points->back() = last;
    return *std::move(points);
}

}  // namespace batten::core
