/// Boxes in an order in which neighbors are near each other, as those of the pieces of a curve, for finding those that
/// come near another box without a look at all of them.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

class BoxTree {
  public:
    /// Cost O(n).
    explicit BoxTree(std::vector<Box> boxes) {
        levels_.push_back(std::move(boxes));
        while (levels_.back().size() > 1) levels_.push_back(joined_in_pairs(levels_.back()));
    }

    /// Calls `visit` with the index of each box from `first` on that comes within `distance` of `box`, in both
    /// coordinates; ascending. Cost O(log n) for each, where few boxes lie across one another; `ask`, called for each
    /// box that is looked at, tells.
    template <class Visit, class Ask>
    void each_near(const Box& box, double distance, std::size_t first, Visit visit, Ask ask) const {
        Box reach = box;
        reach.lower -= Vector(distance, distance);
        reach.upper += Vector(distance, distance);
        const auto descend = [&](const auto& self, std::size_t level, std::size_t i) -> void {
            if (i >= levels_[level].size() || ((i + 1) << level) <= first) return;
            ask();
            if (!levels_[level][i].intersects(reach)) return;
            if (level == 0) return visit(i);
            self(self, level - 1, 2 * i);
            self(self, level - 1, 2 * i + 1);
        };
        descend(descend, levels_.size() - 1, 0);
    }

    template <class Visit>
    void each_near(const Box& box, double distance, std::size_t first, Visit visit) const {
        each_near(box, distance, first, visit, [] {});
    }

  private:
    static std::vector<Box> joined_in_pairs(const std::vector<Box>& boxes) {
        std::vector<Box> joined((boxes.size() + 1) / 2);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            if (boxes[i].is_empty()) continue;
            joined[i / 2].include(boxes[i].lower);
            joined[i / 2].include(boxes[i].upper);
        }
        return joined;
    }

    std::vector<std::vector<Box>> levels_;  // the boxes themselves, and on each level those of two below
};

}  // namespace batten::core
