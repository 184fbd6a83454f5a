#include "core/edit/detail/joint_mender.h"

#include <algorithm>
#include <cmath>

#include "core/edit/detail/joint_rows.h"

namespace batten::core {

namespace {

constexpr int most_mending_steps = 40;
constexpr double turned_little = 1e-6;   // radians, which Newton's method mends without a guess
constexpr double farthest_mended = 4.0;  // sizes of what acts, beyond which no solution is meant

Vector unit(Vector v) {
    return v / robust_length(v);
}

// Which points may move.
enum class Freedom { own, unchanged, all };

bool is_free_point(const EditedPoint& point, Freedom freedom) {
    if (point.is_held) return false;
    if (freedom == Freedom::all) return true;
    return !point.is_changed() && (freedom == Freedom::unchanged || !point.is_shared);
}

// One try to mend, with these points free.
class Mending {
  public:
    Mending(const JointArms& arms, const std::vector<EditedPoint>& points, int level, Freedom freedom, bool keeps_place)
        : arms_(arms), edited_(points), level_(level), keeps_place_(keeps_place) {
        for (const EditedPoint& point : points) {
            places_.push_back(point.now);
            is_free_.push_back(is_free_point(point, freedom));
        }
    }

    std::optional<std::vector<Point>> run() {
        target_ = (after_leads() ? arms_.after(places_) : arms_.before(places_)).place;
        guess();
        const std::vector<Point> guessed = places_;
        for (int k = 0; k < most_mending_steps; ++k) {
            const JointMiss miss = miss_of(arms_, places_, level_);
            if (miss.agrees && (keeps_target() || k > 0)) return finished(guessed);
            if (!miss.is_defined) return std::nullopt;
            const std::vector<Vector> moves = shortest_moves(
                rows_of(arms_, places_, is_free_, level_, keeps_place_ ? std::optional(target_) : std::nullopt),
                places_.size());
            for (std::size_t j = 0; j < places_.size(); ++j) places_[j] += moves[j];
        }
        return std::nullopt;
    }

  private:
    using Handle = JointArms::Handle;

    template <class Member>
    bool any(Member member, const std::vector<bool>& which) const {
        for (std::size_t j = 0; j < which.size(); ++j)
            if (which[j] && (arms_.shares()[j].*member)[0] != 0.0) return true;
        return false;
    }

    // Where two ends meet one goes to the other: the one that can to the one that cannot, or that the edit has moved.
    bool after_leads() const {
        const bool before_can = any(&ActingShares::before, is_free_);
        const bool after_can = any(&ActingShares::after, is_free_);
        if (before_can != after_can) return before_can;
        std::vector<bool> is_changed;
        for (const EditedPoint& point : edited_) is_changed.push_back(point.is_changed());
        return any(&ActingShares::after, is_changed) && !any(&ActingShares::before, is_changed);
    }

    bool keeps_target() const { return !keeps_place_ || arms_.before(places_).place == target_; }

    void guess() {
        const auto before = arms_.handle_before();
        const auto after = arms_.handle_after();
        if (arms_.has_two_places() && keeps_place_)
            for (const auto& handle : {before, after})
                if (handle && is_free_[handle->place]) places_[handle->place] = target_;
        for (const auto& handle : {before, after})
            if (handle) carry_tip(*handle);
        if (before && after && level_ >= 1) turn_tips(*before, *after);
    }

    // The neighbor of an end of a piece goes where the end goes.
    void carry_tip(const Handle& handle) {
        if (!is_free_[handle.tip] || edited_[handle.tip].is_changed()) return;
        const EditedPoint& place = edited_[handle.place];
        places_[handle.tip] += places_[handle.place] - place.old.value_or(place.now);
    }

    // Neighbors that are free turn around the joint and keep their distances.
    void turn_tips(const Handle& before, const Handle& after) {
        const Vector arriving = places_[before.place] - places_[before.tip];
        const Vector leaving = places_[after.tip] - places_[after.place];
        if (std::abs(angle_between(arriving, leaving)) <= turned_little) return;
        const double arriving_length = robust_length(arriving);
        const double leaving_length = robust_length(leaving);
        const bool turns_before = is_free_[before.tip];
        const bool turns_after = is_free_[after.tip];
        Vector direction = turns_before && turns_after ? arriving + leaving : turns_before ? leaving : arriving;
        if (direction == Vector{}) direction = turned_left(arriving);
        if (direction == Vector{}) return;
        direction = unit(direction);
        if (turns_before) places_[before.tip] = places_[before.place] - arriving_length * direction;
        if (turns_after) places_[after.tip] = places_[after.place] + leaving_length * direction;
    }

    std::optional<std::vector<Point>> finished(const std::vector<Point>& guessed) {
        Box box;
        for (const Point& place : guessed) box.include(place);
        for (const EditedPoint& point : edited_) box.include(point.now);
        const double allowed = farthest_mended * length(box.size());
        for (std::size_t j = 0; j < places_.size(); ++j)
            if (!(distance(places_[j], guessed[j]) <= allowed)) return std::nullopt;
        put_ends_together();
        return places_;
    }

    // To the last bit.
    void put_ends_together() {
        const auto before = arms_.handle_before();
        const auto after = arms_.handle_after();
        if (!arms_.has_two_places() || !before || !after) return;
        if (is_free_[after->place])
            places_[after->place] = places_[before->place];
        else
            places_[before->place] = places_[after->place];
    }

    const JointArms& arms_;
    const std::vector<EditedPoint>& edited_;
    int level_;
    bool keeps_place_;
    std::vector<Point> places_;
    std::vector<bool> is_free_;
    Point target_{};
};

}  // namespace

std::optional<std::vector<Point>> mended_points(const JointArms& arms, const std::vector<EditedPoint>& points,
                                                int level) {
    for (const Freedom freedom : {Freedom::own, Freedom::unchanged, Freedom::all})
        for (const bool keeps_place : {true, false})
            if (auto found = Mending(arms, points, level, freedom, keeps_place).run()) return found;
    return std::nullopt;
}

}  // namespace batten::core
