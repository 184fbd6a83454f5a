/// Solves linear equations, square or overdetermined, each of which involves only a few neighboring unknowns.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"

namespace batten::core {

/// The place of unknown i of a ring of n in the order 0, n-1, 1, n-2, 2, ..., in which neighbors on the ring are never
/// farther apart than two places: what is banded around the ring becomes a plain band of twice the width.
constexpr std::size_t folded(std::size_t i, std::size_t n) {
    return 2 * i < n ? 2 * i : 2 * (n - 1 - i) + 1;
}

/// One equation: sum of coefficients[j] x_{first + j} = right. The unknowns and the right side are of the point type P
/// (double, Vector, HomogeneousPoint), the coefficients are numbers.
template <class P>
struct BandedEquation {
    std::size_t first = 0;
    std::vector<double> coefficients;
    P right{};
};

/// The triangle R of a QR factorization that takes one equation after the other by Givens rotations, so that only the
/// band is kept. Source: Golub and Van Loan, Matrix Computations, 5.1 and 5.2; Dierckx 1993, chapter 4.
template <class P>
class BandedTriangle {
  public:
    /// No equation may have more than `width` (>= 1) coefficients, nor any beyond the last unknown.
    BandedTriangle(std::size_t unknowns, std::size_t width)
        : width_(width), rows_(unknowns * width, 0.0), right_(unknowns, P{}), work_(width + 1) {
        assert(width >= 1);
    }

    /// Linear in all when the equations come with ascending `first`: there is nothing to do where nothing came yet.
    void add(const BandedEquation<P>& equation) {
        assert(equation.coefficients.size() <= width_);
        assert(equation.first + equation.coefficients.size() <= right_.size());
        reach_ = std::max(reach_, equation.first + equation.coefficients.size());
        std::fill(work_.begin(), work_.end(), 0.0);
        std::copy(equation.coefficients.begin(), equation.coefficients.end(), work_.begin());
        P right = equation.right;
        for (std::size_t k = equation.first; k < reach_; ++k) {
            double* const row = &rows_[k * width_];
            if (work_[0] != 0.0 && row[0] == 0.0) {
                std::copy(work_.begin(), work_.end() - 1, row);
                right_[k] = right;
                return;
            }
            if (work_[0] != 0.0) rotate(row, right_[k], right);
            std::copy(work_.begin() + 1, work_.end(), work_.begin());
        }
    }

    /// The unknowns; none where the equations do not determine them.
    std::optional<std::vector<P>> solve() const {
        std::vector<P> x = right_;
        for (std::size_t k = x.size(); k-- > 0;) {
            const double* const row = &rows_[k * width_];
            if (!(std::abs(row[0]) > least_share * column_norm(k))) return std::nullopt;
            for (std::size_t j = 1; j < width_ && k + j < x.size(); ++j) x[k] = x[k] - row[j] * x[k + j];
            x[k] = (1.0 / row[0]) * x[k];
        }
        return x;
    }

  private:
    // A column that has less of its own than this depends on those before it.
    static constexpr double least_share = 1e-14;

    void rotate(double* row, P& row_right, P& right) {
        const double length = std::hypot(row[0], work_[0]);
        const double c = row[0] / length;
        const double s = work_[0] / length;
        for (std::size_t j = 0; j < width_; ++j) {
            const double old = row[j];
            row[j] = c * old + s * work_[j];
            work_[j] = c * work_[j] - s * old;
        }
        const P old = row_right;
        row_right = c * old + s * right;
        right = c * right - s * old;
    }

    double column_norm(std::size_t column) const {
        double sum = 0.0;
        for (std::size_t j = 0; j < width_ && j <= column; ++j) {
            const double entry = rows_[(column - j) * width_ + j];
            sum += entry * entry;
        }
        return std::sqrt(sum);
    }

    std::size_t width_;
    std::size_t reach_ = 0;  ///< unknowns below this number have occurred
    std::vector<double> rows_;
    std::vector<P> right_;
    std::vector<double> work_;
};

/// The x_0, ..., x_{unknowns-1} with the least sum of squared errors; none where they are not determined. No equation
/// has coefficients beyond them. Cost O(m w^2) for m equations of at most w coefficients, of which O(m w) on the point
/// type.
template <class P>
std::optional<std::vector<P>> solve_least_squares(std::vector<BandedEquation<P>> equations, std::size_t unknowns,
                                                  const Progress& progress = {}) {
    std::stable_sort(equations.begin(), equations.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t width = 1;
    for (const auto& equation : equations) width = std::max(width, equation.coefficients.size());
    BandedTriangle<P> triangle(unknowns, width);
    for (std::size_t k = 0; k < equations.size(); ++k) {
        tell(progress, k, equations.size());
        triangle.add(equations[k]);
    }
    return triangle.solve();
}

}  // namespace batten::core
