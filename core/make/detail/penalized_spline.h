/// Cubic splines near samples of a stroke whose third derivative counts as an error, too.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/detail/symmetric_band.h"
#include "core/curve/knot_vector.h"

namespace batten::core {

/// Where the pen was.
struct StrokeSample {
    double station = 0.0;  ///< the way along the stroke until there
    Vector place{};
    double weight = 1.0;
};

/// How much the third derivative counts: of each stretch its end, ascending, and the factor. Beyond the last it is 1.
struct Stretch {
    double end = 0.0;
    double factor = 1.0;
};
using Stiffness = std::vector<Stretch>;

/// The equations for the control points of a cubic over given knots with the least
///     sum weight |C(station) - place|^2 + lambda h^5 integral |C'''|^2,
/// which over uniform spans of length h is the P-spline with third differences. Source: Eilers and Marx 1996, Flexible
/// smoothing with B-splines and penalties.
class PenalizedSpline {
  public:
    /// Cost O(m) for m samples, whose stations are in the domain. `span` is h.
    PenalizedSpline(const KnotVector& knots, std::span<const StrokeSample> samples, double span,
                    const Stiffness& stiffness = {});

    /// The control points; none where the equations are singular. Cost O(n).
    std::optional<std::vector<Vector>> solve(double lambda) const;

    /// The lambda of least generalised cross-validation, which takes for noise what a hand does not mean: errors of a
    /// fraction of a unit, and waves of a few units. Cost: some 40 times that of solve. Source: Craven and Wahba 1979,
    /// Smoothing noisy data with spline functions.
    double best_lambda() const;

  private:
    double score(double lambda) const;
    std::optional<std::vector<Vector>> solved(const BandFactors& factors) const;
    std::size_t unknown(std::size_t unrolled) const;
    void add_penalty(const KnotVector& knots, double span, const Stiffness& stiffness);
    void add(SymmetricBand& matrix, std::size_t first, std::span<const double> row, double weight) const;

    std::size_t count_;
    bool is_ring_;
    SymmetricBand normal_;
    SymmetricBand penalty_;
    SymmetricBand ridge_;
    std::vector<double> right_x_;
    std::vector<double> right_y_;
    double way_;
    double square_sum_ = 0.0;
    double weight_sum_ = 0.0;
};

}  // namespace batten::core
