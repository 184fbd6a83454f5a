#include <algorithm>

#include "core/base/detail/banded_least_squares.h"
#include "core/base/detail/dense_least_squares.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/blossom.h"
#include "core/refine/degree.h"

namespace batten::core {

namespace {

// Beyond this many unknowns the band of the matrix is worth its trouble.
constexpr std::size_t largest_dense_system = 64;

struct KnotRun {
    double value = 0.0;
    std::size_t length = 0;
};

std::vector<KnotRun> runs_of(std::span<const double> knots) {
    std::vector<KnotRun> runs;
    for (const double knot : knots) {
        if (runs.empty() || runs.back().value != knot) runs.push_back({knot, 0});
        ++runs.back().length;
    }
    return runs;
}

std::vector<double> knots_of(std::span<const KnotRun> runs) {
    std::vector<double> knots;
    for (const KnotRun& run : runs) knots.insert(knots.end(), run.length, run.value);
    return knots;
}

void shorten(KnotRun& run) {
    if (run.length > 1) --run.length;
}

// One period in the lower degree. The seam's run lies at both ends, and one of its knots is counted twice.
std::vector<double> reduced_period(std::span<const double> period) {
    std::vector<KnotRun> runs = runs_of(period);
    for (std::size_t i = 1; i + 1 < runs.size(); ++i) shorten(runs[i]);
    shorten(runs.front().length > 1 ? runs.front() : runs.back());
    return knots_of(runs);
}

// The full vector in the lower degree. An end of the domain stands one place nearer to the end of the vector, either
// because its own run became shorter or because the outermost knot is left out.
std::vector<double> reduced_values(const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const Interval domain = knots.domain();
    const bool lower_shortens = knots[p - 1] == domain.lower;
    const bool upper_shortens = knots[knots.size() - p] == domain.upper;
    std::vector<KnotRun> runs = runs_of(knots.values());
    for (KnotRun& run : runs) {
        const bool is_inside = domain.lower < run.value && run.value < domain.upper;
        const bool is_shortened_end =
            (run.value == domain.lower && lower_shortens) || (run.value == domain.upper && upper_shortens);
        if (is_inside || is_shortened_end) shorten(run);
    }
    if (!lower_shortens) --runs.front().length;
    if (!upper_shortens) --runs.back().length;
    return knots_of(runs);
}

// The same knots inside the domain between ends of full multiplicity.
std::vector<double> clamped(std::span<const double> values, std::size_t q, Interval domain) {
    std::vector<double> knots(q + 1, domain.lower);
    for (const double knot : values)
        if (domain.lower < knot && knot < domain.upper) knots.push_back(knot);
    knots.insert(knots.end(), q + 1, domain.upper);
    return knots;
}

// Where control point j is decided: its Greville abscissa, seen from the side on which it acts.
struct Site {
    double u = 0.0;
    Side side = Side::right;
};

std::vector<Site> interpolation_sites(const KnotVector& knots) {
    const auto q = static_cast<std::size_t>(knots.degree());
    std::vector<Site> sites;
    for (const double u : greville_abscissae(knots)) {
        const std::size_t j = sites.size();
        const bool acts_left_only = !knots.is_periodic() && knots[j + 1] == knots[j + q + 1];
        sites.push_back({u, acts_left_only ? Side::left : Side::right});
    }
    return sites;
}

HomogeneousPoint homogeneous_at(const Curve& curve, const Site& site) {
    const std::vector<double> arguments(static_cast<std::size_t>(curve.degree()), site.u);
    return blossom(curve, curve.knots().span_at(site.u, site.side), arguments);
}

// The basis functions at one site, of which the row of its equation consists.
struct SiteBasis {
    std::size_t first = 0;
    std::vector<double> values;
};

SiteBasis basis_at(const KnotVector& knots, const Site& site) {
    BasisValues basis = basis_functions(knots, site.u, 0, site.side);
    return {basis.span - static_cast<std::size_t>(knots.degree()), std::move(basis.derivatives[0])};
}

DenseEquations dense_equations(const Curve& curve, const KnotVector& knots, std::span<const Site> sites) {
    const std::size_t n = sites.size();
    DenseEquations equations{.columns = n, .matrix = std::vector<double>(n * n)};
    for (std::size_t i = 0; i < n; ++i) {
        const SiteBasis row = basis_at(knots, sites[i]);
        for (std::size_t j = 0; j < row.values.size(); ++j)
            equations.matrix[i * n + (row.first + j) % n] += row.values[j];
        equations.right.push_back(homogeneous_at(curve, sites[i]));
    }
    return equations;
}

std::vector<BandedEquation<HomogeneousPoint>> banded_equations(const Curve& curve, const KnotVector& knots,
                                                               std::span<const Site> sites) {
    const std::size_t n = sites.size();
    const auto unknown = [&](std::size_t i) { return knots.is_periodic() ? folded(i % n, n) : i; };
    std::vector<BandedEquation<HomogeneousPoint>> equations;
    for (const Site& site : sites) {
        const SiteBasis row = basis_at(knots, site);
        std::size_t lowest = n;
        std::size_t highest = 0;
        for (std::size_t j = 0; j < row.values.size(); ++j) {
            lowest = std::min(lowest, unknown(row.first + j));
            highest = std::max(highest, unknown(row.first + j));
        }
        auto& equation = equations.emplace_back(BandedEquation<HomogeneousPoint>{
            lowest, std::vector<double>(highest - lowest + 1), homogeneous_at(curve, site)});
        for (std::size_t j = 0; j < row.values.size(); ++j)
            equation.coefficients[unknown(row.first + j) - lowest] += row.values[j];
    }
    return equations;
}

// The control points over `knots` for which the spline agrees with `curve` at the sites.
std::vector<HomogeneousPoint> points_at_sites(const Curve& curve, const KnotVector& knots,
                                              std::span<const Site> sites) {
    const std::size_t n = sites.size();
    if (n > largest_dense_system)
        if (const auto x = solve_least_squares(banded_equations(curve, knots, sites), n)) {
            std::vector<HomogeneousPoint> points(n);
            for (std::size_t i = 0; i < n; ++i) points[i] = (*x)[knots.is_periodic() ? folded(i, n) : i];
            return points;
        }
    // Periodic systems may be singular; the smallest of the best solutions is then taken.
    return solve_least_squares(dense_equations(curve, knots, sites));
}

// The curve of these points, rational if `before` is.
Result<Curve> projected(KnotVector knots, std::span<const HomogeneousPoint> homogeneous, const Curve& before) {
    std::vector<Point> points;
    std::vector<double> weights;
    for (const HomogeneousPoint& point : homogeneous) {
        if (point.z == 0.0)
            return refuse({.code = CurveErrorCode::weight_not_positive, .index = points.size(), .value = point.z});
        points.push_back(project(point));
        // Rounding must not make a polynomial curve rational.
        weights.push_back(before.is_rational() ? point.z : before.weights().front());
    }
    return Curve::make(std::move(knots), std::move(points), std::move(weights));
}

// The spline over `knots` that agrees with `curve` at the sites of the control points, in homogeneous coordinates.
Result<Curve> interpolated(const Curve& curve, KnotVector knots) {
    const std::vector<Site> sites = interpolation_sites(knots);
    const std::vector<HomogeneousPoint> points = points_at_sites(curve, knots, sites);
    return projected(std::move(knots), points, curve);
}

// The clamped curve over other knots outside the same domain: control point j is the blossom at its knots, of any piece
// on which it acts. Points that act nowhere are as many as in the curve before, and stay.
Result<Curve> unclamped(const Curve& clamped_curve, KnotVector knots, const Curve& before) {
    const auto q = static_cast<std::size_t>(knots.degree());
    const std::size_t count = knots.control_point_count();
    const auto point_at_knots = [&](std::size_t j) {
        if (knots[j + q + 1] <= knots.domain().lower) return before.homogeneous_point(j);
        if (knots[j] >= knots.domain().upper)
            return before.homogeneous_point(before.control_points().size() - (count - j));
        const auto arguments = knots.values().subspan(j + 1, q);
        const double inside = arguments.front() + 0.5 * (arguments.back() - arguments.front());
        const Side side = knots[j + q + 1] == inside ? Side::left : Side::right;
        return blossom(clamped_curve, clamped_curve.knots().span_at(inside, side), arguments);
    };
    std::vector<HomogeneousPoint> points;
    for (std::size_t j = 0; j < count; ++j) points.push_back(point_at_knots(j));
    return projected(std::move(knots), points, before);
}

Result<Curve> with_ends_of(const Curve& curve, const Curve& reduced) {
    CurveDefinition definition = reduced.definition();
    definition.points.front() = curve.control_points().front();
    definition.points.back() = curve.control_points().back();
    definition.weights.front() = curve.weights().front();
    definition.weights.back() = curve.weights().back();
    return Curve::make(std::move(definition));
}

Result<Curve> reduce_periodic(const Curve& curve) {
    std::vector<double> period = reduced_period(curve.knots().stored());
    if (period.size() < 3)
        return tl::unexpected(CurveError{
            .code = CurveErrorCode::too_few_points, .value = static_cast<double>(period.size() - 1), .lower = 2.0});
    return KnotVector::make_periodic(curve.degree() - 1, std::move(period), curve.knots().kind())
        .and_then([&](KnotVector knots) { return interpolated(curve, std::move(knots)); });
}

Result<Curve> reduce_open(const Curve& curve) {
    const int degree = curve.degree() - 1;
    const Tears tears = curve.is_torn() ? Tears::allow : Tears::refuse;
    const std::vector<double> values = reduced_values(curve.knots());
    const auto target = KnotVector::make(degree, values, curve.knots().kind(), tears);
    if (!target) return tl::unexpected(target.error());
    const bool is_end_kept = is_clamped(curve.knots());
    return KnotVector::make(degree, clamped(values, static_cast<std::size_t>(degree), curve.domain()),
                            curve.knots().kind(), tears)
        .and_then([&](KnotVector knots) { return interpolated(curve, std::move(knots)); })
        .and_then([&](const Curve& reduced) {
            return is_end_kept ? with_ends_of(curve, reduced) : unclamped(reduced, *target, curve);
        });
}

}  // namespace

Result<Curve> reduce_degree(const Curve& curve) {
    if (curve.degree() <= min_degree)
        return tl::unexpected(
            CurveError{.code = CurveErrorCode::degree_out_of_range, .value = static_cast<double>(curve.degree() - 1)});
    return curve.is_periodic() ? reduce_periodic(curve) : reduce_open(curve);
}

}  // namespace batten::core
