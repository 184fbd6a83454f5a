/// Brings the arms of one joint together again, with the least that must move.
#pragma once

#include <optional>
#include <vector>

#include "core/edit/detail/joint_arms.h"

namespace batten::core {

/// A control point that acts on a joint, as the edit left it.
struct EditedPoint {
    Point now{};
    std::optional<Point> old{};  ///< before the edit; none where that is not known
    bool is_held = false;
    bool is_shared = false;  ///< the direction at another joint depends on it

    bool is_changed() const { return old && *old != now; }
};

/// Where the points, which are those of arms.shares(), go so that the joint is as smooth as `level` says; none where
/// that cannot be. See keep_joints().
std::optional<std::vector<Point>> mended_points(const JointArms& arms, const std::vector<EditedPoint>& points,
                                                int level);

}  // namespace batten::core
