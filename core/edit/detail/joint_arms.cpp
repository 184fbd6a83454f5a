#include "core/edit/detail/joint_arms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/rational_basis.h"

namespace batten::core {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Operations that round, between coordinates and what is compared.
constexpr double roundings = 16.0;
constexpr double same_direction = 1e-13;
constexpr double same_curvature = 1e-11;

// In which sense an arm is run through, where a joint is run through from `before` to `after`.
double sense_of(Side side, bool is_before) {
    return (side == Side::left) == is_before ? 1.0 : -1.0;
}

double size_of_point(Point point) {
    return std::max(std::abs(point.x), std::abs(point.y));
}

double cube(double value) {
    return value * value * value;
}

// What rounding may make of the curvature of a jet.
double rounding_of_curvature(const ArmJet& jet) {
    const double speed = length(jet.first);
    return roundings * epsilon *
           ((jet.second_size * speed + jet.first_size * length(jet.second)) / cube(speed) +
            3.0 * std::abs(curvature_of(jet)) * jet.first_size / speed);
}

}  // namespace

JointArms::JointArms(const std::vector<EditedCurve>& curves, const KeptJoint& joint) {
    const JointArm& before = joint.before;
    const JointArm& after = joint.after;
    add(curves[before.curve], before, &ActingShares::before, sense_of(before.side, true));
    add(curves[after.curve], after, &ActingShares::after, sense_of(after.side, false));
    const Curve& curve = curves[before.curve].curve;
    const bool is_knot = before.curve == after.curve && before.u == after.u;
    has_two_places_ = !is_knot || curve.knots().multiplicity(before.u) > curve.degree();
}

void JointArms::add(const EditedCurve& curve, const JointArm& arm, Member member, double sense) {
    const RationalBasis basis = rational_basis(curve.curve, arm.u, 2, arm.side);
    const std::size_t n = curve.curve.control_points().size();
    for (std::size_t j = 0; j < basis.derivatives[0].size(); ++j) {
        std::array<double, 3> values{basis.derivatives[0][j], sense * basis.derivatives[1][j], basis.derivatives[2][j]};
        if (values == std::array<double, 3>{}) continue;
        const ActingPoint point{arm.curve, (basis.first + j) % n};
        auto found = std::ranges::find_if(shares_, [&](const ActingShares& one) { return one.point == point; });
        if (found == shares_.end()) found = shares_.insert(shares_.end(), ActingShares{.point = point});
        for (std::size_t k = 0; k < values.size(); ++k) (*found.*member)[k] += values[k];
    }
}

ArmJet JointArms::jet(const std::vector<Point>& points, Member member) const {
    // Derivatives do not depend on the origin, and near the points they suffer less from rounding.
    const Point origin = points.front();
    ArmJet jet;
    for (std::size_t j = 0; j < shares_.size(); ++j) {
        const std::array<double, 3>& share = shares_[j].*member;
        const Vector point = points[j] - origin;
        const double size = size_of_point(points[j]);
        jet.place += share[0] * vector_to(points[j]);
        jet.first += share[1] * point;
        jet.second += share[2] * point;
        jet.place_size += std::abs(share[0]) * size;
        jet.first_size += std::abs(share[1]) * size;
        jet.second_size += std::abs(share[2]) * size;
    }
    return jet;
}

std::optional<JointArms::Handle> JointArms::handle(Member member) const {
    Handle handle;
    std::size_t places = 0;
    std::size_t tips = 0;
    for (std::size_t j = 0; j < shares_.size(); ++j) {
        const std::array<double, 3>& share = shares_[j].*member;
        if (share[0] != 0.0) {
            handle.place = j;
            ++places;
        } else if (share[1] != 0.0) {
            handle.tip = j;
            ++tips;
        }
    }
    return places == 1 && tips == 1 ? std::optional(handle) : std::nullopt;
}

double curvature_of(const ArmJet& jet) {
    return cross(jet.first, jet.second) / cube(length(jet.first));
}

Vector curvature_by_first(const ArmJet& jet) {
    const double speed = length(jet.first);
    return -1.0 / cube(speed) * turned_left(jet.second) - 3.0 * curvature_of(jet) / (speed * speed) * jet.first;
}

Vector curvature_by_second(const ArmJet& jet) {
    return 1.0 / cube(length(jet.first)) * turned_left(jet.first);
}

JointMiss miss_of(const JointArms& arms, const std::vector<Point>& points, int level) {
    const ArmJet before = arms.before(points);
    const ArmJet after = arms.after(points);
    JointMiss miss;
    bool agrees = true;
    if (arms.has_two_places()) {
        miss.gap = after.place - before.place;
        agrees = length(miss.gap) <= roundings * epsilon * std::max(before.place_size, after.place_size);
    }
    if (level >= 1) {
        const double speeds = length(before.first) * length(after.first);
        miss.turn = cross(before.first, after.first) / speeds;
        miss.is_defined = std::isfinite(miss.turn) && dot(before.first, after.first) > 0.0;
        const double rounding =
            roundings * epsilon * (before.first_size / length(before.first) + after.first_size / length(after.first));
        agrees = agrees && std::abs(miss.turn) <= std::max(same_direction, rounding);
    }
    if (level >= 2) {
        const double left = curvature_of(before);
        const double right = curvature_of(after);
        miss.bend = right - left;
        miss.is_defined = miss.is_defined && std::isfinite(miss.bend);
        const double allowed = std::max({same_curvature * std::max(std::abs(left), std::abs(right)),
                                         rounding_of_curvature(before), rounding_of_curvature(after)});
        agrees = agrees && std::abs(miss.bend) <= allowed;
    }
    miss.agrees = agrees && miss.is_defined;
    return miss;
}

}  // namespace batten::core
