/// Writes curves as IGES files, through OpenCASCADE.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// Each visible curve as entity 126 (rational B-spline curve) with all digits of its numbers; names become labels of
/// eight characters. Periodic and
/// unclamped curves are clamped, which changes no point. Errors: no curve that can be written; those of ask_occt().
core::FileResult<Exported> write_iges(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
