#include "core/measure/continuity.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/curve/control_box.h"
#include "core/curve/detail/bspline.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"

namespace batten::core {

namespace {

constexpr int derivative_count = 2;

// What can be said of the curve on one side of a joint.
struct OneSide {
    Jet jet;
    std::array<double, derivative_count + 1> noise{};  // errors of the jet that rounded coordinates explain
    std::optional<Vector> tangent;
    std::optional<double> curvature;
};

// The points' rounding of a few units, carried through the derivatives.
std::array<double, derivative_count + 1> noise_of_derivatives(const Curve& curve, double rounding, double u,
                                                              Side side) {
    const auto [inside, at] = located(curve.knots(), u, side);
    LocalPoints<double> errors{};
    LocalPoints<double> weights{};
    for (std::size_t j = 0; j <= at.p; ++j) {
        weights[j] = curve.weights()[(at.s - at.p + j) % curve.weights().size()];
        errors[j] = rounding * weights[j];
    }
    const double weight = de_boor(weights, at, inside);
    std::array<double, derivative_count + 1> noise{rounding, 0.0, 0.0};
    for (std::size_t r = 1; r <= std::min<std::size_t>(derivative_count, at.p); ++r) {
        const auto factor = static_cast<double>(at.p - r + 1);
        for (std::size_t j = at.p; j >= r; --j)
            errors[j] = factor / (at.upper(j, r) - at.lower(j)) * (errors[j] + errors[j - 1]);
        noise[r] = *std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(r),
                                     errors.begin() + static_cast<std::ptrdiff_t>(at.p) + 1) /
                   weight;
    }
    return noise;
}

class JointMeter {
  public:
    JointMeter(const Curve& curve, const ContinuityTolerances& tolerances)
        : tolerances_(tolerances), curve_(seen_from(curve, middle_of(curve))) {
        assert(tolerances.position >= 0.0 && tolerances.derivative >= 0.0);
        assert(tolerances.angle >= 0.0 && tolerances.curvature >= 0.0);
        const Box box = control_box(curve_);
        size_ = robust_length(box.size());
        for (const Point& point : curve.control_points())
            rounding_ = std::max({rounding_, std::abs(point.x), std::abs(point.y)});
        rounding_ *= 2.0 * std::numeric_limits<double>::epsilon();
    }

    JointContinuity measure(JointKind kind, double before, double after) const {
        const OneSide left = look(before, Side::left);
        const OneSide right = look(after, Side::right);
        JointContinuity joint{.kind = kind, .u = after, .angle = std::nullopt};
        joint.position.size = robust_length(right.jet.point - left.jet.point);
        joint.position.relative = size_ > 0.0 ? joint.position.size / size_ : 0.0;
        joint.first = jump(left, right, 1);
        joint.second = jump(left, right, 2);
        if (left.tangent && right.tangent) joint.angle = angle_between(*left.tangent, *right.tangent);
        joint.before = left.curvature;
        joint.after = right.curvature;
        const bool meets = joint.position.size <= tolerances_.position * size_ + left.noise[0] + right.noise[0];
        joint.parametric = meets ? parametric_level(joint, left, right) : -1;
        joint.geometric = meets ? geometric_level(joint) : -1;
        return joint;
    }

  private:
    OneSide look(double u, Side side) const {
        OneSide view;
        view.jet = derivatives_at(curve_, u, derivative_count, side);
        view.noise = noise_of_derivatives(curve_, rounding_, u, side);
        view.tangent = tangent_at(curve_, u, side);
        view.curvature = curvature_at(curve_, u, side);
        return view;
    }

    static Jump jump(const OneSide& left, const OneSide& right, std::size_t order) {
        const Vector a = left.jet[order];
        const Vector b = right.jet[order];
        const double size = robust_length(b - a);
        const double larger = std::max(robust_length(a), robust_length(b));
        return {size, size > 0.0 ? size / larger : 0.0};
    }

    bool agrees(const Jump& jump, const OneSide& left, const OneSide& right, std::size_t order) const {
        return jump.relative <= tolerances_.derivative || jump.size <= left.noise[order] + right.noise[order];
    }

    int parametric_level(const JointContinuity& joint, const OneSide& left, const OneSide& right) const {
        if (!agrees(joint.first, left, right, 1)) return 0;
        return agrees(joint.second, left, right, 2) ? 2 : 1;
    }

    int geometric_level(const JointContinuity& joint) const {
        if (!joint.angle || !(std::abs(*joint.angle) <= tolerances_.angle)) return 0;
        if (!joint.before || !joint.after) return 1;
        const double larger = std::max({std::abs(*joint.before), std::abs(*joint.after), 1.0 / size_});
        return std::abs(*joint.after - *joint.before) <= tolerances_.curvature * larger ? 2 : 1;
    }

    const ContinuityTolerances& tolerances_;
    Curve curve_;
    double size_ = 0.0;
    double rounding_ = 0.0;
};

}  // namespace

std::vector<JointContinuity> joint_continuity_within(const Curve& curve, Interval range,
                                                     const ContinuityTolerances& tolerances) {
    const JointMeter meter(curve, tolerances);
    const Interval domain = curve.domain();
    std::vector<JointContinuity> joints;
    for (const DistinctKnot& knot : distinct_knots(curve.knots())) {
        if (!knot.is_interior || !range.contains(knot.value)) continue;
        const bool is_seam = curve.is_periodic() && knot.value == domain.lower;
        auto joint =
            meter.measure(is_seam ? JointKind::seam : JointKind::knot, is_seam ? domain.upper : knot.value, knot.value);
        joint.multiplicity = knot.multiplicity;
        joint.promised = knot.continuity;
        joints.push_back(joint);
    }
    return joints;
}

std::vector<JointContinuity> joint_continuity(const Curve& curve, const ContinuityTolerances& tolerances) {
    auto joints = joint_continuity_within(curve, curve.domain(), tolerances);
    if (curve.is_periodic()) return joints;
    const auto ends = continuity_of_ends(curve, tolerances);
    if (ends.geometric >= 0) joints.push_back(ends);
    return joints;
}

JointContinuity continuity_of_ends(const Curve& curve, const ContinuityTolerances& tolerances) {
    const Interval domain = curve.domain();
    return JointMeter(curve, tolerances)
        .measure(curve.is_periodic() ? JointKind::seam : JointKind::ends, domain.upper, domain.lower);
}

bool is_closed(const Curve& curve, const ContinuityTolerances& tolerances) {
    return curve.is_periodic() || continuity_of_ends(curve, tolerances).geometric >= 0;
}

}  // namespace batten::core
