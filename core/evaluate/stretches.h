/// The items of a long line (spans, legs) in stretches of about sixteen, which stay where items are added or taken
/// away.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace batten::core {

/// Items from the first to before the last one.
struct ItemRange {
    std::size_t first = 0;
    std::size_t end = 0;

    std::size_t size() const { return end - first; }

    /// All of them.
    std::vector<std::size_t> numbers() const {
        std::vector<std::size_t> list(size());
        std::iota(list.begin(), list.end(), first);
        return list;
    }
};

/// Divides the items `all` without gaps.
class Stretches {
  public:
    static constexpr std::size_t usual_size = 16;

    explicit Stretches(ItemRange all) {
        for (std::size_t i = all.first; i < all.end; i += usual_size) begins_.push_back(i);
        begins_.push_back(all.end);
    }

    std::size_t size() const { return begins_.size() - 1; }
    ItemRange operator[](std::size_t stretch) const { return {begins_[stretch], begins_[stretch + 1]}; }

    /// The items of the stretches first..last.
    ItemRange items(std::size_t first, std::size_t last) const { return {begins_[first], begins_[last + 1]}; }

    /// The stretch of an item. Cost logarithmic.
    std::size_t stretch_of(std::size_t item) const {
        const auto after = std::upper_bound(begins_.begin(), begins_.end() - 1, item);
        return static_cast<std::size_t>(after - begins_.begin()) - 1;
    }

    /// Puts the items `after` in the place of `before`, which begin with the same one: its stretch grows or shrinks,
    /// and all later items get other numbers. False, with nothing done, where there are many of either, or none, or
    /// where the stretch would come to have none or several times as many as usual. Cost: the later stretches.
    bool exchange(ItemRange before, ItemRange after) {
        const bool is_small = before.first < before.end && after.first < after.end && before.size() <= most_size &&
                              after.size() <= most_size;
        if (!is_small) return false;
        const std::size_t stretch = stretch_of(before.first);
        const std::size_t size = (*this)[stretch].size() + after.size() - before.size();
        if (size == 0 || size > most_size) return false;
        for (std::size_t k = stretch + 1; k < begins_.size(); ++k) begins_[k] += after.size() - before.size();
        return true;
    }

  private:
    static constexpr std::size_t most_size = 4 * usual_size;

    std::vector<std::size_t> begins_;
};

/// How many items two sequences have in common at their beginnings and at their ends; these may overlap.
struct CommonEnds {
    std::size_t ahead = 0;
    std::size_t behind = 0;
};

/// Of two random access ranges. Cost: comparing them.
template <class Range>
CommonEnds common_ends(const Range& a, const Range& b) {
    const auto ahead = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const auto behind = std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    return {static_cast<std::size_t>(ahead.first - a.begin()), static_cast<std::size_t>(behind.first - a.rbegin())};
}

/// Where two sequences differ: what is between equal beginnings and equal ends of both.
struct Difference {
    std::size_t first = 0;
    std::size_t end_of_old = 0;
    std::size_t end_of_new = 0;
};

inline Difference difference(const CommonEnds& common, std::size_t old_size, std::size_t new_size) {
    const std::size_t behind = std::min(common.behind, std::min(old_size, new_size) - common.ahead);
    return {common.ahead, old_size - behind, new_size - behind};
}

}  // namespace batten::core
