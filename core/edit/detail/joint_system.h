/// Several joints that share control points, brought to agree all at once.
#pragma once

#include <utility>
#include <vector>

#include "core/edit/detail/joint_mender.h"

namespace batten::core {

/// Newton's method with the least moves, from where the points are. Cost O(k^2 m) a step for k joints and m points,
/// so it is for a few dozen of them.
class JointSystem {
  public:
    /// `points` are those of arms.shares(); the arms must outlive the system.
    void add(const JointArms& arms, const std::vector<EditedPoint>& points, int level);

    /// Whether all agree: without moves of what the edit has moved, or else with them.
    bool solve();

    const std::vector<std::pair<ActingPoint, Point>>& places() const { return places_; }

  private:
    struct Member {
        const JointArms* arms;
        int level;
        std::vector<std::size_t> points;  // in places_
    };

    bool solve(bool moves_changed);
    std::vector<Point> places_of(const Member& member) const;
    bool agree() const;

    std::vector<Member> members_;
    std::vector<std::pair<ActingPoint, Point>> places_;
    std::vector<EditedPoint> edited_;
};

}  // namespace batten::core
