#include "core/edit/joint_keeping.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/edit/detail/joint_mender.h"
#include "core/edit/detail/joint_system.h"

namespace batten::core {

namespace {

// Joints that share control points are mended in turn until all agree.
constexpr int most_mending_rounds = 40;

bool is_over_same_basis(const EditedCurve& edited) {
    if (edited.old == nullptr) return false;
    const Curve& old = *edited.old;
    return old.knots() == edited.curve.knots() && std::ranges::equal(old.weights(), edited.curve.weights());
}

bool is_of_direction(const ActingShares& share) {
    return share.before[1] != 0.0 || share.after[1] != 0.0;
}

class JointKeeping {
  public:
    JointKeeping(const std::vector<EditedCurve>& curves, const std::vector<KeptJoint>& joints)
        : curves_(curves), joints_(joints), is_lost_(joints.size(), false) {
        std::vector<bool> is_involved(curves.size(), false);
        for (const KeptJoint& joint : joints) is_involved[joint.before.curve] = is_involved[joint.after.curve] = true;
        for (std::size_t c = 0; c < curves.size(); ++c) {
            points_.emplace_back();
            is_over_same_basis_.push_back(is_involved[c] && is_over_same_basis(curves[c]));
            if (!is_involved[c]) continue;
            const auto points = curves[c].curve.control_points();
            points_.back().assign(points.begin(), points.end());
        }
        for (const KeptJoint& joint : joints) {
            arms_.emplace_back(curves, joint);
            for (const ActingShares& share : arms_.back().shares())
                if (is_of_direction(share)) ++direction_counts_[{share.point.curve, share.point.index}];
        }
    }

    void run() {
        if (mend_in_turn(most_mending_rounds)) return;
        mend_together();
        if (mend_in_turn(1)) return;
        for (std::size_t k = 0; k < joints_.size(); ++k)
            if (is_touched(k) && !agrees(k)) is_lost_[k] = true;
    }

    KeptJoints result() const {
        KeptJoints kept;
        for (std::size_t c = 0; c < curves_.size(); ++c) {
            if (points_[c].empty() || std::ranges::equal(curves_[c].curve.control_points(), points_[c])) {
                kept.curves.push_back(curves_[c].curve);
                continue;
            }
            CurveDefinition definition = curves_[c].curve.definition();
            definition.points = points_[c];
            const auto curve = Curve::make(std::move(definition));
            kept.curves.push_back(curve ? *curve : curves_[c].curve);
        }
        for (std::size_t k = 0; k < joints_.size(); ++k)
            if (is_lost_[k]) kept.lost.push_back(k);
        return kept;
    }

  private:
    // Whether all agree in the end.
    bool mend_in_turn(int rounds) {
        for (int round = 0; round < rounds; ++round) {
            bool is_at_rest = true;
            for (std::size_t k = 0; k < joints_.size(); ++k)
                if (!is_lost_[k] && is_touched(k) && !agrees(k)) {
                    is_lost_[k] = !mend(k);
                    is_at_rest = false;
                }
            if (is_at_rest) return true;
        }
        for (std::size_t k = 0; k < joints_.size(); ++k)
            if (!is_lost_[k] && is_touched(k) && !agrees(k)) return false;
        return true;
    }

    // All joints that are touched and all their points at once, where these do not come to rest one by one.
    void mend_together() {
        JointSystem system;
        for (std::size_t k = 0; k < joints_.size(); ++k) {
            if (is_lost_[k] || !is_touched(k)) continue;
            std::vector<EditedPoint> points;
            for (const ActingShares& share : arms_[k].shares()) points.push_back(edited(share));
            system.add(arms_[k], points, joints_[k].level);
        }
        if (!system.solve()) return;
        for (const auto& [point, place] : system.places()) points_[point.curve][point.index] = place;
    }

    std::optional<Point> old_of(const ActingPoint& point) const {
        const auto& old = curves_[point.curve].old;
        if (old == nullptr || old->control_points().size() != points_[point.curve].size()) return std::nullopt;
        return old->control_points()[point.index];
    }

    Point now_of(const ActingPoint& point) const { return points_[point.curve][point.index]; }

    bool is_touched(std::size_t k) const {
        if (joints_[k].is_new) return true;
        return std::ranges::any_of(arms_[k].shares(), [&](const ActingShares& share) {
            return !is_over_same_basis_[share.point.curve] || old_of(share.point) != now_of(share.point);
        });
    }

    bool agrees(std::size_t k) const {
        std::vector<Point> places;
        for (const ActingShares& share : arms_[k].shares()) places.push_back(now_of(share.point));
        return miss_of(arms_[k], places, joints_[k].level).agrees;
    }

    // Points that other joints have mended count as free: only what the edit itself moved stays.
    EditedPoint edited(const ActingShares& share) const {
        const ActingPoint& point = share.point;
        const EditedCurve& curve = curves_[point.curve];
        EditedPoint edited{.now = now_of(point), .old = old_of(point)};
        if (edited.old == curve.curve.control_points()[point.index]) edited.old = edited.now;
        edited.is_held = curve.is_held || std::ranges::binary_search(curve.held, point.index);
        const auto count = direction_counts_.find({point.curve, point.index});
        edited.is_shared = count != direction_counts_.end() && count->second > (is_of_direction(share) ? 1 : 0);
        return edited;
    }

    bool mend(std::size_t k) {
        std::vector<EditedPoint> points;
        for (const ActingShares& share : arms_[k].shares()) points.push_back(edited(share));
        const auto mended = mended_points(arms_[k], points, joints_[k].level);
        if (!mended) return false;
        for (std::size_t j = 0; j < mended->size(); ++j) {
            const ActingPoint& point = arms_[k].shares()[j].point;
            points_[point.curve][point.index] = (*mended)[j];
        }
        return true;
    }

    const std::vector<EditedCurve>& curves_;
    const std::vector<KeptJoint>& joints_;
    std::vector<bool> is_lost_;
    std::vector<bool> is_over_same_basis_;
    std::vector<std::vector<Point>> points_;
    std::vector<JointArms> arms_;
    std::map<std::pair<std::size_t, std::size_t>, int> direction_counts_;  // of joints whose direction depends on it
};

}  // namespace

KeptJoints keep_joints(const std::vector<EditedCurve>& curves, const std::vector<KeptJoint>& joints) {
    JointKeeping keeping(curves, joints);
    keeping.run();
    return keeping.result();
}

bool is_kept(const std::vector<EditedCurve>& curves, const KeptJoint& joint) {
    const JointArms arms(curves, joint);
    std::vector<Point> places;
    for (const ActingShares& share : arms.shares())
        places.push_back(curves[share.point.curve].curve.control_points()[share.point.index]);
    return miss_of(arms, places, joint.level).agrees;
}

}  // namespace batten::core
