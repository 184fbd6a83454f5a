/// Writes a table of points of curves with their derivatives and curvature.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// A line of headings, then for each visible curve `options.samples` rows at even parameters from one end of its domain
/// to the other: its name, u, C(u), C'(u), C''(u), the signed curvature. Each knot inside at which a derivative up to
/// the second may jump has two rows, seen from the left and from the right, beside those. Where there is no finite
/// number a cell is empty. Commas separate cells and decimals have points, whatever the locale. Cost O(p^2 + log n) for
/// each row.
[[nodiscard]] core::FileResult<Exported> write_csv(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
