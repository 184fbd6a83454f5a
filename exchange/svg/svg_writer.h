/// Writes curves as SVG that also opens here again without loss.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The visible curves as paths: Bézier pieces where these are the curve itself (polynomial, degree 3 or less), arcs of
/// circles as such, else cubic pieces within the tolerance, whose largest error is reported. y is turned over, and the
/// file says where its zero is; the box of the curves is the viewBox, and the unit of the document that of width and
/// height. The native document is in the metadata, unless the file would be too large to be read. Errors: no visible
/// curve; a curve whose numbers are beyond what doubles can hold; a file too large to be read even so.
[[nodiscard]] core::FileResult<Exported> write_svg(const core::Document& document, const WriteOptions& options = {});

/// The same for readers that refuse files of more than `most_bytes`.
[[nodiscard]] core::FileResult<Exported> write_svg(const core::Document& document, const WriteOptions& options,
                                                   std::size_t most_bytes);

}  // namespace batten::exchange
