#include "core/edit/point_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/detail/trusted.h"
#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/edit/detail/gap_list.h"
#include "core/evaluate/farin_points.h"

namespace batten::core {

namespace {

Result<void> check_finite(Point position, std::size_t index) {
    if (is_finite(position)) return {};
    return tl::unexpected(CurveError{.code = CurveErrorCode::point_not_finite, .index = index});
}

// The knots of the curve's special kind for one control point more or less; none when its kind has none for that
// number.
std::optional<Result<KnotVector>> regenerated_knots(const Curve& curve, std::size_t point_count) {
    const KnotKind kind = curve.knots().kind();
    if (kind == KnotKind::custom) return std::nullopt;
    const int degree = kind == KnotKind::bezier ? static_cast<int>(point_count) - 1 : curve.degree();
    auto knots = make_knots(kind, degree, point_count, curve.domain());
    if (!knots && knots.error().code == CurveErrorCode::kind_not_possible) return std::nullopt;
    return knots;
}

// A span that a new knot may halve: the nearest is best, and of equally near ones the longest.
struct SpanChoice {
    double middle = 0.0;
    double distance = 0.0;
    double length = 0.0;

    bool is_better_than(const SpanChoice& other) const {
        return distance < other.distance || (distance == other.distance && length > other.length);
    }
};

// The middle of the span nearest to `near` among the spans first..last that can be halved.
std::optional<double> halving_knot(const KnotVector& knots, std::size_t first, std::size_t last, double near) {
    std::optional<SpanChoice> best;
    for (std::size_t s = first; s <= last; ++s) {
        const Interval span{knots[s], knots[s + 1]};
        const SpanChoice choice{span.lower + 0.5 * span.length(), std::abs(near - span.clamp(near)), span.length()};
        const bool is_divisible = span.lower < choice.middle && choice.middle < span.upper;
        if (is_divisible && (!best || choice.is_better_than(*best))) best = choice;
    }
    if (!best) return std::nullopt;
    return best->middle;
}

// The knot that comes with a control point before point `index`: in one of the spans over which both points of the leg
// act, or where all of these are empty in the nearest one that is not.
std::optional<double> knot_for_point(const KnotVector& knots, std::size_t index) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const std::size_t count = knots.control_point_count();
    const std::size_t last_span = knots.size() - p - 2;
    const std::size_t before = index == 0 ? 0 : index - 1;
    const std::size_t after = !knots.is_periodic() && index == count ? count - 1 : index;
    const double near = 0.5 * (greville_abscissa(knots, before) + greville_abscissa(knots, after));
    const std::size_t first = std::clamp(index, p, last_span);
    const std::size_t last = std::clamp(index + p - 1, first, last_span);
    if (const auto knot = halving_knot(knots, first, last, near)) return knot;
    return halving_knot(knots, p, last_span, near);
}

// Interpolated where `position` lies along the leg from the point before to the point after.
double weight_on_leg(const Curve& curve, std::size_t index, Point position) {
    const auto points = curve.control_points();
    const auto weights = curve.weights();
    const std::size_t count = points.size();
    const bool is_beyond_end = !curve.is_periodic() && (index == 0 || index == count);
    if (is_beyond_end) return index == 0 ? weights.front() : weights.back();
    const std::size_t before = (index + count - 1) % count;
    const std::size_t after = index % count;
    const Vector leg = points[after] - points[before];
    const double length_squared = dot(leg, leg);
    const double along = length_squared == 0.0 ? 0.5 : dot(position - points[before], leg) / length_squared;
    const double share = std::clamp(along, 0.0, 1.0);
    return weights[before] * (1.0 - share) + weights[after] * share;
}

// The stored knots, of which some are taken out near one another.
class KnotsToTakeOut {
  public:
    explicit KnotsToTakeOut(const KnotVector& knots)
        : is_periodic_(knots.is_periodic()),
          p_(static_cast<std::size_t>(knots.degree())),
          stored_({knots.stored().begin(), knots.stored().end()}),
          period_(knots.domain()) {}

