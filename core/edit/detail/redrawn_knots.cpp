#include "core/edit/detail/redrawn_knots.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "core/evaluate/blossom.h"

namespace batten::core {

namespace {

// Knots nearer to each other, beside the domain, are one.
constexpr double same_knot = 1e-12;

double period_of(const Curve& curve) {
    return curve.is_periodic() ? curve.domain().length() : 0.0;
}

bool is_start(const Curve& curve, double u) {
    return !curve.is_periodic() && u == curve.domain().lower;
}
bool is_end(const Curve& curve, double u) {
    return !curve.is_periodic() && u == curve.domain().upper;
}

// A spline of degree p over so many equal knots has two derivatives, or p - 1 where these are fewer.
std::size_t multiplicity_of_joint(const Curve& curve, double u) {
    const int wanted = std::max(1, curve.degree() - 2);
    return static_cast<std::size_t>(std::max(wanted, curve.knots().multiplicity(curve.knots().into_domain(u))));
}

void add_even(std::vector<double>& knots, const RedrawnPart& part, std::size_t spans) {
    for (std::size_t k = 1; k < spans; ++k)
        knots.push_back(part.from + part.length() * static_cast<double>(k) / static_cast<double>(spans));
}

// The knots of a closed curve over the period that ends where the part does.
std::vector<double> knots_up_to_part(const Curve& curve, const RedrawnPart& part, std::size_t spans) {
    const double start = part.to - period_of(curve);
    std::vector<double> knots(multiplicity_of_joint(curve, start), start);
    for (const double knot : curve.knots().stored())
        if (start < knot && knot < part.from) knots.push_back(knot);
    knots.insert(knots.end(), multiplicity_of_joint(curve, part.from), part.from);
    add_even(knots, part, spans);
    knots.push_back(part.to);
    return knots;
}

std::vector<double> knots_around_part(const Curve& curve, const RedrawnPart& part, std::size_t spans) {
    const auto stored = curve.knots().stored();
    std::vector<double> knots;
    const auto add_joint = [&](double u, bool is_seam_copy) {
        const std::size_t times = is_seam_copy ? 1 : multiplicity_of_joint(curve, u);
        knots.insert(knots.end(), times, u);
    };
    if (is_start(curve, part.from)) {
        std::ranges::copy_if(stored, std::back_inserter(knots), [&](double u) { return u <= part.from; });
    } else {
        std::ranges::copy_if(stored, std::back_inserter(knots), [&](double u) { return u < part.from; });
        add_joint(part.from, false);
    }
    add_even(knots, part, spans);
    if (is_end(curve, part.to)) {
        std::ranges::copy_if(stored, std::back_inserter(knots), [&](double u) { return u >= part.to; });
    } else {
        add_joint(part.to, curve.is_periodic() && part.to == curve.domain().upper);
        std::ranges::copy_if(stored, std::back_inserter(knots), [&](double u) { return u > part.to; });
    }
    return knots;
}

// What stays of the curve, asked for control points over the new knots.
class Remainder {
  public:
    Remainder(const Curve& curve, const RedrawnPart& part) : curve_(curve), part_(part), period_(period_of(curve)) {}

    // The old control point that belongs to these p knots, whole periods aside.
    std::optional<std::size_t> old_point(std::span<const double> arguments) const {
        const std::span<const double> knots = curve_.knots().values();
        const double tolerance = same_knot * curve_.domain().length();
        for (const double shift : shifts()) {
            const auto near = [&](double a, double b) {
                return a == b + shift || std::abs(a - b - shift) <= tolerance;
            };
            const auto first = std::ranges::lower_bound(knots, arguments.front() - shift - tolerance);
            for (auto at = first; at != knots.end() && *at <= arguments.front() - shift + tolerance; ++at) {
                const auto left = static_cast<std::size_t>(knots.end() - at);
                const auto place = static_cast<std::size_t>(at - knots.begin());
                if (place == 0 || left <= arguments.size()) continue;
                if (std::equal(arguments.begin(), arguments.end(), at, near))
                    return (place - 1) % curve_.control_points().size();
            }
        }
        return std::nullopt;
    }

    // The control point of the piece that ends at the part, or of the one that begins there.
    HomogeneousPoint before(std::span<const double> arguments) const {
        return piece_point(part_.from, Side::left, arguments);
    }
    HomogeneousPoint behind(std::span<const double> arguments) const {
        return piece_point(part_.to, Side::right, arguments);
    }

    // Whole periods that bring a support to the part.
    std::vector<double> shifts() const {
        if (period_ == 0.0) return {0.0};
        return {0.0, period_, -period_};
    }

