/// Writes curves as STEP files, through OpenCASCADE.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// Each visible curve as B_SPLINE_CURVE_WITH_KNOTS, rational where it is, with its name and all digits of its numbers.
/// Periodic and unclamped curves are clamped, which changes no point. Errors: no curve that can be written; those of
/// ask_occt().
core::FileResult<Exported> write_step(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
