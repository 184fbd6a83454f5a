/// An immutable array that its copies share.
#pragma once

#include <algorithm>
#include <cassert>
#include <memory>
#include <span>
#include <vector>

namespace batten::core {

/// An array that is still being written. Its values are what the memory holds until they are written.
template <class T>
class NewArray {
  public:
    explicit NewArray(std::size_t size) : values_(new T[size]), size_(size) {}

    T* data() { return values_.get(); }
    std::size_t size() const { return size_; }
    std::span<T> values() { return {values_.get(), size_}; }

  private:
    template <class>
    friend class SharedArray;

    std::shared_ptr<T[]> values_;
    std::size_t size_;
};

/// Copying costs the same whatever the size; so values that hold arrays can be kept, handed on and changed in one of
/// their parts without the others being copied.
template <class T>
class SharedArray {
  public:
    explicit SharedArray(std::vector<T> values) : size_(values.size()) {
        const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
        values_ = std::shared_ptr<const T[]>(owner, owner->data());
    }
    explicit SharedArray(NewArray<T> values) : values_(std::move(values.values_)), size_(values.size_) {}

    operator std::span<const T>() const { return values(); }
    std::span<const T> values() const { return {values_.get(), size_}; }
    std::size_t size() const { return size_; }
    const T& operator[](std::size_t i) const {
        assert(i < size_);
        return values_.get()[i];
    }

    /// By the values; at once where they are shared.
    bool operator==(const SharedArray& other) const {
        return values_ == other.values_ || std::ranges::equal(values(), other.values());
    }

  private:
    std::shared_ptr<const T[]> values_;
    std::size_t size_;
};

}  // namespace batten::core
