/// Circles of a given radius that touch two curves: the crossings of their offsets.
#pragma once

#include <vector>

#include "core/curve/curve.h"
#include "core/measure/detail/box_tree.h"

namespace batten::core {

/// A circle that touches one curve at u and another at v.
struct TouchingCircle {
    double u = 0.0;
    double v = 0.0;
    Point center{};
    Point on_first{};
    Point on_second{};
    Vector along_first{};   ///< C'(u)
    Vector along_second{};  ///< C'(v)
};

/// A smooth stretch of a curve, so short that it bends little, with the normals to the left of its ends.
struct SmoothStretch {
    Interval range;  ///< the parameters
    Interval run;    ///< of the whole part of the curve up to the next corners
    Point from;
    Point to;
    Vector normal_from;
    Vector normal_to;
};

/// A curve prepared for many questions.
class TouchingFinder {
  public:
    /// For two curves, or for one with itself where `second` is the same object. Cost O(n p^3).
    TouchingFinder(const Curve& first, const Curve& second);

    /// All circles of this radius (> 0) that are found from pairs of stretches whose offsets are near each other.
    std::vector<TouchingCircle> circles(double radius) const;

    /// How many stretches there are: what a question costs.
    std::size_t stretch_count() const { return stretches_of_first_.size() + stretches_of_second_.size(); }

    /// About the size of both curves.
    double size() const { return size_; }

  private:
    // Adds those of offsets by these distances to the left; `tree` holds the offsets of the second curve.
    void add_circles(std::vector<TouchingCircle>& found, const BoxTree& tree, double by_first, double by_second) const;

    Point origin_;
    Curve first_;  // both seen from the origin
    Curve second_;
    bool is_one_;
    double size_ = 0.0;
    std::vector<SmoothStretch> stretches_of_first_;
    std::vector<SmoothStretch> stretches_of_second_;
};

}  // namespace batten::core
