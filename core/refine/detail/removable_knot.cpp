#include "core/refine/detail/removable_knot.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/evaluate/evaluate.h"
#include "core/measure/deviation.h"
#include "core/refine/detail/spline_removal.h"

namespace batten::core {

namespace {

// Whether the knots at the upper end of the period become fewer: a seam's only knot at the lower end stays.
bool is_from_upper_end(const Curve& curve, const CarriedSpline& spline, const RemovableKnot& knot) {
    const bool is_seam = curve.is_periodic() && spline.knots[knot.index] == curve.domain().lower;
    return is_seam && (knot.from_upper_end || knot.index == removal_offset(curve));
}

// The points on which the curve depends wherever the removal reaches.
std::span<const CarriedPoint> points_around(const CarriedSpline& spline, const RemovableKnot& knot) {
    const std::size_t first = knot.first > spline.p ? knot.first - spline.p : 0;
    const std::size_t end = std::min(knot.first + knot.replaced + spline.p, spline.points.size());
    return std::span(spline.points).subspan(first, end - first);
}

// The curve moves by (dA - C dw) / (w + dw). Where point i moves by w_i times `error` at most, dA and dw are w times it
// at most.
double bound_of(const CarriedSpline& spline, const RemovableKnot& knot, HomogeneousPoint error) {
    if (error.z == 0.0) return robust_length(plane_part(error));
    if (!(std::abs(error.z) < 1.0)) return std::numeric_limits<double>::infinity();
    const Point near = project(spline.points[knot.first].point);
    double reach = 0.0;
    for (const CarriedPoint& around : points_around(spline, knot))
        reach = std::max(reach, distance(near, project(around.point)));
    const double moved = length(plane_part(error) - vector_to(near) * error.z) + reach * std::abs(error.z);
    return moved / (1.0 - std::abs(error.z));
}

// The curve of the points around the knot, before or without it; none where it has no room in double precision.
Result<Curve> curve_around(const CarriedSpline& spline, const RemovableKnot& knot, bool is_removed) {
    const std::size_t first = knot.first > spline.p ? knot.first - spline.p : 0;
    const std::size_t end = std::min(knot.first + knot.replaced + spline.p, spline.points.size());
    CurveDefinition around{.degree = static_cast<int>(spline.p), .tears = Tears::allow};
    for (std::size_t i = first; i <= end + spline.p; ++i)
        if (!is_removed || i != knot.index) around.knots.push_back(spline.knots[i]);
    const auto add = [&](const CarriedPoint& point) {
        around.points.push_back(project(point.point));
        around.weights.push_back(point.point.z);
    };
    for (std::size_t i = first; i < end; ++i) {
        const bool is_replaced = knot.first <= i && i < knot.first + knot.replaced;
        if (!is_removed || !is_replaced) add(spline.points[i]);
        if (is_removed && i == knot.first) std::for_each(knot.points.begin(), knot.points.end(), add);
    }
    return Curve::make(std::move(around));
}

// The two sides of a tear are pulled together, to the middle of them.
double close_tear(const CarriedSpline& spline, RemovableKnot& knot) {
    knot.first = knot.index - spline.p - 1;
    knot.replaced = 2;
    const CarriedPoint& left = spline.points[knot.first];
    const CarriedPoint& right = spline.points[knot.first + 1];
    const CarriedPoint error = (1.0 / (left.point.z + right.point.z)) * (right - left);
    knot.points = {left + left.point.z * error};
    return bound_of(spline, knot, error.point);
}

std::vector<double> stored_without(const Curve& curve, const CarriedSpline& spline,
                                   std::span<const RemovableKnot> removed) {
    const auto stored = curve.knots().stored();
    const std::size_t offset = removal_offset(curve);
    std::vector<bool> is_removed(stored.size(), false);
    for (const RemovableKnot& knot : removed)
        is_removed[is_from_upper_end(curve, spline, knot) ? stored.size() - 1 : knot.index - offset] = true;
    std::vector<double> knots;
    for (std::size_t i = 0; i < stored.size(); ++i)
        if (!is_removed[i]) knots.push_back(stored[i]);
    return knots;
}

// The points from the first replaced one on; all of them, or one period.
std::vector<CarriedPoint> points_without(const CarriedSpline& spline, std::span<const RemovableKnot> removed,
                                         std::size_t first, std::size_t end) {
    std::vector<CarriedPoint> points;
    std::size_t i = first;
    const auto copy_until = [&](std::size_t stop) {
        for (; i < stop; ++i) points.push_back(spline.points[i]);
    };
    for (const RemovableKnot& knot : removed) {
        copy_until(knot.first);
        points.insert(points.end(), knot.points.begin(), knot.points.end());
        i += knot.replaced;
    }
    copy_until(end);
    return points;
}

}  // namespace

CarriedSpline unrolled_for_removal(const Curve& curve) {
    return carried(curve, 1);
}

std::size_t removal_offset(const Curve& curve) {
    return curve.is_periodic() ? static_cast<std::size_t>(curve.degree()) + curve.control_points().size() : 0;
}

bool has_room_for_removal(const Curve& curve) {
    return !curve.is_periodic() || curve.control_points().size() > static_cast<std::size_t>(curve.degree()) + 1;
}

std::vector<std::size_t> removable_indices(const Curve& curve, const CarriedSpline& spline) {
    const Interval domain = curve.domain();
    const bool is_periodic = curve.is_periodic();
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i + 1 < spline.knots.size(); ++i) {
        const double u = spline.knots[i];
        if (u == spline.knots[i + 1]) continue;
        const bool is_inside = domain.lower < u && u < domain.upper;
        const bool is_multiple_seam = is_periodic && u == domain.lower && spline.knots[i - 1] == u;
        if (is_inside || is_multiple_seam) indices.push_back(i);
    }
    return indices;
}

