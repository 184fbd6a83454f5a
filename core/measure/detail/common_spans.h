/// The parts into which the knots of two curves cut both, their domains matched affinely.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// A part of one span of either curve; equal shares of both intervals are one parameter.
struct CommonSpan {
    std::size_t span_of_a = 0;  ///< as at SpanKnots
    std::size_t span_of_b = 0;
    Interval part_of_a;
    Interval part_of_b;
};

/// The parts in which the curves are not written the same, in order; in the others no computation can tell them apart.
/// Knots of different domains that differ by no more than rounding are one, so that a tear which both curves have is no
/// distance between them. Cost: a comparison of the numbers of both curves that are not shared, and more only from the
/// first to the last of the parts.
std::vector<CommonSpan> differing_spans(const Curve& a, const Curve& b);

}  // namespace batten::core
