#include "core/refine/corner_cutting.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/curve/detail/bspline.h"
#include "core/curve/detail/edit_checks.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_removal.h"

namespace batten::core {

namespace {

// Where a parameter stands among the knots.
struct Place {
    double u = 0.0;
    std::size_t k = 0;  // of the last knot that is not above it
    std::size_t m = 0;  // how many equal it
};

Result<Place> place_of(const KnotVector& knots, double asked) {
    if (const auto check = check_parameter_finite(asked); !check) return refuse(check.error());
    if (const auto check = check_in_domain(knots, asked); !check) return refuse(check.error());
    // The seam of a period is seen from its right.
    const double u = knots.is_periodic() ? knots.into_domain(asked, Side::right) : asked;
    const auto values = knots.values();
    const auto above = std::upper_bound(values.begin(), values.end(), u);
    return Place{u, static_cast<std::size_t>(above - values.begin()) - 1,
                 static_cast<std::size_t>(knots.multiplicity(u))};
}

// Knot i of the endless vector of a period.
double endless_knot(const KnotVector& knots, std::ptrdiff_t i) {
    const auto n = static_cast<std::ptrdiff_t>(knots.control_point_count());
    const double period = knots.domain().length();
    std::ptrdiff_t periods = 0;
    for (; i < 0; i += n) --periods;
    for (; i >= static_cast<std::ptrdiff_t>(knots.size()); i -= n) ++periods;
    return knots[static_cast<std::size_t>(i)] + static_cast<double>(periods) * period;
}

// The open curve of the points first..first+count-1 and the knots that belong to them; endless where `curve` is.
Result<Curve> local_part(const Curve& curve, std::ptrdiff_t first, std::size_t count) {
    const auto n = static_cast<std::ptrdiff_t>(curve.control_points().size());
    const auto end = first + static_cast<std::ptrdiff_t>(count);
    CurveDefinition part{.degree = curve.degree(), .tears = Tears::allow};
    for (std::ptrdiff_t i = first; i <= end + curve.degree(); ++i)
        part.knots.push_back(curve.is_periodic() ? endless_knot(curve.knots(), i)
                                                 : curve.knots()[static_cast<std::size_t>(i)]);
    for (std::ptrdiff_t i = first; i < end; ++i) {
        const auto index = static_cast<std::size_t>((i % n + n) % n);
        part.points.push_back(curve.control_points()[index]);
        part.weights.push_back(curve.weights()[index]);
    }
    return Curve::make(std::move(part));
}

// The cutting of an open curve, none of whose legs is cut twice.
Result<CornerCutting> open_cutting(const Curve& curve, const Place& place) {
    const auto inserted = insert_knot(curve, place.u);
    if (!inserted) return refuse(inserted.error());
    const auto p = static_cast<std::size_t>(curve.degree());
    CornerCutting cutting{
        .u = place.u, .multiplicity = static_cast<int>(place.m), .corners = {}, .knots = {}, .cuts = {}};
    for (std::size_t i = place.k - p; i <= place.k - place.m + p + 1; ++i) cutting.knots.push_back(curve.knots()[i]);
    for (std::size_t i = place.k - p; i <= place.k - place.m; ++i) {
        cutting.corners.push_back({i, curve.control_points()[i], curve.weights()[i]});
        if (i == place.k - p) continue;
        const Interval knots{curve.knots()[i], curve.knots()[i + p]};
        const double weight = inserted->weights()[i];
        const double alpha = ratio_between(knots.lower, knots.upper, place.u).upper_share;
        cutting.cuts.push_back({.i = i,
                                .new_index = i,
                                .point = inserted->control_points()[i],
                                .weight = weight,
                                .alpha = alpha,
                                .knots = knots,
                                .leg_share = alpha * (curve.weights()[i] / weight)});
    }
    return cutting;
}

// Renumbers what was found in a part of a curve, whose first point was `first` of it and which had `count` points
// before the insertion. That the knot comes into all other periods, too, moves none of the new points.
void renumber(CornerCutting& cutting, std::ptrdiff_t first, std::size_t count) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    const auto turned = [first](std::size_t i, std::ptrdiff_t turn) {
        return static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(i) + first) % turn + turn) % turn);
    };
    for (OldCorner& corner : cutting.corners) corner.index = turned(corner.index, n);
    for (LegCut& cut : cutting.cuts) {
        cut.new_index = turned(cut.i, n + 1);
        cut.i = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cut.i) + first);
    }
}

Result<void> check_cuts(const KnotVector& knots, const Place& place, std::size_t point_count) {
    const auto p = static_cast<std::size_t>(knots.degree());
    if (place.m >= p)
        return refuse({.code = CurveErrorCode::multiplicity_full, .value = place.u, .upper = static_cast<double>(p)});
    if (knots.is_periodic() && p - place.m > point_count)
        return refuse({.code = CurveErrorCode::too_few_points,
                       .value = static_cast<double>(point_count),
                       .lower = static_cast<double>(p - place.m)});
    return {};
}

}  // namespace

Result<CornerCutting> corner_cutting(const Curve& curve, double u) {
    const auto place = place_of(curve.knots(), u);
    if (!place) return refuse(place.error());
    const std::size_t n = curve.control_points().size();
    if (const auto check = check_cuts(curve.knots(), *place, n); !check) return refuse(check.error());
    const auto p = static_cast<std::size_t>(curve.degree());
    // At the end of the domain the insertion is seen from the last span.
    const std::size_t span = std::min(place->k, curve.knots().span_at(place->u));
    const std::size_t first = span - p;
    const auto part = local_part(curve, static_cast<std::ptrdiff_t>(first), p + 1);
    if (!part) return refuse(part.error());
    auto cutting = open_cutting(*part, {place->u, place->k - first, place->m});
    if (cutting) renumber(*cutting, static_cast<std::ptrdiff_t>(first), n);
    return cutting;
}

Result<UndoneCutting> corner_cutting_undone(const Curve& curve, double u) {
    const auto place = place_of(curve.knots(), u);
    if (!place) return refuse(place.error());
    const Interval domain = curve.domain();
    const bool is_end = place->u == domain.lower || place->u == domain.upper;
    if (place->m == 0 || (is_end && (!curve.is_periodic() || place->m == 1)))
        return refuse({.code = CurveErrorCode::knot_not_found, .value = u});
    const Place before{place->u, place->k - 1, place->m - 1};
    const std::size_t n = curve.control_points().size() - 1;
    if (const auto check = check_cuts(curve.knots(), before, n); !check) return refuse(check.error());
    // The points of the spans on both sides of the knot.
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t reach = p + place->m;
    const auto first = static_cast<std::ptrdiff_t>(place->k) - static_cast<std::ptrdiff_t>(reach);
    const auto part = local_part(curve, first, reach + 1);
    if (!part) return refuse(part.error());
    const auto removal = remove_knot(*part, place->u, 1, std::numeric_limits<double>::max());
    if (!removal) return refuse(removal.error());
    if (removal->count == 0) return refuse({.code = CurveErrorCode::not_computable});
    auto cutting = open_cutting(removal->curve, {place->u, reach - 1, before.m});
    if (!cutting) return refuse(cutting.error());
    renumber(*cutting, first, n);
    return UndoneCutting{*std::move(cutting), removal->error};
}

}  // namespace batten::core