    // The inner knot (of the period, or of the domain) nearest to the Greville abscissa of control point `index`.
    void take_out_with_point(std::size_t index) {
        const double greville = greville_abscissa(index);
        const std::size_t first_inner = is_periodic_ ? 1 : p_ + 1;
        const std::size_t end_inner = stored_.size() - first_inner;
        std::size_t low = first_inner;
        for (std::size_t high = end_inner; low < high;) {
            const std::size_t half = low + (high - low) / 2;
            if (stored_[half] < greville)
                low = half + 1;
            else
                high = half;
        }
        const bool is_lower_nearest =
            low > first_inner && (low == end_inner || greville - stored_[low - 1] <= stored_[low] - greville);
        stored_.take_out(is_lower_nearest ? low - 1 : low);
    }

    std::vector<double> rest() { return stored_.rest(); }

  private:
    // Of the unrolled curve, not brought into the domain.
    double greville_abscissa(std::size_t index) const {
        double sum = 0.0;
        for (std::size_t k = index + 1; k <= index + p_; ++k) sum += unrolled(k);
        return sum / static_cast<double>(p_);
    }
    double unrolled(std::size_t k) const {
        if (!is_periodic_) return stored_[k];
        double turns_back = 0.0;
        std::size_t i = k;
        for (; i < p_; i += stored_.size() - 1) turns_back += 1.0;
        return turns_back == 0.0 ? stored_[i - p_] : stored_[i - p_] - turns_back * period_.length();
    }

    bool is_periodic_;
    std::size_t p_;
    GapList<double> stored_;
    Interval period_;
};

template <class T>
auto at(std::vector<T>& list, std::size_t index) {
    return list.begin() + static_cast<std::ptrdiff_t>(index);
}

std::vector<Point> points_of(const Curve& curve) {
    return {curve.control_points().begin(), curve.control_points().end()};
}

Result<Curve> over(Result<KnotVector> knots, CurveDefinition definition) {
    if (!knots) return tl::unexpected(knots.error());
    return Curve::make(std::move(*knots), std::move(definition.points), std::move(definition.weights));
}

}  // namespace

Result<Curve> set_control_point(const Curve& curve, std::size_t index, Point position) {
    if (auto check = check_point_index(index, curve.control_points().size() - 1); !check)
        return tl::unexpected(check.error());
    if (auto check = check_finite(position, index); !check) return tl::unexpected(check.error());
    std::vector<Point> points = points_of(curve);
    points[index] = position;
    return Trusted::with_points(curve, std::move(points));
}

Result<Curve> move_control_points(const Curve& curve, std::span<const std::size_t> indices, Vector offset) {
    std::vector<Point> points = points_of(curve);
    for (const std::size_t index : indices) {
        if (auto check = check_point_index(index, points.size() - 1); !check) return tl::unexpected(check.error());
        points[index] = curve.control_points()[index] + offset;
        if (auto check = check_finite(points[index], index); !check) return tl::unexpected(check.error());
    }
    return Trusted::with_points(curve, std::move(points));
}

double soft_share(Point point, Point center, double radius) {
    const double share = distance(point, center) / radius;
    return share < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
}

Result<Curve> soft_move(const Curve& curve, Point center, double radius, Vector offset,
                        std::span<const std::size_t> pinned) {
    if (!(radius > 0.0) || !std::isfinite(radius))
        return refuse({.code = CurveErrorCode::length_not_positive, .value = radius});
    if (!is_finite(vector_to(center)) || !is_finite(offset)) return refuse({.code = CurveErrorCode::vector_not_finite});
    CurveDefinition definition = curve.definition();
    for (std::size_t i = 0; i < definition.points.size(); ++i) {
        const double share = soft_share(definition.points[i], center, radius);
        if (share > 0.0 && !std::ranges::binary_search(pinned, i)) definition.points[i] += share * offset;
    }
    return Curve::make(std::move(definition));
}

Result<Curve> set_weight(const Curve& curve, std::size_t index, double weight) {
    if (auto check = check_point_index(index, curve.control_points().size() - 1); !check)
        return tl::unexpected(check.error());
    CurveDefinition definition = curve.definition();
    definition.weights[index] = weight;
    return over(curve.knots(), std::move(definition));
}

