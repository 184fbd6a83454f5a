/// Keeps joints of curves smooth while control points beside them are moved.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// A curve that an edit has made of another one.
struct EditedCurve {
    Curve curve;
    std::shared_ptr<const Curve> old{};  ///< null where it is not known, or has other points
    std::vector<std::size_t> held{};     ///< control points that keep every bit, ascending
    bool is_held = false;                ///< all of them do
};

/// Where a curve comes to a joint, or leaves it.
struct JointArm {
    std::size_t curve = 0;   ///< its index
    double u = 0.0;          ///< in the domain; of ends the end
    Side side = Side::left;  ///< of u on which it lies
};

/// A joint that is run through from `before` into `after`: both of one curve at a knot of it, or ends that shall meet.
struct KeptJoint {
    JointArm before;
    JointArm after;
    int level = 1;        ///< 0: the places agree, 1: the directions too, 2: the curvatures too
    bool is_new = false;  ///< it is to be made, whatever the edit changed
};

struct KeptJoints {
    std::vector<Curve> curves{};
    std::vector<std::size_t> lost{};  ///< the joints, by index, that could not be kept; ascending
};

/// The curves with every joint as smooth as its level says, where control points beside it, or weights or knots, have
/// changed. Control points that the edit has moved stay where it put them, and others make up for them: beside a moved
/// end of a piece its neighbors go along; a moved neighbor turns the one on the other side, which keeps its distance.
/// Only where that is not enough the moved ones give way. What is needed beyond that is the least change, by Newton's
/// method; all control points that do not act on C', C'' of a joint keep every bit. Directions then agree to 1e-13, and
/// curvatures relatively to 1e-11, or up to rounding of the coordinates; ends to the last bit where the curves are
/// clamped there. A joint that cannot be kept is told, and its points are as the edit left them. Cost O(p^2) for each
/// joint beside which something has changed.
[[nodiscard]] KeptJoints keep_joints(const std::vector<EditedCurve>& curves, const std::vector<KeptJoint>& joints);

/// Whether the joint is as smooth as its level says, up to rounding.
bool is_kept(const std::vector<EditedCurve>& curves, const KeptJoint& joint);

}  // namespace batten::core
