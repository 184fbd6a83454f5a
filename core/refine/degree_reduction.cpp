#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/detail/banded_least_squares.h"
#include "core/base/detail/dense_least_squares.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/blossom.h"
#include "core/measure/detail/joint_relation.h"
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

// One equation for the control points: sum values[j] P_{first + j} = right.
struct Condition {
    std::size_t first = 0;
    std::vector<double> values;
    HomogeneousPoint right{0.0};
};

// One for each site: that the splines agree there.
std::vector<Condition> agreements(const Curve& curve, const KnotVector& knots, std::span<const Site> sites) {
    std::vector<Condition> rows;
    for (const Site& site : sites) {
        BasisValues basis = basis_functions(knots, site.u, 0, site.side);
        rows.push_back({basis.span - static_cast<std::size_t>(knots.degree()), std::move(basis.derivatives[0]),
                        homogeneous_at(curve, site)});
    }
    return rows;
}

// Both sides of a joint of the curve, for the spline over `knots`: derivative `order` behind it less sum factors[r]
// times derivative r before it, which shall be 0.
Condition relation_at(const JointContinuity& joint, const Curve& curve, const KnotVector& knots, std::size_t order,
                      std::span<const double> factors) {
    const std::size_t n = knots.control_point_count();
    const BasisValues before = basis_functions(knots, parameter_before(curve, joint), 2, Side::left);
    const BasisValues after = basis_functions(knots, joint.u, 2, Side::right);
    const std::size_t count = after.derivatives[order].size();
    const std::size_t shift = (after.span + n - before.span % n) % n;
    Condition row{before.span - static_cast<std::size_t>(knots.degree()), std::vector<double>(shift + count, 0.0)};
    for (std::size_t j = 0; j < count; ++j) {
        row.values[shift + j] += after.derivatives[order][j];
        for (std::size_t r = 0; r < factors.size(); ++r) row.values[j] -= factors[r] * before.derivatives[r][j];
    }
    return row;
}

// The denominator of `curve` and its derivatives.
std::array<double, 3> weights_at(const Curve& curve, double u, Side side) {
    const BasisValues basis = basis_functions(curve.knots(), u, 2, side);
    const auto weights = curve.weights();
    std::array<double, 3> sums{};
    for (std::size_t r = 0; r < sums.size(); ++r)
        for (std::size_t j = 0; j < basis.derivatives[r].size(); ++j)
            sums[r] += basis.derivatives[r][j] *
                       weights[(basis.span - static_cast<std::size_t>(curve.degree()) + j) % weights.size()];
    return sums;
}

// What keeps a joint of the curve G1, and G2 for level 2, in homogeneous coordinates A = w C: with C'_+ = b C'_-,
// C''_+ = b^2 C''_- + c C'_- and w_+ = l w_- it is A'_+ = l b A'_- + d A_- and
// A''_+ = l b^2 A''_- + (2 b d + l c) A'_- + e A_-. Weights of ends that meet may differ, else l is 1.
void add_relations(std::vector<Condition>& rows, const Curve& curve, const KnotVector& knots,
                   const JointContinuity& joint, int level) {
    const auto relation = joint_relation(curve, joint, level);
    if (!relation) return;
    const auto before = weights_at(curve, parameter_before(curve, joint), Side::left);
    const auto after = weights_at(curve, joint.u, Side::right);
    const double b = relation->scale;
    const double l = joint.kind == JointKind::ends ? after[0] / before[0] : 1.0;
    const double d = (after[1] - l * b * before[1]) / before[0];
    rows.push_back(relation_at(joint, curve, knots, 1, std::array{d, l * b}));
    if (level < 2) return;
    const double middle = 2.0 * b * d + l * relation->shift;
    const double e = (after[2] - l * b * b * before[2] - middle * before[1]) / before[0];
    rows.push_back(relation_at(joint, curve, knots, 2, std::array{e, middle, l * b * b}));
}

// What keeps ends that meet smooth, if beside the conditions at knots as many points stay free as one piece has: with
// fewer the curve would shrink to a line or to its end.
void add_relations_of_ends(std::vector<Condition>& rows, const Curve& curve, const KnotVector& knots) {
    const JointContinuity ends = continuity_of_ends(curve);
    const int level = std::min({ends.geometric, knots.degree() - 1, 2});
    if (level < 1) return;
    const std::size_t needed = rows.size() + static_cast<std::size_t>(level + knots.degree()) + 1;
    if (needed < knots.control_point_count()) add_relations(rows, curve, knots, ends, level);
}