Result<Curve> set_farin_share(const Curve& curve, std::size_t leg, double share) {
    if (auto check = check_point_index(leg, leg_count(curve) - 1); !check) return tl::unexpected(check.error());
    if (!(0.0 < share && share < 1.0)) return refuse({.code = CurveErrorCode::share_out_of_range, .value = share});
    CurveDefinition definition = curve.definition();
    std::vector<double>& weights = definition.weights;
    const std::size_t after = (leg + 1) % weights.size();
    const double weight = share == 0.5 ? weights[leg] : weights[leg] * (share / (1.0 - share));
    const double factor = weight / weights[after];
    weights[after] = weight;
    if (!curve.is_periodic())
        for (std::size_t i = after + 1; i < weights.size(); ++i) weights[i] *= factor;
    return over(curve.knots(), std::move(definition));
}

Result<Curve> add_control_point(const Curve& curve, std::size_t index, Point position) {
    const std::size_t count = curve.control_points().size();
    const auto check = check_point_index(index, count).and_then([&] { return check_finite(position, index); });
    if (!check) return tl::unexpected(check.error());
    if (curve.is_periodic() && index == 0) index = count;
    CurveDefinition definition = curve.definition();
    definition.weights.insert(at(definition.weights, index), weight_on_leg(curve, index, position));
    definition.points.insert(at(definition.points, index), position);
    if (auto knots = regenerated_knots(curve, count + 1)) return over(*std::move(knots), std::move(definition));
    const auto knot = knot_for_point(curve.knots(), index);
    if (!knot)
        return tl::unexpected(CurveError{.code = CurveErrorCode::multiplicity_full,
                                         .value = curve.domain().lower,
                                         .upper = static_cast<double>(curve.degree())});
    definition.knots.insert(std::upper_bound(definition.knots.begin(), definition.knots.end(), *knot), *knot);
    return Curve::make(std::move(definition));
}

namespace {

// The fewest points that deleting leaves.
std::size_t least_points(const Curve& curve) {
    const bool may_have_two = curve.is_periodic() || curve.knots().kind() == KnotKind::bezier;
    return may_have_two ? 2 : static_cast<std::size_t>(curve.degree()) + 1;
}

// The rest of the values, `gone` ascending.
template <class T>
std::vector<T> without(std::span<const T> values, std::span<const std::size_t> gone) {
    std::vector<T> rest;
    rest.reserve(values.size() - gone.size());
    std::size_t first = 0;
    for (const std::size_t index : gone) {
        rest.insert(rest.end(), values.begin() + static_cast<std::ptrdiff_t>(first),
                    values.begin() + static_cast<std::ptrdiff_t>(index));
        first = index + 1;
    }
    rest.insert(rest.end(), values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
    return rest;
}

}  // namespace

Result<Curve> delete_control_point(const Curve& curve, std::size_t index) {
    return delete_control_points(curve, std::span(&index, 1));
}

Result<Curve> delete_control_points(const Curve& curve, std::span<const std::size_t> indices) {
    if (indices.empty()) return curve;
    const std::size_t count = curve.control_points().size();
    std::vector<std::size_t> gone(indices.begin(), indices.end());
    std::sort(gone.begin(), gone.end());
    assert(std::adjacent_find(gone.begin(), gone.end()) == gone.end());
    if (auto check = check_point_index(gone.back(), count - 1); !check) return tl::unexpected(check.error());
    const std::size_t least = least_points(curve);
    if (count < least + gone.size())
        return tl::unexpected(CurveError{.code = CurveErrorCode::too_few_points,
                                         .value = static_cast<double>(least - 1),
                                         .lower = static_cast<double>(least)});
    CurveDefinition definition = curve.definition();
    definition.points = without(curve.control_points(), gone);
    definition.weights = without(curve.weights(), gone);
    // A kind that knows no number between is given up at the first point.
    if (regenerated_knots(curve, count - 1))
        if (auto knots = regenerated_knots(curve, count - gone.size()))
            return over(*std::move(knots), std::move(definition));
    KnotsToTakeOut knots(curve.knots());
    for (std::size_t k = gone.size(); k-- > 0;) knots.take_out_with_point(gone[k]);
    definition.knots = knots.rest();
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
