/// Writes curves as SPLINE entities of a DXF file.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The visible curves as DXF of AutoCAD 2007 in UTF-8, each on a layer of its name, in its color. Exact but
/// for unrolling_error(): a periodic curve is written unrolled, with wrapped control points, and marked as closed.
/// Units that DXF has are written. Cost O(n).
[[nodiscard]] core::FileResult<Exported> write_dxf(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
