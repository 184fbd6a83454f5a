/// Solves linear equations, square or overdetermined, each of which involves only a few neighboring unknowns.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/detail/short_list.h"
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
    ShortList<double, 8> coefficients{};
    P right{};
};

/// The triangle R of a QR factorization that takes one equation after the other by Givens rotations, so that only the
/// band is kept. Source: Golub and Van Loan, Matrix Computations, 5.1 and 5.2; Dierckx 1993, chapter 4.
template <class P>
class BandedTriangle {
  public:
    /// No equation may have more than `width` (>= 1) coefficients, nor any beyond the last unknown.
    BandedTriangle(std::size_t unknowns, std::size_t width)
        : width_(width), rows_(unknowns * width, 0.0), right_(unknowns, P{}), work_(width) {
        assert(width >= 1);
    }

    /// Linear in all when the equations come with ascending `first`: there is nothing to do where nothing came yet.
    void add(const BandedEquation<P>& equation) {
        assert(equation.coefficients.size() <= width_);
        assert(equation.first + equation.coefficients.size() <= right_.size());
        reach_ = std::max(reach_, equation.first + equation.coefficients.size());
        if (width_ == cubic_width) {
            std::array<double, cubic_width> work;
            add(equation, work, std::integral_constant<std::size_t, cubic_width>());
        } else {
            add(equation, work_, width_);
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

    // The equations that there are most of have these four coefficients.
    static constexpr std::size_t cubic_width = 4;

    // Unrolled where the width is known. Numbers that rotate with the first of a row move up by one place.
    template <class Numbers, class Width>
    void add(const BandedEquation<P>& equation, Numbers& work, Width width) {
        std::fill(work.begin(), work.end(), 0.0);
        std::copy(equation.coefficients.begin(), equation.coefficients.end(), work.begin());
        P right = equation.right;
        for (std::size_t k = equation.first; k < reach_; ++k) {
            double* const row = &rows_[k * width];
            if (work[0] != 0.0 && row[0] == 0.0) {
                std::copy(work.begin(), work.end(), row);
                right_[k] = right;
                return;
            }
            if (work[0] != 0.0) rotate(row, right_[k], work, right, width);
            for (std::size_t j = 1; j < width; ++j) work[j - 1] = work[j];
            work[width - 1] = 0.0;
        }
    }

    template <class Numbers, class Width>
    static void rotate(double* row, P& row_right, Numbers& work, P& right, Width width) {
        const double share = 1.0 / length_of(row[0], work[0]);
        const double c = row[0] * share;
        const double s = work[0] * share;
        for (std::size_t j = 0; j < width; ++j) {
            const double old = row[j];
            row[j] = c * old + s * work[j];
            work[j] = c * work[j] - s * old;
        }
        const P old = row_right;
        row_right = c * old + s * right;
        right = c * right - s * old;
    }

    // Of any size; nearly all have a square.
    static double length_of(double a, double b) {
        constexpr double least = 1e-280;
        constexpr double most = 1e280;
        const double square = a * a + b * b;
        return least < square && square < most ? std::sqrt(square) : std::hypot(a, b);
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
std::optional<std::vector<P>> solve_least_squares(const std::vector<BandedEquation<P>>& equations, std::size_t unknowns,
                                                  const Progress& progress = {}) {
    std::size_t width = 1;
    for (const auto& equation : equations) width = std::max(width, equation.coefficients.size());
    BandedTriangle<P> triangle(unknowns, width);
    const auto is_before = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::vector<std::size_t> order(equations.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!std::is_sorted(equations.begin(), equations.end(), is_before))
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t i, std::size_t j) { return is_before(equations[i], equations[j]); });
    for (std::size_t k = 0; k < equations.size(); ++k) {
        tell(progress, k, equations.size());
        triangle.add(equations[order[k]]);
    }
    return triangle.solve();
}

}  // namespace batten::core
