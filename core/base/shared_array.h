/// An immutable array that its copies share.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace batten::core {

/// Copying costs the same whatever the size; so values that hold arrays can be kept, handed on and changed in one of
/// their parts without the others being copied.
template <class T>
class SharedArray {
  public:
    explicit SharedArray(std::vector<T> values) : values_(std::make_shared<const std::vector<T>>(std::move(values))) {}

    operator std::span<const T>() const { return *values_; }
    std::span<const T> values() const { return *values_; }
    std::size_t size() const { return values_->size(); }
    const T& operator[](std::size_t i) const { return (*values_)[i]; }

    /// By the values; at once where they are shared.
    bool operator==(const SharedArray& other) const {
        return values_ == other.values_ || std::ranges::equal(*values_, *other.values_);
    }

  private:
    std::shared_ptr<const std::vector<T>> values_;
};

}  // namespace batten::core
