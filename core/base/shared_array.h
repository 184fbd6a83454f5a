/// An immutable array that its copies share.
#pragma once

#include <algorithm>
#include <cassert>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace batten::core {

/// An array that is still being written. Its values are what the memory holds until they are written.
template <class T>
class NewArray {
  public:
    explicit NewArray(std::size_t size)
        : first_(std::allocator<T>().allocate(size), [size](T* first) { std::allocator<T>().deallocate(first, size); }),
          size_(size) {
        static_assert(std::is_trivially_destructible_v<T> && std::is_trivially_copyable_v<T>);
    }

    T* data() { return first_.get(); }
    std::size_t size() const { return size_; }
    std::span<T> values() { return {first_.get(), size_}; }
    std::span<const T> values() const { return {first_.get(), size_}; }

  private:
    template <class>
    friend class SharedArray;

    std::shared_ptr<T> first_;
    std::size_t size_;
};

/// Copying costs the same whatever the size; so values that hold arrays can be kept, handed on and changed in one of
/// their parts without the others being copied.
template <class T>
class SharedArray {
  public:
    explicit SharedArray(std::vector<T> values) : size_(values.size()) {
        const auto owner = std::make_shared<const std::vector<T>>(std::move(values));
        first_ = std::shared_ptr<const T>(owner, owner->data());
    }
    explicit SharedArray(NewArray<T> values) : first_(std::move(values.first_)), size_(values.size_) {}

    operator std::span<const T>() const { return values(); }
    std::span<const T> values() const { return {first_.get(), size_}; }
    std::size_t size() const { return size_; }
    const T& operator[](std::size_t i) const {
        assert(i < size_);
        return first_.get()[i];
    }

    /// By the values; at once where they are shared.
    bool operator==(const SharedArray& other) const {
        return first_ == other.first_ || std::ranges::equal(values(), other.values());
    }

  private:
    std::shared_ptr<const T> first_;
    std::size_t size_;
};

}  // namespace batten::core
