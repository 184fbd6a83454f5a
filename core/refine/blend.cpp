#include "core/refine/blend.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/detail/binomial.h"
#include "core/measure/arc_length.h"
#include "core/refine/detail/changed_start.h"

namespace batten::core {

namespace {

constexpr std::size_t most_given = 4;

// The curves are followed by no more than so many radians, and their change of curvature turns by half as many.
constexpr double most_turn = 5.0;
constexpr double most_change = 10.0;

// The length of the curve is looked for until it changes by less than this part.
constexpr double natural_accuracy = 1e-9;
constexpr int most_trials = 60;

Result<void> check_side(const Passing& passing, BlendSide side) {
    if (!(side.tension > 0.0) || !std::isfinite(side.tension))
        return refuse({.code = CurveErrorCode::tension_not_positive, .value = side.tension});
    const int order = order_of(side.continuity);
    const bool is_known =
        (order < 1 || passing.direction) && (order < 2 || passing.curvature) && (order < 3 || passing.change);
    if (!is_known) return refuse({.code = CurveErrorCode::end_stands_still});
    return {};
}

double speed_at(const Passing& passing, BlendSide side, double length) {
    double speed = length;
    const int order = order_of(side.continuity);
    if (order >= 2 && *passing.curvature != 0.0) speed = std::min(speed, most_turn / std::abs(*passing.curvature));
    if (order >= 3 && *passing.change != 0.0)
        speed = std::min(speed, std::sqrt(most_change / std::abs(*passing.change)));
    return side.tension * speed;
}

// The points, seen from the first one, with which a Bézier curve of degree p begins as `passing` goes on, with this
// speed: the k-th difference is the k-th derivative times (p-k)! / p!.
std::array<Vector, most_given> first_points(const Passing& passing, BlendSide side, double speed, std::size_t p) {
    std::array<Vector, most_given> points{};
    const auto count = static_cast<std::size_t>(order_of(side.continuity)) + 1;
    const Vector tangent = passing.direction.value_or(Vector(0.0, 0.0));
    const Vector normal = turned_left(tangent);
    const double bend = passing.curvature.value_or(0.0) * speed;
    const std::array<Vector, most_given> derivatives{
        Vector(0.0, 0.0), speed * tangent, bend * speed * normal,
        -bend * bend * speed * tangent + passing.change.value_or(0.0) * speed * speed * speed * normal};
    double factor = 1.0;
    for (std::size_t r = 1; r < count; ++r) {
        factor /= static_cast<double>(p - r + 1);
        const Vector difference = factor * derivatives[r];
        double binomial = 1.0;
        for (std::size_t k = r; k < count; ++k) {
            if (k > r) binomial *= static_cast<double>(k) / static_cast<double>(k - r);
            points[k] += binomial * difference;
        }
    }
    return points;
}

struct BlendEnds {
    Passing from;
    BlendSide first;
    Passing back;  // the end run through the other way
    BlendSide second;

    // Seen from the point where it begins.
    Result<Curve> of_length(double length) const {
        const auto at_first = static_cast<std::size_t>(order_of(first.continuity)) + 1;
        const auto at_second = static_cast<std::size_t>(order_of(second.continuity)) + 1;
        const std::size_t p = at_first + at_second - 1;
        const auto begin = first_points(from, first, speed_at(from, first, length), p);
        const auto end = first_points(back, second, speed_at(back, second, length), p);
        CurveDefinition definition{.degree = static_cast<int>(p), .kind = KnotKind::bezier};
        definition.knots.assign(p + 1, 0.0);
        definition.knots.insert(definition.knots.end(), p + 1, 1.0);
        for (std::size_t k = 0; k < at_first; ++k) definition.points.push_back(tip_of(begin[k]));
        for (std::size_t k = at_second; k-- > 0;) definition.points.push_back(tip_of(back.point - from.point + end[k]));
        return Curve::make(std::move(definition));
    }

    // What makes the curve as long as its speed at both ends says, with a tension of 1.
    Result<double> natural_length() const {
        BlendEnds natural = *this;
        natural.first.tension = natural.second.tension = 1.0;
        double length = robust_length(back.point - from.point);
        for (int trial = 0; trial < most_trials; ++trial) {
            const auto curve = natural.of_length(length);
            if (!curve) return refuse(curve.error());
            const double found = arc_length(*curve).value;
            if (!std::isfinite(found)) return refuse({.code = CurveErrorCode::not_computable});
            if (std::abs(found - length) <= natural_accuracy * found) break;
            length = found;
        }
        return length;
    }
};

}  // namespace

Result<Curve> blend(const Passing& from, BlendSide first, const Passing& to, BlendSide second) {
    if (const auto check = check_side(from, first); !check) return refuse(check.error());
    if (const auto check = check_side(to, second); !check) return refuse(check.error());
    if (from.point == to.point) return refuse({.code = CurveErrorCode::ends_meet});
    const BlendEnds ends{from, first, run_back(to), second};
    auto found = ends.natural_length().and_then([&](double length) { return ends.of_length(length); });
    if (!found) return found;
    CurveDefinition definition = found->definition();
    for (Point& point : definition.points) point += vector_to(from.point);
    definition.points.front() = from.point;
    definition.points.back() = to.point;
    return Curve::make(std::move(definition));
}

Result<Curve> blend(const Curve& first, const Curve& second, JoinedEnds ends, BlendSide at_first, BlendSide at_second) {
    for (const Curve* curve : {&first, &second})
        if (const auto check = check_has_ends(*curve); !check) return refuse(check.error());
    return blend(passing_beyond(first, ends.first), at_first, run_back(passing_beyond(second, ends.second)), at_second);
}

}  // namespace batten::core