// What keeps the curve smooth where it is so by its shape and the lower degree would not: G2 at most, and no more than
// simple knots have in that degree.
std::vector<Condition> kept_smoothness(const Curve& curve, const KnotVector& knots) {
    std::vector<Condition> rows;
    for (const JointContinuity& joint : joint_continuity_within(curve, curve.domain())) {
        const int multiplicity = knots.multiplicity(joint.u);
        const int level = std::min({joint.geometric, knots.degree() - 1, 2});
        if (multiplicity > 0 && level > knots.degree() - multiplicity) add_relations(rows, curve, knots, joint, level);
    }
    if (!curve.is_periodic()) add_relations_of_ends(rows, curve, knots);
    for (Condition& row : rows) {
        double size = 0.0;
        for (const double value : row.values) size = std::hypot(size, value);
        for (double& value : row.values) value /= size;
    }
    return rows;
}

DenseEquations dense_equations(std::span<const Condition> rows, std::size_t n) {
    DenseEquations equations{.columns = n, .matrix = std::vector<double>(rows.size() * n)};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < rows[i].values.size(); ++j)
            equations.matrix[i * n + (rows[i].first + j) % n] += rows[i].values[j];
        equations.right.push_back(rows[i].right);
    }
    return equations;
}

// The places of n unknowns in which the equations have a narrow band, even where they tie the last ones to the first.
std::vector<std::size_t> band_order(std::span<const Condition> rows, std::size_t n) {
    const bool is_ring = std::ranges::any_of(rows, [n](const auto& row) { return row.first + row.values.size() > n; });
    std::vector<std::size_t> places(n);
    for (std::size_t i = 0; i < n; ++i) places[i] = is_ring ? folded(i, n) : i;
    return places;
}

std::vector<BandedEquation<HomogeneousPoint>> banded_equations(std::span<const Condition> rows,
                                                               std::span<const std::size_t> places) {
    const std::size_t n = places.size();
    std::vector<BandedEquation<HomogeneousPoint>> equations;
    for (const Condition& row : rows) {
        std::size_t lowest = n;
        std::size_t highest = 0;
        for (std::size_t j = 0; j < row.values.size(); ++j) {
            lowest = std::min(lowest, places[(row.first + j) % n]);
            highest = std::max(highest, places[(row.first + j) % n]);
        }
        auto& equation = equations.emplace_back(BandedEquation<HomogeneousPoint>{lowest, {}, row.right});
        equation.coefficients.assign(highest - lowest + 1, 0.0);
        for (std::size_t j = 0; j < row.values.size(); ++j)
            equation.coefficients[places[(row.first + j) % n] - lowest] += row.values[j];
    }
    return equations;
}

// The control points over `knots` that fulfill the equations.
std::vector<HomogeneousPoint> solution_of(std::span<const Condition> rows, const KnotVector& knots,
                                          const Progress& progress) {
    const std::size_t n = knots.control_point_count();
    const auto places = band_order(rows, n);
    if (n > largest_dense_system)
        if (const auto x = solve_least_squares(banded_equations(rows, places), n, progress)) {
            std::vector<HomogeneousPoint> points(n);
            for (std::size_t i = 0; i < n; ++i) points[i] = (*x)[places[i]];
            return points;
        }
    // Periodic systems may be singular; the smallest of the best solutions is then taken.
    return solve_least_squares(dense_equations(rows, n));
}

HomogeneousPoint missed(const Condition& row, std::span<const HomogeneousPoint> points) {
    HomogeneousPoint sum = -row.right;
    for (std::size_t j = 0; j < row.values.size(); ++j) sum += row.values[j] * points[(row.first + j) % points.size()];
    return sum;
}

double largest_coordinate(const HomogeneousPoint& point) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

// Whether the points fulfill the equations but for rounding.
bool are_met(std::span<const Condition> rows, std::span<const HomogeneousPoint> points) {
    constexpr double rounding = 1e-11;
    double largest = 0.0;
    for (const HomogeneousPoint& point : points) largest = std::max(largest, largest_coordinate(point));
    return std::ranges::all_of(
        rows, [&](const Condition& row) { return largest_coordinate(missed(row, points)) <= rounding * largest; });
}

