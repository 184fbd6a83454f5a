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

/// All parts in order. Knots of different domains that differ by no more than rounding are one, so that a tear which
/// both curves have is no distance between them. Cost O(n).
std::vector<CommonSpan> common_spans(const Curve& a, const Curve& b);

/// Whether both curves are the same there because they are written the same: no computation can tell them apart.
bool is_written_alike(const Curve& a, const Curve& b, const CommonSpan& common);

}  // namespace batten::core
