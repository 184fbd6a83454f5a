/// One knot taken out of a spline, the inverse of inserting it, for every point type.
#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/curve/detail/bspline.h"

namespace batten::core {

/// The points that a removal puts in place of others, and the error it makes: e_i = +-shares_i error for each of the
/// old points that are replaced, alternating, so that a spline of shares 1 changes by no more than `error`.
template <class P>
struct SplineRemoval {
    std::vector<P> points;
    P error;
};

/// Taking out one knot `u` of multiplicity m replaces the p-m+1 points r-p..r-m (u_r the last knot that equals u) by
/// p-m others. `ratios` are those of u between u_i and u_{i+p+1} for these i, `shares` (> 0) say how much each of them
/// may move beside the others; `points` are the old ones with one more on either side. The ratios fall from one i to
/// the next. Cost O(p).
template <class P>
SplineRemoval<P> removal(std::span<const Ratio> ratios, std::span<const double> shares, std::span<const P> points) {
    const std::size_t count = ratios.size();
    assert(1 <= count && count <= max_degree && shares.size() == count && points.size() == count + 2);
    // The equations have one relation: sum z_i P_i = 0 with z_{i+1} / z_i = -alpha_i / (1 - alpha_{i+1}). |z| is
    // largest where alpha passes 1/2; computed from there it falls to both sides.
    std::size_t middle = 0;
    while (middle + 1 < count && ratios[middle].upper_share >= ratios[middle + 1].lower_share) ++middle;
    std::array<double, max_degree> z;
    z[middle] = 1.0;
    for (std::size_t i = middle; i + 1 < count; ++i)
        z[i + 1] = -z[i] * (ratios[i].upper_share / ratios[i + 1].lower_share);
    for (std::size_t i = middle; i > 0; --i) z[i - 1] = -z[i] * (ratios[i].lower_share / ratios[i - 1].upper_share);

    const P& near = points[middle + 1];
    P sum = (-z[0] * ratios[0].lower_share) * (points[0] - near) +
            (-z[count - 1] * ratios[count - 1].upper_share) * (points[count + 1] - near);
    double size = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum = sum + z[i] * (points[i + 1] - near);
        size += std::abs(z[i]) * shares[i];
    }
    const P error = (1.0 / size) * sum;

    // Q_i = P_i + (1 - alpha_i) / alpha_i (P_i - Q_{i-1}) from the left, Q_{i-1} likewise from the right.
    std::vector<P> result(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count) - 1);
    const auto corrected = [&](std::size_t i) {
        return points[i + 1] - ((i + middle) % 2 == 0 ? shares[i] : -shares[i]) * error;
    };
    P neighbor = points[0];
    for (std::size_t i = 0; i < middle; ++i) {
        const P point = corrected(i);
        neighbor = point + (ratios[i].lower_share / ratios[i].upper_share) * (point - neighbor);
        result[i] = neighbor;
    }
    neighbor = points[count + 1];
    for (std::size_t i = count - 1; i > middle; --i) {
        const P point = corrected(i);
        neighbor = point + (ratios[i].upper_share / ratios[i].lower_share) * (point - neighbor);
        result[i - 1] = neighbor;
    }
    return {std::move(result), error};
}

}  // namespace batten::core
