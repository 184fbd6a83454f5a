#include "core/make/detail/site_means.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/detail/vectorized.h"
#include "core/base/double_double.h"

namespace batten::core {

namespace {

constexpr std::size_t means_at_once = 128;

// Sums of distances from the first site of each, in twice the precision.
struct DistanceSums {
    std::array<double, means_at_once> high{};
    std::array<double, means_at_once> low{};
};

BATTEN_VECTORIZED void add_distances(DistanceSums& sums, const double* first, const double* other, std::size_t count) {
    BATTEN_INDEPENDENT
    for (std::size_t j = 0; j < count; ++j) {
        const DoubleDouble distance = exact_sum(other[j], -first[j]);
        const DoubleDouble sum = exact_sum(sums.high[j], distance.high);
        sums.high[j] = sum.high;
        sums.low[j] += sum.low + distance.low;
    }
}

BATTEN_VECTORIZED void set_means(const DistanceSums& sums, const double* sites, std::size_t p, double* means,
                                 std::size_t count) {
    // A number without its last bits has an exact product with p.
    constexpr double six_bits = 65.0;
    const auto divisor = static_cast<double>(p);
    const double share = 1.0 / divisor;
    BATTEN_INDEPENDENT
    for (std::size_t j = 0; j < count; ++j) {
        const double quotient = share * sums.high[j];
        const double scaled = six_bits * quotient;
        const double front = scaled - (scaled - quotient);
        const double rest = ((sums.high[j] - divisor * front) - divisor * (quotient - front)) + sums.low[j];
        const DoubleDouble mean = exact_sum(sites[j], quotient);
        const double rounded = mean.high + (mean.low + share * rest);
        const double at_least = rounded < sites[j] ? sites[j] : rounded;
        means[j] = at_least > sites[j + p - 1] ? sites[j + p - 1] : at_least;
    }
}

}  // namespace

void mean_of_sites(std::span<const double> sites, std::size_t p, std::span<double> means) {
    assert(p >= 1 && sites.size() >= means.size() + p - 1);
    for (std::size_t from = 0; from < means.size(); from += means_at_once) {
        const std::size_t count = std::min(means_at_once, means.size() - from);
        const double* const first = sites.data() + from;
        DistanceSums sums;
        for (std::size_t i = 1; i < p; ++i) add_distances(sums, first, first + i, count);
        set_means(sums, first, p, means.data() + from, count);
    }
}

}  // namespace batten::core
