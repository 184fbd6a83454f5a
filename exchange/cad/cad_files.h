/// Reads and writes curves in IGES and STEP files, through OpenCASCADE.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// The lines, conics, Bézier and B-spline curves in planes z = constant, in the unit of the file; periodic ones stay
/// so. Errors: those of iges_defect() or step_defect(), which find what OpenCASCADE takes for zeros; what OpenCASCADE
/// cannot read; no such curve; those of ask_occt().
core::FileResult<Imported> read_iges(std::string_view text);
core::FileResult<Imported> read_step(std::string_view text);

/// Each visible curve as entity 126 (rational B-spline curve), or as B_SPLINE_CURVE_WITH_KNOTS, rational where it is,
/// with all digits of its numbers; names become labels of eight characters in IGES. Periodic and unclamped curves are
/// clamped. Errors: no curve that can be written; those of ask_occt().
core::FileResult<Exported> write_iges(const core::Document& document, const WriteOptions& options);
core::FileResult<Exported> write_step(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
