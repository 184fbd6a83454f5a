/// The length of a curve, and the parameter at a given length.
#pragma once

#include <vector>

#include "core/measure/detail/speed_form.h"

namespace batten::core {

/// An integral and how far it may be from the truth.
struct Integral {
    double value = 0.0;
    double error = 0.0;  ///< an estimate from above: the differences of two rules, and rounding
};

/// Whether an integral that is not negative is finite and known to six digits. Lengths are, unless the numbers of the
/// curve are beyond what can be computed.
bool is_sharp(const Integral& integral);

/// The length of the whole curve, right to about 1e-12 of itself (gaps are not counted). Adaptive Gauss-Kronrod (10, 21
/// points) on every span. Source: Piessens et al. 1983, QUADPACK.
Integral arc_length(const Curve& curve);

/// The length from one parameter to another, both numbers, negative if `to` < `from`. Parameters outside the domain are
/// clamped to it; on a periodic curve they go round as often as they say. As right as the whole length.
Integral arc_length(const Curve& curve, double from, double to);

/// Lengths and parameters of one curve, for many questions.
class ArcLengthTable {
  public:
    /// Measures the curve once, in parts on which one rule is exact to rounding.
    explicit ArcLengthTable(const Curve& curve);

    Integral total() const { return total_; }

    /// The length from the beginning of the domain to `u`, which is clamped to the domain (wrapped when periodic, the
    /// upper end staying as it is). Cost: one binary search and 21 evaluations.
    double length_at(double u) const;

    /// The parameter at the length `s` from the beginning of the domain; `s`, a number, is clamped to [0, total]
    /// (wrapped when periodic). Where a stretch has no length, its beginning. Newton's iteration in a bracket that
    /// shrinks.
    double parameter_at(double s) const;

  private:
    struct Part {
        std::size_t half = 0;
        Interval offsets;  // on that half of a piece; of a plain piece on all of it
        double length = 0.0;
        double before = 0.0;  // the length of all parts before
    };

    double offset_of(const Part& part, double u) const;
    double length_within(const Part& part, double offset) const;
    double offset_at(const Part& part, double length) const;

    KnotVector knots_;
    std::vector<PieceMotion> pieces_;
    std::vector<SpeedForm> forms_;  // of the pieces
    std::vector<Part> parts_;
    Integral total_;
};

}  // namespace batten::core
