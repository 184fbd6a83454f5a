/// Reads the curves of DXF files in their text form.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The curves of SPLINE, LWPOLYLINE, POLYLINE, LINE, ARC, CIRCLE and ELLIPSE entities of the model, each named after
/// its layer, with its color, hidden where its layer is off, locked where that is locked. Counts and flags of the file
/// are not believed, except that polylines are closed by their flag, as nothing else says so; weights of -1 are absent.
/// A SPLINE with the points alone that it passes is interpolated, with the tangents of its ends. Heights are let go,
/// with a sentence, and so are widths, line types, line weights and thicknesses. $INSUNITS become the units of the
/// document. Refused: what is not DXF or binary, a line that should be a group code, a file without its end mark. Cost
/// O(n).
[[nodiscard]] core::FileResult<Imported> read_dxf(std::string_view text);

}  // namespace batten::exchange
