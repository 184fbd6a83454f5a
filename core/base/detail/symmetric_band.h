/// Symmetric matrices of few diagonals: solved, and of their inverse what lies on these diagonals.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace batten::core {

/// A symmetric matrix whose entries (i, j) are 0 for |i - j| > width.
class SymmetricBand {
  public:
    SymmetricBand(std::size_t size, std::size_t width)
        : size_(size), width_(width), entries_(size * (width + 1), 0.0) {}

    std::size_t size() const { return size_; }
    std::size_t width() const { return width_; }

    /// Entry (i, j), i >= j >= i - width.
    double& at(std::size_t i, std::size_t j) { return entries_[place(i, j)]; }
    double at(std::size_t i, std::size_t j) const { return entries_[place(i, j)]; }

    /// The first column of row i.
    std::size_t first_of(std::size_t i) const { return i - std::min(i, width_); }

    /// this + factor other, which has the same size and width.
    SymmetricBand plus(double factor, const SymmetricBand& other) const {
        SymmetricBand sum = *this;
        for (std::size_t k = 0; k < entries_.size(); ++k) sum.entries_[k] += factor * other.entries_[k];
        return sum;
    }

    /// The sum of all products of entries that stand at the same place: the trace of this times `other`.
    double trace_of_product(const SymmetricBand& other) const;

    /// this times `vector`.
    std::vector<double> times(std::span<const double> vector) const;

  private:
    std::size_t place(std::size_t i, std::size_t j) const {
        assert(j <= i && i - j <= width_ && i < size_);
        return i * (width_ + 1) + (i - j);
    }

    std::size_t size_;
    std::size_t width_;
    std::vector<double> entries_;
};

/// L D L^T of a positive definite matrix, L with ones on its diagonal. Cost O(n w^2). Source: Golub and Van Loan,
/// Matrix Computations, 4.3.
class BandFactors {
  public:
    explicit BandFactors(SymmetricBand matrix);

    /// Whether every number of D is positive, so that the other questions may be asked.
    bool is_definite() const { return is_definite_; }

    /// The solution x of matrix x = right, in its place.
    void solve(std::span<double> right) const;

    /// The entries of the inverse on the diagonals of the matrix. Cost O(n w^2). Source: Hutchinson and de Hoog 1985,
    /// Smoothing noisy data with spline functions.
    SymmetricBand inverse() const;

  private:
    SymmetricBand factors_;  ///< L below the diagonal, D on it
    bool is_definite_ = true;
};

}  // namespace batten::core