  private:
    HomogeneousPoint piece_point(double u, Side side, std::span<const double> arguments) const {
        const double inside = curve_.knots().into_domain(u, side);
        const double nearest = arguments[arguments.size() / 2];
        const double shift = period_ == 0.0 ? 0.0 : period_ * std::round((inside - nearest) / period_);
        std::vector<double> shifted(arguments.begin(), arguments.end());
        for (double& argument : shifted) argument += shift;
        return blossom(curve_, curve_.knots().span_at(inside, side), shifted);
    }

    const Curve& curve_;
    RedrawnPart part_;
    double period_;
};

// How the support of a new control point lies beside the part.
enum class Support { inside, before, behind };

Support support_of(double first, double last, const Remainder& remainder, const RedrawnPart& part, const Curve& curve) {
    const double slack = same_knot * curve.domain().length();
    for (const double shift : remainder.shifts()) {
        const bool begins_inside = first + shift >= part.from - slack || is_start(curve, part.from);
        const bool ends_inside = last + shift <= part.to + slack || is_end(curve, part.to);
        if (begins_inside && ends_inside) return Support::inside;
    }
    for (const double shift : remainder.shifts())
        if (first + shift < part.from - slack && last + shift >= part.from - slack) return Support::before;
    return Support::behind;
}

// Of a closed curve whose seam is a multiple knot some of them are behind it.
void number_free_points(RedrawnPoints& found, const std::vector<bool>& is_free, bool is_periodic) {
    for (std::size_t i = 0; i < is_free.size(); ++i) {
        const bool follows_one = i > 0 ? is_free[i - 1] : is_periodic && is_free.back();
        if (is_free[i] && !follows_one) found.first = i;
    }
    found.count = static_cast<std::size_t>(std::ranges::count(is_free, true));
}

// From what stays before to what stays behind.
void blend_free_weights(RedrawnPoints& found, bool is_periodic) {
    const std::size_t n = found.weights.size();
    const std::size_t end = found.first + found.count;
    const bool has_before = found.first > 0 || is_periodic;
    const bool has_behind = end < n || is_periodic;
    const double after = has_behind ? found.weights[end % n] : 1.0;
    const double first = has_before ? found.weights[(found.first + n - 1) % n] : after;
    const double last = has_behind ? after : first;
    for (std::size_t k = 0; k < found.count; ++k) {
        const double share = static_cast<double>(k + 1) / static_cast<double>(found.count + 1);
        found.weights[(found.first + k) % n] = first + share * (last - first);
    }
}

}  // namespace

Result<KnotVector> redrawn_knots(const Curve& curve, const RedrawnPart& part, std::size_t spans) {
    const bool is_through_seam = curve.is_periodic() && part.to > curve.domain().upper;
    if (is_through_seam) return KnotVector::make_periodic(curve.degree(), knots_up_to_part(curve, part, spans));
    std::vector<double> knots = knots_around_part(curve, part, spans);
    return curve.is_periodic() ? KnotVector::make_periodic(curve.degree(), std::move(knots))
                               : KnotVector::make(curve.degree(), std::move(knots), KnotKind::custom,
                                                  curve.is_torn() ? Tears::allow : Tears::refuse);
}

std::optional<RedrawnPoints> redrawn_points(const Curve& curve, const RedrawnPart& part, const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const Remainder remainder(curve, part);
    RedrawnPoints found;
    const std::size_t n = knots.control_point_count();
    std::vector<bool> is_free(n, false);
    for (std::size_t i = 0; i < n; ++i) {
        const Support support = support_of(knots[i], knots[i + p + 1], remainder, part, curve);
        if (support == Support::inside) {
            is_free[i] = true;
            found.points.emplace_back(0.0, 0.0);
            found.weights.push_back(curve.weights().front());
            continue;
        }
        const std::span<const double> arguments = knots.values().subspan(i + 1, p);
        if (const auto old = remainder.old_point(arguments)) {
            found.points.push_back(curve.control_points()[*old]);
            found.weights.push_back(curve.weights()[*old]);
            continue;
        }
        const HomogeneousPoint point =
            support == Support::before ? remainder.before(arguments) : remainder.behind(arguments);
        if (!(point.z > 0.0) || !is_finite(point)) return std::nullopt;
        found.points.push_back(project(point));
        found.weights.push_back(curve.is_rational() ? point.z : curve.weights().front());
    }
    number_free_points(found, is_free, curve.is_periodic());
    if (found.count == 0 || (curve.is_periodic() && found.count == n)) return std::nullopt;
    if (curve.is_rational()) blend_free_weights(found, curve.is_periodic());
    return found;
}

}  // namespace batten::core
