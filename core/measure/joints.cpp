#include "core/measure/joints.h"

#include <algorithm>
#include <cmath>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"

namespace batten::core {

namespace {

struct FreeEnd {
    std::size_t curve = 0;
    CurveEnd end = CurveEnd::start;
    Point point{};
};

double diagonal(const Curve& a, const Curve& b) {
    Box box = control_box(a);
    const Box other = control_box(b);
    box.include(other.lower);
    box.include(other.upper);
    return robust_length(box.size());
}

void add_knots(std::vector<Joint>& joints, const Curve& curve, std::size_t index) {
    constexpr int smooth = 2;
    const double size = robust_length(control_box(curve).size());
    for (const JointContinuity& found : joint_continuity_within(curve, curve.domain())) {
        if (found.geometric >= smooth) continue;
        const double before = found.kind == JointKind::seam ? curve.domain().upper : found.u;
        const Meeting meeting =
            meeting_of(passing_at(curve, before, Side::left), passing_at(curve, found.u, Side::right));
        const JointPlace place{index, found.u, false};
        joints.push_back({place, place, point_at(curve, found.u), meeting, std::min(1, smoothness_of(meeting, size))});
    }
}

Joint joint_of(std::span<const Curve* const> curves, const FreeEnd& a, const FreeEnd& b) {
    const Curve& first = *curves[a.curve];
    const Curve& second = *curves[b.curve];
    const Meeting meeting = meeting_of(passing_beyond(first, a.end), run_back(passing_beyond(second, b.end)));
    return {{a.curve, parameter_of(first.domain(), a.end)},
            {b.curve, parameter_of(second.domain(), b.end)},
            a.point,
            meeting,
            smoothness_of(meeting, diagonal(first, second))};
}

// Ends sorted along x: only those in a strip can be near.
std::vector<std::pair<std::size_t, std::size_t>> near_pairs(const std::vector<FreeEnd>& ends, double tolerance) {
    std::vector<std::size_t> order(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return ends[i].point.x; });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t k = 0; k < order.size(); ++k)
        for (std::size_t l = k + 1; l < order.size(); ++l) {
            const auto [i, j] = std::minmax(order[k], order[l]);
            if (ends[order[l]].point.x - ends[order[k]].point.x > tolerance) break;
            if (robust_length(ends[j].point - ends[i].point) <= tolerance) pairs.emplace_back(i, j);
        }
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace

std::vector<Joint> joints_of(std::span<const Curve* const> curves, double tolerance) {
    std::vector<Joint> joints;
    std::vector<FreeEnd> ends;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        add_knots(joints, *curves[i], i);
        if (curves[i]->is_periodic()) continue;
        for (const CurveEnd end : {CurveEnd::end, CurveEnd::start})
            ends.push_back({i, end, point_at(*curves[i], parameter_of(curves[i]->domain(), end))});
    }
    for (const auto& [i, j] : near_pairs(ends, tolerance)) joints.push_back(joint_of(curves, ends[i], ends[j]));
    std::ranges::stable_sort(joints, {},
                             [](const Joint& joint) { return std::pair(joint.first.curve, joint.first.is_end); });
    return joints;
}

}  // namespace batten::core
