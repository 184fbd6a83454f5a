#include "core/edit/detail/joint_system.h"

#include <algorithm>

#include "core/edit/detail/joint_rows.h"

namespace batten::core {

namespace {

constexpr std::size_t most_members = 64;
constexpr int most_system_steps = 40;

}  // namespace

void JointSystem::add(const JointArms& arms, const std::vector<EditedPoint>& points, int level) {
    Member member{&arms, level, {}};
    for (std::size_t j = 0; j < points.size(); ++j) {
        const ActingPoint& point = arms.shares()[j].point;
        auto found = std::ranges::find_if(places_, [&](const auto& one) { return one.first == point; });
        if (found == places_.end()) {
            found = places_.insert(places_.end(), {point, points[j].now});
            edited_.push_back(points[j]);
        }
        member.points.push_back(static_cast<std::size_t>(found - places_.begin()));
    }
    members_.push_back(std::move(member));
}

bool JointSystem::solve() {
    if (members_.size() > most_members) return false;
    const auto start = places_;
    if (solve(false)) return true;
    places_ = start;
    return solve(true);
}

bool JointSystem::solve(bool moves_changed) {
    for (int step = 0; step < most_system_steps; ++step) {
        if (agree()) return true;
        std::vector<MendRow> rows;
        for (const Member& member : members_) {
            std::vector<bool> is_free;
            for (const std::size_t i : member.points)
                is_free.push_back(!edited_[i].is_held && (moves_changed || !edited_[i].is_changed()));
            const std::vector<Point> places = places_of(member);
            if (!miss_of(*member.arms, places, member.level).is_defined) return false;
            for (MendRow& own : rows_of(*member.arms, places, is_free, member.level, std::nullopt)) {
                MendRow row{std::vector<Vector>(places_.size()), own.miss};
                for (std::size_t j = 0; j < member.points.size(); ++j)
                    row.gradients[member.points[j]] += own.gradients[j];
                rows.push_back(std::move(row));
            }
        }
        const std::vector<Vector> moves = shortest_moves(std::move(rows), places_.size());
        for (std::size_t i = 0; i < places_.size(); ++i) places_[i].second += moves[i];
    }
    return false;
}

std::vector<Point> JointSystem::places_of(const Member& member) const {
    std::vector<Point> places;
    for (const std::size_t i : member.points) places.push_back(places_[i].second);
    return places;
}

bool JointSystem::agree() const {
    return std::ranges::all_of(
        members_, [&](const Member& member) { return miss_of(*member.arms, places_of(member), member.level).agrees; });
}

}  // namespace batten::core
