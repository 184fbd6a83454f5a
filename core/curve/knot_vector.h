/// A non-decreasing sequence of knots together with the degree it is meant for.
#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "core/base/curve_error.h"
#include "core/base/degree_range.h"
#include "core/base/geometry.h"
#include "core/base/names.h"
#include "core/base/shared_array.h"

namespace batten::core {

/// Error: degree_out_of_range, unless `degree` is from min_degree to max_degree.
[[nodiscard]] Result<void> check_degree(int degree);

/// How the knots came about. A special kind stays special when points are added; a custom vector is never regenerated.
enum class KnotKind {
    uniform,           ///< equally spaced, unclamped
    clamped_uniform,   ///< ends of multiplicity p+1, equally spaced inside
    bezier,            ///< one piece, both ends of multiplicity p+1
    piecewise_bezier,  ///< ends of multiplicity p+1, every interior knot of multiplicity p
    periodic,          ///< equally spaced and periodic
    custom             ///< anything else, or typed by hand
};

template <>
struct Names<KnotKind> {
    static constexpr std::array table{Named{KnotKind::uniform, "uniform", "uniform"},
                                      Named{KnotKind::clamped_uniform, "clamped-uniform", "clamped uniform"},
                                      Named{KnotKind::bezier, "bezier", "Bézier"},
                                      Named{KnotKind::piecewise_bezier, "piecewise-bezier", "piecewise Bézier"},
                                      Named{KnotKind::periodic, "periodic", "periodic"},
                                      Named{KnotKind::custom, "custom", "custom"}};
};

/// Which one-sided limit is meant at a knot.
enum class Side { left, right };

template <>
struct Names<Side> {
    static constexpr std::array table{Named{Side::left, "left", "left"}, Named{Side::right, "right", "right"}};
};

/// Whether an interior knot may have multiplicity p+1, which tears the curve apart.
enum class Tears { refuse, allow };

/// An immutable, valid knot vector u_0 <= ... <= u_m of a degree p.
///
/// A periodic vector is given as one period t_0 <= ... <= t_n for n control points and unrolled to both sides by
/// u_{p+k} = t_k, u_{i+n} = u_i + (t_n - t_0), so that every algorithm sees an ordinary vector and control point i of
/// the unrolled curve is point i mod n.
class KnotVector {
  public:
    /// The full textbook vector of m+1 = n+p+2 knots. Values are kept as they are.
    /// Checked in this order: degree, count (at least 2p+2), finite, non-decreasing, first and last so near that their
    /// difference is a double, domain not empty, multiplicities (ends of the domain p+1, all others p, or p+1 with
    /// Tears::allow). A `kind` that the values do not have becomes
    /// custom.
    [[nodiscard]] static Result<KnotVector> make(int degree, std::vector<double> knots,
                                                 KnotKind kind = KnotKind::custom, Tears tears = Tears::refuse);

    /// One period of n+1 knots for n >= 2 control points; same order of checks, but for the distance of the unrolled
    /// knots at last. No knot exceeds multiplicity p, the
    /// seam's counted across the seam.
    [[nodiscard]] static Result<KnotVector> make_periodic(int degree, std::vector<double> period,
                                                          KnotKind kind = KnotKind::custom);

    int degree() const { return degree_; }
    KnotKind kind() const { return kind_; }
    bool is_periodic() const { return is_periodic_; }

    /// Control points that a curve over these knots has (n for a periodic vector of one period n+1).
    std::size_t control_point_count() const;

    /// The knots u_0..u_m, unrolled when periodic. Copies of a vector share them.
    std::span<const double> values() const { return values_.values(); }
    double operator[](std::size_t i) const {
        assert(i < values_.size());
        return values_[i];
    }
    std::size_t size() const { return values_.size(); }

    /// The knots as they are stored and shown: all of them, or one period.
    std::span<const double> stored() const;

    /// Index into values() of stored()[0]: 0, or p when periodic.
    std::size_t stored_offset() const { return is_periodic_ ? static_cast<std::size_t>(degree_) : 0; }

    /// [u_p, u_{m-p}]; never empty.
    Interval domain() const {
        const auto p = static_cast<std::size_t>(degree_);
        return {values_[p], values_[values_.size() - p - 1]};
    }

    /// The index s with u_s <= u < u_{s+1} (Side::right) or u_s < u <= u_{s+1} (Side::left), always a non-empty span
    /// of the domain: at and beyond the domain's ends the first or last one, for what is not a number the first. Cost
    /// O(log n).
    std::size_t span_at(double u, Side side = Side::right) const;

    /// How often exactly `u`, a number, occurs; across the seam when periodic.
    int multiplicity(double u) const;

    /// The parameter brought into the domain: wrapped by whole periods when periodic, else clamped. Both ends stay as
    /// they are. What is not finite and so cannot be wrapped, or is not a number, becomes the lower end.
    double into_domain(double u) const;

    /// The same, and at the seam of a periodic vector that end of the domain which lies on `side` of it: seen from the
    /// right the seam is the lower end, seen from the left the upper one.
    double into_domain(double u, Side side) const;

    bool operator==(const KnotVector&) const = default;

  private:
    friend struct Trusted;

    KnotVector(int degree, bool is_periodic, KnotKind kind, SharedArray<double> values);
    static KnotVector of_kind_or_custom(int degree, bool is_periodic, KnotKind kind, SharedArray<double> values);

    int degree_ = 0;
    bool is_periodic_ = false;
    KnotKind kind_ = KnotKind::custom;
    SharedArray<double> values_;
};

/// `below` knots before one period t_0..t_n, n >= 1, the period itself and `above` knots after it, continued by
/// u_{i+n} = u_i + (t_n - t_0); knots that are equal in the period stay equal in its copies.
std::vector<double> unroll_period(std::span<const double> period, std::size_t below, std::size_t above);

}  // namespace batten::core
