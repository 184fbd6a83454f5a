/// What writers write of a document.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The visible curves of `document`, which must live as long; refused where there is none.
[[nodiscard]] core::FileResult<std::vector<const core::DocumentCurve*>> visible_curves(const core::Document& document);

/// The curve over a full knot vector: itself, and a periodic one with its control points wrapped, over the knots of its
/// unrolled vector. It has the same points over the same domain. No weights where all are 1.
core::CurveDefinition full_definition(const core::Curve& curve);

/// Sentences about the parts of `document` beside its visible curves that formats of curves have no place for.
std::vector<std::string> parts_left_out(const core::Document& document);

}  // namespace batten::exchange
