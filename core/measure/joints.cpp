#include "core/measure/joints.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"

namespace batten::core {

namespace {

// Of the size of both curves, what counts as no gap.
constexpr double no_gap = 1e-9;

struct FreeEnd {
    std::size_t curve = 0;
    CurveEnd end = CurveEnd::start;
    Point point{};
};

double diagonal(Box a, const Box& b) {
    a.include(b.lower);
    a.include(b.upper);
    return robust_length(a.size());
}

void add_knots(std::vector<Joint>& joints, const Curve& curve, std::size_t index, const Box& box) {
    constexpr int smooth = 2;
    const double size = robust_length(box.size());
    for (const JointContinuity& found : joint_continuity_within(curve, curve.domain())) {
        if (found.geometric >= smooth) continue;
        const double before = found.kind == JointKind::seam ? curve.domain().upper : found.u;
        const Meeting meeting =
            meeting_of(passing_at(curve, before, Side::left), passing_at(curve, found.u, Side::right));
        const JointPlace place{index, found.u, false};
        joints.push_back({place, place, point_at(curve, found.u), meeting, std::min(1, smoothness_of(meeting, size))});
    }
}

// The ends of all curves, and which of them are joints.
class Ends {
  public:
    Ends(std::span<const Curve* const> curves, std::span<const Box> boxes) : curves_(curves), boxes_(boxes) {
        for (std::size_t i = 0; i < curves.size(); ++i) {
            if (curves[i]->is_periodic()) continue;
            for (const CurveEnd end : {CurveEnd::end, CurveEnd::start})
                ends_.push_back({i, end, point_at(*curves[i], parameter_of(curves[i]->domain(), end))});
        }
        for (const Box& box : boxes)
            meeting_reach_ = std::max(meeting_reach_, 2.0 * no_gap * robust_length(box.size()));
        for (std::size_t i = 0; i < ends_.size(); ++i) order_.push_back(i);
        std::ranges::sort(order_, {}, [&](std::size_t i) { return ends_[i].point.x; });
    }

    // Each end with the one that is nearest to it, and with those that it meets.
    std::vector<Joint> joints(double tolerance) const {
        Pairs pairs;
        for (std::size_t k = 0; k < order_.size(); ++k) add_pairs(pairs, k, tolerance);
        std::ranges::sort(pairs);
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        std::vector<Joint> joints;
        for (const auto& [i, j] : pairs) joints.push_back(joint_of(ends_[i], ends_[j]));
        return joints;
    }

  private:
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

    double size_of(std::size_t i, std::size_t j) const {
        return diagonal(boxes_[ends_[i].curve], boxes_[ends_[j].curve]);
    }

    Joint joint_of(const FreeEnd& a, const FreeEnd& b) const {
        const Curve& first = *curves_[a.curve];
        const Curve& second = *curves_[b.curve];
        const Meeting meeting = meeting_of(passing_beyond(first, a.end), run_back(passing_beyond(second, b.end)));
        return {{a.curve, parameter_of(first.domain(), a.end)},
                {b.curve, parameter_of(second.domain(), b.end)},
                a.point,
                meeting,
                smoothness_of(meeting, diagonal(boxes_[a.curve], boxes_[b.curve]))};
    }

    // Sorted along x, an end is not nearer than another whose x is farther than the nearest so far.
    void add_pairs(Pairs& pairs, std::size_t k, double tolerance) const {
        std::optional<std::size_t> nearest;
        double least = tolerance;
        const std::size_t i = order_[k];
        const auto look = [&](std::size_t j) {
            const Vector way = ends_[j].point - ends_[i].point;
            if (!(std::abs(way.x) <= std::max(least, meeting_reach_))) return false;
            const double distance = robust_length(way);
            if (distance <= no_gap * size_of(i, j) && distance <= tolerance) pairs.emplace_back(std::minmax(i, j));
            if (distance < least || (distance == least && !nearest)) {
                nearest = j;
                least = distance;
            }
            return true;
        };
        for (std::size_t l = k + 1; l < order_.size() && look(order_[l]);) ++l;
        for (std::size_t l = k; l > 0 && look(order_[l - 1]);) --l;
        if (nearest) pairs.emplace_back(std::minmax(i, *nearest));
    }

    std::span<const Curve* const> curves_;
    std::span<const Box> boxes_;
    std::vector<FreeEnd> ends_;
    std::vector<std::size_t> order_;  // of the ends, along x
    double meeting_reach_ = 0.0;      // no ends meet that are farther from each other
};

}  // namespace

std::vector<Joint> joints_of(std::span<const Curve* const> curves, double tolerance) {
    std::vector<Joint> joints;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        boxes.push_back(control_box(*curves[i]));
        add_knots(joints, *curves[i], i, boxes.back());
    }
    for (const Joint& joint : Ends(curves, boxes).joints(tolerance)) joints.push_back(joint);
    std::ranges::stable_sort(joints, {},
                             [](const Joint& joint) { return std::pair(joint.first.curve, joint.first.is_end); });
    return joints;
}

}  // namespace batten::core
