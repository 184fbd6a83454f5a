/// What the program batten-occt does: curves out of files that OpenCASCADE reads, and into files that it writes.
#pragma once

#include <string>

#include "exchange/report.h"

namespace batten::exchange::occt {

/// The curves of the file at `path`. The error says why there are none.
core::FileResult<Imported> read_iges(const std::string& path);

/// The same of the content of a file.
core::FileResult<Imported> read_step(const std::string& text);

core::FileResult<Exported> write_iges(const core::Document& document);
core::FileResult<Exported> write_step(const core::Document& document);

}  // namespace batten::exchange::occt
