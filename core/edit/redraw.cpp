#include "core/edit/redraw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/detail/banded_least_squares.h"
#include "core/curve/detail/edit_checks.h"
#include "core/edit/detail/redrawn_knots.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"

namespace batten::core {

namespace {

constexpr std::size_t most_spans_of_part = 60;
constexpr std::size_t places_of_shape = 600;
constexpr std::size_t sites_of_span = 6;
constexpr int corrections = 4;

// The shape by shares of its way, in the direction of the part.
class ShapeWay {
  public:
    ShapeWay(const Curve& shape, bool is_backward) {
        const Interval domain = shape.domain();
        for (std::size_t k = 0; k <= places_of_shape; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(places_of_shape);
            points_.push_back(point_at(shape, domain.lower + domain.length() * (is_backward ? 1.0 - share : share)));
        }
        ways_.push_back(0.0);
        for (std::size_t k = 1; k < points_.size(); ++k)
            ways_.push_back(ways_.back() + distance(points_[k - 1], points_[k]));
    }

    double length() const { return ways_.back(); }
    Point first() const { return points_.front(); }
    Point last() const { return points_.back(); }

    Point at(double share) const {
        const auto [k, part] = place_of(share);
        return points_[k] + part * (points_[k + 1] - points_[k]);
    }
    Vector direction(double share) const {
        const auto [k, part] = place_of(share);
        const Vector leg = points_[k + 1] - points_[k];
        const double size = core::length(leg);
        return size > 0.0 ? leg / size : Vector{};
    }

  private:
    struct Place {
        std::size_t leg;
        double part;
    };
    Place place_of(double share) const {
        const double way = std::clamp(share, 0.0, 1.0) * length();
        const auto above = std::upper_bound(ways_.begin() + 1, ways_.end() - 1, way);
        const auto k = static_cast<std::size_t>(above - ways_.begin()) - 1;
        const double leg = ways_[k + 1] - ways_[k];
        return {k, leg > 0.0 ? (way - ways_[k]) / leg : 0.0};
    }

    std::vector<Point> points_;
    std::vector<double> ways_;
};

// From 1 to 0 without a jump of curvature.
double fading(double x) {
    if (x >= 1.0) return 0.0;
    const double left = 1.0 - x;
    return left * left * left * (1.0 + 3.0 * x + 6.0 * x * x);
}

class PartFitter {
  public:
    PartFitter(const Curve& curve, const RedrawnPart& part, ShapeWay shape)
        : curve_(curve), part_(part), shape_(std::move(shape)) {
        const Interval domain = curve.domain();
        is_free_before_ = !curve.is_periodic() && part.from == domain.lower;
        is_free_behind_ = !curve.is_periodic() && part.to == domain.upper;
        if (!is_free_before_) lead_in_ = point_at(curve, part.from) - shape_.first();
        if (!is_free_behind_) lead_out_ = point_at(curve, part.to) - shape_.last();
    }

    std::optional<Approximation> over(std::size_t spans) const {
        const auto knots = redrawn_knots(curve_, part_, spans);
        if (!knots) return std::nullopt;
        auto points = redrawn_points(curve_, part_, *knots);
        if (!points) return std::nullopt;
        std::vector<Site> sites = first_sites(spans);
        std::optional<Curve> found;
        for (int round = 0; round <= corrections; ++round) {
            if (round > 0) correct(sites, *found);
            if (!solve(*knots, sites, *points)) return std::nullopt;
            auto curve = Curve::make(*knots, points->points, points->weights);
            if (!curve) return std::nullopt;
            found = *std::move(curve);
        }
        return Approximation{*found, error_of(*found, sites)};
    }

  private:
    // Where in the domain which place of the shape is met.
    struct Site {
        double u;
        double share;
    };

    // The new part leads from the curve to the shape on so much of the way.
    double reach(Vector lead) const { return std::min(0.45 * shape_.length(), 8.0 * length(lead)); }

    Point target(double share) const {
        const double way = share * shape_.length();
        Point target = shape_.at(share);
        if (lead_in_ != Vector{}) target += fading(way / reach(lead_in_)) * lead_in_;
        if (lead_out_ != Vector{}) target += fading((shape_.length() - way) / reach(lead_out_)) * lead_out_;
        return target;
    }

    // The speed of what stays, as shares of the shape for the part's whole length.
    double speed_at(double u, Side side, bool is_free) const {
        const double speed = length(derivatives_at(curve_, curve_.knots().into_domain(u, side), 1, side)[1]);
        return is_free ? 1.0 : std::clamp(speed * part_.length() / shape_.length(), 0.05, 3.0);
    }

    std::vector<Site> first_sites(std::size_t spans) const {
        const double first = speed_at(part_.from, Side::left, is_free_before_);
        const double last = speed_at(part_.to, Side::right, is_free_behind_);
        const std::size_t count = sites_of_span * spans;
        std::vector<Site> sites;
        for (std::size_t k = 0; k <= count; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(count);
            const double share = first * t * (1.0 - t) * (1.0 - t) + t * t * (3.0 - 2.0 * t) - last * t * t * (1.0 - t);
            sites.push_back({part_.from + part_.length() * t, share});
        }
        return sites;
    }

