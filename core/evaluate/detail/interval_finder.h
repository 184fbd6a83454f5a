/// Finds the interval of a parameter among many, nearly at once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/curve/knot_vector.h"

namespace batten::core {

/// The intervals between ascending joints, found by a table of equal parts of the whole, some two for each interval.
class IntervalFinder {
  public:
    explicit IntervalFinder(std::vector<double> joints) : joints_(std::move(joints)) {
        const double parts = 2.0 * static_cast<double>(count());
        parts_per_unit_ = std::min(parts / (joints_.back() - joints_.front()), std::numeric_limits<double>::max());
        last_before_.resize(part_at(joints_.back()) + 2);
        std::size_t interval = 0;
        for (std::size_t part = 0; part < last_before_.size(); ++part) {
            while (interval + 1 < count() && part_at(joints_[interval + 1]) < part) ++interval;
            last_before_[part] = static_cast<std::uint32_t>(interval);
        }
    }

    std::size_t count() const { return joints_.size() - 1; }
    Interval operator[](std::size_t i) const { return {joints_[i], joints_[i + 1]}; }

    /// Strictly between the first joint and the last.
    bool has_inside(double u) const { return joints_.front() < u && u < joints_.back(); }

    /// Of a parameter that is inside, at a joint the one on its `side`. Cost O(1), and O(log n) where the joints are
    /// spread very unevenly.
    std::size_t interval_at(double u, Side side) const {
        const std::size_t part = part_at(u);
        std::size_t found = last_before_[part];
        const std::size_t last = last_before_[part + 1];
        // Mostly there are no more than two steps to go. Which of them are needed a processor could not guess.
        if (last - found > 2) {
            const auto first = joints_.begin() + static_cast<std::ptrdiff_t>(found) + 1;
            const auto end = first + static_cast<std::ptrdiff_t>(last - found);
            found += static_cast<std::size_t>(std::upper_bound(first, end, u) - first);
        } else {
            found += static_cast<std::size_t>(joints_[found + 1] <= u);
            found += static_cast<std::size_t>(joints_[found + 1] <= u);
        }
        return side == Side::left && joints_[found] == u && found > 0 ? found - 1 : found;
    }

  private:
    // Rounded as it may be, it never falls where u rises; so what begins in an earlier part begins before u.
    std::size_t part_at(double u) const { return static_cast<std::size_t>((u - joints_.front()) * parts_per_unit_); }

    std::vector<double> joints_;
    double parts_per_unit_ = 0.0;
    std::vector<std::uint32_t> last_before_;  // the last interval that begins before each part
};

}  // namespace batten::core
