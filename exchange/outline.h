/// Outlines as drawing programs and fonts have them: lines, Bézier pieces and arcs of conics one after another, which
/// become one curve.
#pragma once

#include <cstdint>
#include <vector>

#include "core/curve/curve.h"

namespace batten::exchange {

class Outline {
  public:
    explicit Outline(core::Point start);

    core::Point start() const { return points_.front(); }
    core::Point end() const { return points_.back(); }

    /// Whether nothing is drawn.
    bool is_empty() const { return pieces_.empty(); }
    bool is_closed() const { return is_closed_; }

    /// Each goes on from the end; a piece that stays there is left out.
    void line_to(core::Point end);
    void quadratic_to(core::Point corner, core::Point end);
    void cubic_to(core::Point first, core::Point second, core::Point end);

    /// The quadratic piece with the weights 1, `weight` (> 0), 1.
    void conic_to(core::Point corner, double weight, core::Point end);

    /// Makes it closed, with a line to its start where it does not end there. An end that is nearer to it than a
    /// millionth of the outline, as sums of rounded steps are, is moved onto it.
    void close();

    /// How far close() moved the end: 0 for what the rounding of doubles alone explains.
    double closing_gap() const { return closing_gap_; }

    /// One curve of all pieces, one unit of the parameter each. Its degree is the highest of the pieces, the knots
    /// between them have it as multiplicity; closed outlines are periodic. There must be a piece. Errors: those of
    /// Curve::make.
    [[nodiscard]] core::Result<core::Curve> curve() const;

  private:
    struct Piece {
        std::uint8_t degree = 1;
        double weight = 1.0;  // of the middle point where the degree is 2
    };

    void append(Piece piece, std::initializer_list<core::Point> points);

    std::vector<core::Point> points_;  // the start, then those of each piece but its first
    std::vector<Piece> pieces_;
    bool is_closed_ = false;
    double closing_gap_ = 0.0;
};

}  // namespace batten::exchange
