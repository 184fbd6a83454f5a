/// A list that items are taken out of one after the other, near each other.
#pragma once

#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace batten::core {

/// Has a gap where the last item was taken out: the next one costs as many moves as items lie between.
template <class T>
class GapList {
  public:
    explicit GapList(std::vector<T> items) : before_(std::move(items)) {}

    std::size_t size() const { return before_.size() + behind_.size(); }
    const T& operator[](std::size_t i) const {
        assert(i < size());
        return i < before_.size() ? before_[i] : behind_[behind_.size() - 1 - (i - before_.size())];
    }

    void take_out(std::size_t i) {
        assert(i < size());
        open_gap_at(i + 1);
        before_.pop_back();
    }

    /// The items that are left, all of them. Call once.
    std::vector<T> rest() {
        open_gap_at(size());
        return std::move(before_);
    }

  private:
    void open_gap_at(std::size_t i) {
        for (; before_.size() > i; before_.pop_back()) behind_.push_back(std::move(before_.back()));
        for (; before_.size() < i; behind_.pop_back()) before_.push_back(std::move(behind_.back()));
    }

    std::vector<T> before_;
    std::vector<T> behind_;  // in reverse order
};

}  // namespace batten::core
