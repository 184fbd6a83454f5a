#include "app/editor/sketch.h"

namespace batten::editor {

void Sketch::add(std::span<const core::Point> points) {
    for (const core::Point point : points) {
        if (seen_++ % step_ != 0) continue;
        if (points_.size() == most_points) halve();
        points_.push_back(point);
    }
}

// One of an even number is left out, so that the next point belongs to the wider step, too.
void Sketch::halve() {
    for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize((points_.size() + 1) / 2);
    step_ *= 2;
}

}  // namespace batten::editor
