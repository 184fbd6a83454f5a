/// Reads curves of IGES files, through OpenCASCADE.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The lines, conics, Bézier and B-spline curves in planes z = constant, in the unit of the file; periodic ones stay
/// so. Errors: what OpenCASCADE cannot read; no such curve; those of ask_occt().
core::FileResult<Imported> read_iges(std::string_view text);

}  // namespace batten::exchange