// The control points that agree with the curve as well as they can and keep `kept` exactly, by the method of
// multipliers: each pass makes up for what the one before lacked.
std::vector<HomogeneousPoint> constrained(std::span<const Condition> agreeing, std::span<const Condition> kept,
                                          const KnotVector& knots, const Progress& progress) {
    constexpr int passes = 4;
    constexpr double outweighing = 1e4;
    std::vector<HomogeneousPoint> lacking(kept.size(), HomogeneousPoint(0.0));
    std::vector<HomogeneousPoint> points;
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<Condition> rows(agreeing.begin(), agreeing.end());
        for (std::size_t k = 0; k < kept.size(); ++k) {
            Condition row = kept[k];
            for (double& value : row.values) value *= outweighing;
            row.right = outweighing * (kept[k].right - lacking[k]);
            rows.push_back(std::move(row));
        }
        points = solution_of(rows, knots, part_of(progress, static_cast<double>(pass) / passes, (pass + 1.0) / passes));
        for (std::size_t k = 0; k < kept.size(); ++k) lacking[k] += missed(kept[k], points);
    }
    return points;
}

// The control points over `knots` for which the spline agrees with `curve` at the sites; where more is asked of them,
// at the ends, and elsewhere as well as it can.
std::vector<HomogeneousPoint> points_at_sites(const Curve& curve, const KnotVector& knots, std::span<const Site> sites,
                                              const Progress& progress) {
    const std::vector<Condition> agreeing = agreements(curve, knots, sites);
    std::vector<Condition> kept = kept_smoothness(curve, knots);
    std::vector<HomogeneousPoint> points = solution_of(agreeing, knots, part_of(progress, 0.0, 0.5));
    if (are_met(kept, points)) return points;
    if (!knots.is_periodic()) {
        kept.push_back(agreeing.front());
        kept.push_back(agreeing.back());
    }
    return constrained(agreeing, kept, knots, part_of(progress, 0.5, 1.0));
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
Result<Curve> interpolated(const Curve& curve, KnotVector knots, const Progress& progress) {
    const std::vector<Site> sites = interpolation_sites(knots);
    const std::vector<HomogeneousPoint> points = points_at_sites(curve, knots, sites, progress);
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

Result<Curve> reduce_periodic(const Curve& curve, const Progress& progress) {
    std::vector<double> period = reduced_period(curve.knots().stored());
    if (period.size() < 3)
        return tl::unexpected(CurveError{
            .code = CurveErrorCode::too_few_points, .value = static_cast<double>(period.size() - 1), .lower = 2.0});
    return KnotVector::make_periodic(curve.degree() - 1, std::move(period), curve.knots().kind())
        .and_then([&](KnotVector knots) { return interpolated(curve, std::move(knots), progress); });
}

Result<Curve> reduce_open(const Curve& curve, const Progress& progress) {
    const int degree = curve.degree() - 1;
    const Tears tears = curve.is_torn() ? Tears::allow : Tears::refuse;
    const std::vector<double> values = reduced_values(curve.knots());
    const auto target = KnotVector::make(degree, values, curve.knots().kind(), tears);
    if (!target) return tl::unexpected(target.error());
    return KnotVector::make(degree, clamped(values, static_cast<std::size_t>(degree), curve.domain()),
                            curve.knots().kind(), tears)
        .and_then([&](KnotVector knots) { return interpolated(curve, std::move(knots), progress); })
        .and_then([&](const Curve& reduced) {
            return is_clamped(curve.knots()) ? reduced : unclamped(reduced, *target, curve);
        });
}

Result<Curve> moved(const Curve& curve, Vector by) {
    CurveDefinition definition = curve.definition();
    for (Point& point : definition.points) point += by;
    return Curve::make(std::move(definition));
}

}  // namespace

Result<Curve> reduce_degree(const Curve& curve, const Progress& progress) {
    if (curve.degree() <= min_degree)
        return tl::unexpected(
            CurveError{.code = CurveErrorCode::degree_out_of_range, .value = static_cast<double>(curve.degree() - 1)});
    // Near the origin, because the equations lose as many digits as coordinates are larger than the curve.
    const Vector from_origin = vector_to(middle_of(curve));
    const bool is_end_kept = !curve.is_periodic() && is_clamped(curve.knots());
    return moved(curve, -from_origin)
        .and_then([&](const Curve& near) {
            return near.is_periodic() ? reduce_periodic(near, progress) : reduce_open(near, progress);
        })
        .and_then([&](const Curve& reduced) { return moved(reduced, from_origin); })
        .and_then([&](const Curve& reduced) { return is_end_kept ? with_ends_of(curve, reduced) : reduced; });
}

}  // namespace batten::core