    // The places of the shape that are nearest to where the curve is, in order.
    void correct(std::vector<Site>& sites, const Curve& curve) const {
        for (std::size_t k = 1; k + 1 < sites.size(); ++k) {
            const Vector off = at(curve, sites[k].u) - target(sites[k].share);
            const double moved = sites[k].share + dot(off, shape_.direction(sites[k].share)) / shape_.length();
            sites[k].share = std::clamp(moved, sites[k - 1].share, 1.0);
        }
    }

    Point at(const Curve& curve, double u) const { return point_at(curve, wrapped(curve, u)); }

    static double wrapped(const Curve& curve, double u) {
        const Interval domain = curve.domain();
        return curve.is_periodic() && !domain.contains(u) ? curve.knots().into_domain(u) : u;
    }

    bool solve(const KnotVector& knots, const std::vector<Site>& sites, RedrawnPoints& points) const {
        const auto p = static_cast<std::size_t>(knots.degree());
        const std::size_t n = points.points.size();
        const Point origin = shape_.first();
        std::vector<BandedEquation<Vector>> equations;
        for (const Site& site : sites) {
            const BasisValues basis = basis_functions(knots, knots.into_domain(site.u));
            double sum = 0.0;
            for (std::size_t j = 0; j <= p; ++j)
                sum += basis.derivatives[0][j] * points.weights[(basis.span - p + j) % n];
            BandedEquation<Vector> equation{.right = target(site.share) - origin};
            bool has_free = false;
            for (std::size_t j = 0; j <= p; ++j) {
                const std::size_t i = (basis.span - p + j) % n;
                const double share = basis.derivatives[0][j] * points.weights[i] / sum;
                const std::size_t number = points.number_of_free(i);
                if (number >= points.count) {
                    equation.right -= share * (points.points[i] - origin);
                    continue;
                }
                if (!has_free) equation.first = number;
                has_free = true;
                equation.coefficients.push_back(share);
            }
            if (has_free) equations.push_back(std::move(equation));
        }
        const auto found = solve_least_squares(equations, points.count);
        if (!found) return false;
        for (std::size_t k = 0; k < points.count; ++k) points.points[(points.first + k) % n] = origin + (*found)[k];
        return true;
    }

    double error_of(const Curve& curve, const std::vector<Site>& sites) const {
        double largest = 0.0;
        for (std::size_t k = 1; k < sites.size(); ++k)
            for (const double share : {0.0, 0.5}) {
                const double u = sites[k].u - share * (sites[k].u - sites[k - 1].u);
                const double way = sites[k].share - share * (sites[k].share - sites[k - 1].share);
                largest = std::max(largest, std::abs(cross(shape_.direction(way), at(curve, u) - target(way))));
            }
        return largest;
    }

    const Curve& curve_;
    RedrawnPart part_;
    ShapeWay shape_;
    bool is_free_before_ = false;
    bool is_free_behind_ = false;
    Vector lead_in_{0.0, 0.0};
    Vector lead_out_{0.0, 0.0};
};

// How far the part is from the shape on average.
double mean_distance(const Curve& curve, const RedrawnPart& part, const NearestFinder& shape) {
    constexpr int places = 32;
    double sum = 0.0;
    for (int k = 0; k < places; ++k) {
        const Point point = point_at(curve, curve.knots().into_domain(part.from + part.length() * (k + 0.5) / places));
        sum += distance(point, shape.nearest(point).point);
    }
    return sum / places;
}

struct ChosenPart {
    RedrawnPart part;
    bool is_backward;
};

std::optional<ChosenPart> chosen_part(const Curve& curve, const Curve& shape) {
    const NearestFinder finder(curve);
    const Interval way = shape.domain();
    double first = finder.nearest(point_at(shape, way.lower)).u;
    double last = finder.nearest(point_at(shape, way.upper)).u;
    const Interval domain = curve.domain();
    if (curve.is_periodic()) {
        if (first == domain.upper) first = domain.lower;
        if (last == domain.upper) last = domain.lower;
    }
    if (first == last) return std::nullopt;
    const ChosenPart inner{{std::min(first, last), std::max(first, last)}, first > last};
    if (!curve.is_periodic()) return inner;
    const ChosenPart outer{{inner.part.to, inner.part.from + domain.length()}, !inner.is_backward};
    const NearestFinder shape_finder(shape);
    return mean_distance(curve, inner.part, shape_finder) <= mean_distance(curve, outer.part, shape_finder) ? inner
                                                                                                            : outer;
}

}  // namespace

Result<Approximation> redraw(const Curve& curve, const Curve& shape, double tolerance) {
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    const auto chosen = chosen_part(curve, shape);
    if (!chosen) {
        const double u = nearest_point(curve, point_at(shape, shape.domain().lower)).u;
        return refuse({.code = CurveErrorCode::range_empty, .lower = u, .upper = u});
    }
    const PartFitter fitter(curve, chosen->part, ShapeWay(shape, chosen->is_backward));
    std::optional<Approximation> best;
    const auto least = static_cast<std::size_t>(curve.degree()) + 1;
    // A corner of the shape is not met by ever more knots.
    const std::size_t most = least + std::min(most_spans_of_part, 2 * shape.control_points().size());
    for (std::size_t spans = least; spans <= most; spans += 1 + spans / 3) {
        auto found = fitter.over(spans);
        if (found && (!best || found->error < 0.9 * best->error)) best = std::move(found);
        if (best && best->error <= tolerance) break;
    }
    if (!best) return refuse({.code = CurveErrorCode::not_computable});
    return *std::move(best);
}

}  // namespace batten::core
