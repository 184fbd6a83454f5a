/// What is shown of a file while it is read.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

/// The control points read so far: all of them, or every second, fourth, eighth... where they are many.
class Sketch {
  public:
    /// There are never more of them.
    static constexpr std::size_t most_points = 16'384;

    /// Goes on with the next points. Cost: each point.
    void add(std::span<const core::Point> points);

    /// The points that are kept, in the order of the file.
    const std::vector<core::Point>& points() const { return points_; }

  private:
    void halve();

    std::vector<core::Point> points_;
    std::size_t step_ = 1;  // one of so many points is kept, a power of 2
    std::size_t seen_ = 0;
};

}  // namespace batten::editor
