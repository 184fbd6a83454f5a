/// What lies nearest to the pointer.
#pragma once

#include <optional>
#include <utility>

namespace batten::editor {

/// Keeps the nearest of the things offered that are within reach, the first of equally near ones. A distance that is
/// not a number is out of reach.
template <class Thing>
class Nearest {
  public:
    explicit Nearest(double reach) : distance_(reach) {}

    void offer(Thing thing, double distance) {
        if (!(distance <= distance_) || (found_ && distance == distance_)) return;
        distance_ = distance;
        found_ = std::move(thing);
    }
    const std::optional<Thing>& found() const { return found_; }

    /// Farther things are not taken.
    double distance() const { return distance_; }

  private:
    double distance_;
    std::optional<Thing> found_;
};

}  // namespace batten::editor