std::optional<RemovableKnot> removable_knot(const CarriedSpline& spline, std::size_t index) {
    const std::size_t p = spline.p;
    assert(p < index && index < spline.points.size() && spline.knots[index] < spline.knots[index + 1]);
    const double u = spline.knots[index];
    std::size_t multiplicity = 1;
    while (multiplicity <= p && spline.knots[index - multiplicity] == u) ++multiplicity;
    RemovableKnot knot{.index = index, .first = index - p, .replaced = p + 1 - multiplicity, .points = {}};
    if (multiplicity > p) {
        knot.bound = close_tear(spline, knot);
    } else {
        std::array<Ratio, max_degree> ratios;
        std::array<double, max_degree> weights;
        for (std::size_t j = 0; j < knot.replaced; ++j) {
            const std::size_t i = knot.first + j;
            ratios[j] = ratio_between(spline.knots[i], spline.knots[i + p + 1], u);
            weights[j] = spline.points[i].point.z;
        }
        // Moved in proportion to their weights, all points move by much the same in the plane.
        auto found =
            removal<CarriedPoint>(std::span(ratios).first(knot.replaced), std::span(weights).first(knot.replaced),
                                  std::span(spline.points).subspan(knot.first - 1, knot.replaced + 2));
        knot.points = std::move(found.points);
        knot.bound = bound_of(spline, knot, found.error.point);
    }
    if (!std::ranges::all_of(knot.points, [](const CarriedPoint& point) { return point.point.z > 0.0; }))
        return std::nullopt;
    return knot;
}

double nearer_bound(const CarriedSpline& spline, const RemovableKnot& knot, double most) {
    const auto before = curve_around(spline, knot, false);
    const auto after = curve_around(spline, knot, true);
    if (!before || !after) return knot.bound;
    const double u = spline.knots[knot.index];
    if (distance(point_at(*before, u), point_at(*after, u)) > most) return knot.bound;
    return std::min(knot.bound, largest_deviation(*before, *after));
}

Result<Curve> without_knots(const Curve& curve, const CarriedSpline& spline, std::span<const RemovableKnot> removed) {
    assert(!removed.empty());
    assert(std::adjacent_find(removed.begin(), removed.end(), [&](const RemovableKnot& a, const RemovableKnot& b) {
               return b.index < a.index + spline.p + 2;
           }) == removed.end());
    CarriedForm form{.degree = curve.degree(),
                     .knots = stored_without(curve, spline, removed),
                     .is_periodic = curve.is_periodic(),
                     .kind = curve.knots().kind()};
    if (!curve.is_periodic())
        return settled(curve, std::move(form), points_without(spline, removed, 0, spline.points.size()));
    const std::size_t n = curve.control_points().size();
    const std::size_t first = removed.front().first;
    const std::vector<CarriedPoint> turned = points_without(spline, removed, first, first + n);
    // Point 0 is p places before the lower end of the period; at a seam that is another one of its knots than before if
    // one is taken from those of the upper end.
    const std::size_t offset = removal_offset(curve);
    const std::size_t end_of_period = is_from_upper_end(curve, spline, removed.front()) ? offset - 1 : offset;
    const std::size_t count = turned.size();
    std::vector<CarriedPoint> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(turned[(end_of_period - spline.p + i + 2 * count - first % count) % count]);
    return settled(curve, std::move(form), points);
}

}  // namespace batten::core
