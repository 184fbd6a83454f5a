/// A joint of two arms as a function of the control points that act on it.
#pragma once

#include <optional>
#include <vector>

#include "core/edit/joint_keeping.h"

namespace batten::core {

/// A control point of one of the curves.
struct ActingPoint {
    std::size_t curve = 0;
    std::size_t index = 0;
    bool operator==(const ActingPoint&) const = default;
};

/// What of a control point's move goes into C, C' and C'' of both arms; 0 for an arm on which it does not act.
struct ActingShares {
    ActingPoint point;
    std::array<double, 3> before{};
    std::array<double, 3> after{};
};

/// How a curve runs through an arm, in the sense of the joint.
struct ArmJet {
    Point place{};
    Vector first{};
    Vector second{};
    double first_size = 0.0;   ///< what the terms of C' sum up to in size, for its rounding
    double second_size = 0.0;  ///< and those of C''
    double place_size = 0.0;
};

/// Both arms of a joint over fixed knots and weights.
class JointArms {
  public:
    /// The shares that are not zero. Cost O(p^2).
    JointArms(const std::vector<EditedCurve>& curves, const KeptJoint& joint);

    const std::vector<ActingShares>& shares() const { return shares_; }

    /// Ends that shall meet, or both sides of a knot where the curve may be torn.
    bool has_two_places() const { return has_two_places_; }

    /// By the positions of the points of shares().
    ArmJet before(const std::vector<Point>& points) const { return jet(points, &ActingShares::before); }
    ArmJet after(const std::vector<Point>& points) const { return jet(points, &ActingShares::after); }

    /// The point of shares() that alone makes the place of an arm, as at a knot of full multiplicity, and the one
    /// beside it which alone makes the direction.
    struct Handle {
        std::size_t place = 0;
        std::size_t tip = 0;
    };
    std::optional<Handle> handle_before() const { return handle(&ActingShares::before); }
    std::optional<Handle> handle_after() const { return handle(&ActingShares::after); }

  private:
    using Member = std::array<double, 3> ActingShares::*;

    void add(const EditedCurve& curve, const JointArm& arm, Member member, double sense);
    ArmJet jet(const std::vector<Point>& points, Member member) const;
    std::optional<Handle> handle(Member member) const;

    std::vector<ActingShares> shares_;
    bool has_two_places_ = false;
};

/// How far both arms are from agreeing, beside what counts as agreeing.
struct JointMiss {
    Vector gap{};
    double turn = 0.0;       ///< the sine of the angle between the directions
    double bend = 0.0;       ///< the difference of the curvatures
    bool is_defined = true;  ///< no arm stands still, and they do not turn back
    bool agrees = false;     ///< as far as the level asks
};

JointMiss miss_of(const JointArms& arms, const std::vector<Point>& points, int level);

/// The signed curvature of a jet, and its gradients by C' and C''.
double curvature_of(const ArmJet& jet);
Vector curvature_by_first(const ArmJet& jet);
Vector curvature_by_second(const ArmJet& jet);

}  // namespace batten::core
