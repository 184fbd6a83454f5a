/// A list that is nearly always short.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>
#include <span>
#include <vector>

namespace batten::core {

/// Like std::vector, but up to `Few` items take nothing from the heap.
template <class T, std::size_t Few>
class ShortList {
  public:
    ShortList() = default;
    /// As many items as their default constructor leaves them: numbers are not set.
    explicit ShortList(std::size_t count) : size_(count) {
        if (count > Few) many_.resize(count);
    }
    ShortList(std::size_t count, const T& item) : ShortList(count) { std::fill(begin(), end(), item); }
    explicit ShortList(std::span<const T> items) { assign(items); }
    ShortList(std::initializer_list<T> items) : ShortList(std::span<const T>(items.begin(), items.size())) {}

    void assign(std::span<const T> items) {
        size_ = items.size();
        if (size_ <= Few)
            std::copy(items.begin(), items.end(), few_.begin());
        else
            many_.assign(items.begin(), items.end());
    }

    /// `item` so many times.
    void assign(std::size_t count, const T& item) { *this = ShortList(count, item); }

    void push_back(const T& item) {
        if (size_ < Few)
            few_[size_++] = item;
        else
            push_back_to_many(item);
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }

    T* begin() { return size_ <= Few ? few_.data() : many_.data(); }
    T* end() { return begin() + size_; }
    const T* begin() const { return size_ <= Few ? few_.data() : many_.data(); }
    const T* end() const { return begin() + size_; }

    T& operator[](std::size_t i) {
        assert(i < size_);
        return begin()[i];
    }
    const T& operator[](std::size_t i) const {
        assert(i < size_);
        return begin()[i];
    }
    const T& front() const { return (*this)[0]; }
    const T& back() const { return (*this)[size_ - 1]; }

    operator std::vector<T>() const { return {begin(), end()}; }

    bool operator==(const ShortList& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

  private:
    [[gnu::noinline]] void push_back_to_many(const T& item) {
        if (size_ == Few) many_.assign(few_.begin(), few_.end());
        many_.push_back(item);
        ++size_;
    }

    std::size_t size_ = 0;
    std::array<T, Few> few_;  // those behind `size_` are not set: setting them would take longer than the rest
    std::vector<T> many_{};   // all of them, where they are too many
};

}  // namespace batten::core
