#include "core/base/detail/symmetric_band.h"

#include <gtest/gtest.h>

#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// A positive definite matrix: its diagonal outweighs the rest.
SymmetricBand random_matrix(std::size_t size, std::size_t width) {
    RandomCurves random(17);
    SymmetricBand matrix(size, width);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = matrix.first_of(i); j < i; ++j) matrix.at(i, j) = random.number(-1.0, 1.0);
        matrix.at(i, i) = 2.0 * static_cast<double>(width) + 1.0;
    }
    return matrix;
}

}  // namespace

TEST(SymmetricBand, is_solved) {
    // [4 1 0; 1 3 1; 0 1 2] (1, 2, 3) = (6, 10, 8)
    SymmetricBand matrix(3, 1);
    matrix.at(0, 0) = 4;
    matrix.at(1, 0) = 1;
    matrix.at(1, 1) = 3;
    matrix.at(2, 1) = 1;
    matrix.at(2, 2) = 2;
    std::vector<double> x{6, 10, 8};
    EXPECT_EQ(matrix.times(std::vector<double>{1, 2, 3}), x);
    BandFactors(matrix).solve(x);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(x[i], static_cast<double>(i + 1), 1e-14);
    matrix.at(2, 2) = -2;
    EXPECT_FALSE(BandFactors(matrix).is_definite());
}

TEST(SymmetricBand, has_the_inverse_on_its_diagonals) {
    for (const std::size_t width : {0UL, 1UL, 3UL, 6UL}) {
        const SymmetricBand matrix = random_matrix(12, width);
        const BandFactors factors(matrix);
        const SymmetricBand inverse = factors.inverse();
        double trace = 0.0;
        for (std::size_t j = 0; j < 12; ++j) {
            std::vector<double> column(12, 0.0);
            column[j] = 1.0;
            factors.solve(column);
            for (std::size_t i = j; i < std::min<std::size_t>(12, j + width + 1); ++i)
                EXPECT_NEAR(inverse.at(i, j), column[i], 1e-15);
            trace += matrix.times(column)[j];
        }
        // That of the identity.
        EXPECT_NEAR(inverse.trace_of_product(matrix), trace, 1e-13);
        EXPECT_NEAR(trace, 12.0, 1e-13);
    }
}

}  // namespace batten::core
