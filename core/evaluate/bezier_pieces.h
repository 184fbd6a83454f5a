/// The Bézier pieces of a curve, one for each non-empty span.
#pragma once

#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// One rational polynomial piece in Bernstein form.
struct BezierPiece {
    Interval interval;                     ///< where in the curve's domain
    std::size_t span = 0;                  ///< the span index in the curve's knots
    std::vector<HomogeneousPoint> points;  ///< p+1 control points
};

/// The pieces of a curve in order, their points one after the other in one array: points(k) costs nothing, while a
/// BezierPiece has a copy of its own.
class BezierPieces {
  public:
    std::size_t size() const { return spans_.size(); }

    /// The index of piece k's span in the curve's knots, k < size().
    std::size_t span(std::size_t k) const { return spans_[k]; }
    Interval interval(std::size_t k) const { return {knots_[span(k)], knots_[span(k) + 1]}; }

    /// The control points of piece k in the plane.
    std::span<const Point> points(std::size_t k) const { return points_.values().subspan(k * order(), order()); }

    /// Their weights; none where the curve is not rational.
    std::span<const double> weights(std::size_t k) const {
        return weights_ ? weights_->values().subspan(k * order(), order()) : std::span<const double>();
    }

    BezierPiece operator[](std::size_t k) const;
    BezierPiece front() const { return (*this)[0]; }
    BezierPiece back() const { return (*this)[size() - 1]; }

    class Iterator {
      public:
        using iterator_category = std::input_iterator_tag;
        using value_type = BezierPiece;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = BezierPiece;

        Iterator(const BezierPieces& pieces, std::size_t k) : pieces_(&pieces), k_(k) {}
        BezierPiece operator*() const { return (*pieces_)[k_]; }
        Iterator& operator++() {
            ++k_;
            return *this;
        }
        Iterator operator++(int) { return {*pieces_, k_++}; }
        bool operator==(const Iterator&) const = default;

      private:
        const BezierPieces* pieces_;
        std::size_t k_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size()}; }

  private:
    friend BezierPieces bezier_pieces(const Curve& curve, std::size_t first, std::size_t last);

    BezierPieces(KnotVector knots, SharedArray<std::size_t> spans, SharedArray<Point> points)
        : knots_(std::move(knots)), spans_(std::move(spans)), points_(std::move(points)) {}

    std::size_t order() const { return static_cast<std::size_t>(knots_.degree()) + 1; }

    KnotVector knots_;
    SharedArray<std::size_t> spans_;
    SharedArray<Point> points_;
    double common_weight_ = 1.0;  // where there are no others
    std::optional<SharedArray<double>> weights_{};
};

/// The piece over span `span` (non-empty, in the domain). Cost O(p^3). Source: blossoms, b(a, ..., a, b, ..., b).
BezierPiece bezier_piece(const Curve& curve, std::size_t span);

/// The pieces over the non-empty spans among `first`..`last`, spans of the domain, in order. Cost and source as below.
BezierPieces bezier_pieces(const Curve& curve, std::size_t first, std::size_t last);

/// All pieces in order. Cost O(p^2) for each, which has p+1 points. Source: The NURBS Book, A5.6.
BezierPieces bezier_pieces(const Curve& curve);

}  // namespace batten::core
