/// Writes curves as other libraries keep them in JSON; see json_dialects_reader.h and FORMATS.md.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The visible curves, exactly; periodic ones with wrapped control points, off by what their wrapped knots are rounded.
[[nodiscard]] core::FileResult<Exported> write_nurbs_python(const core::Document& document,
                                                            const WriteOptions& options);

/// Likewise, one curve as an object and several as a list, which the library itself does not read. Rational curves have
/// homogeneous points and say so; the error is also what multiplying by the weights rounds.
[[nodiscard]] core::FileResult<Exported> write_tinyspline(const core::Document& document, const WriteOptions& options);

/// Likewise without the first and the last knot, on which no point of a curve depends.
[[nodiscard]] core::FileResult<Exported> write_rhino(const core::Document& document, const WriteOptions& options);

/// The visible curves, exactly, with distinct knots; periodic ones as such, whose poles begin at the last of equal
/// knots at the seam.
[[nodiscard]] core::FileResult<Exported> write_opencascade(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
