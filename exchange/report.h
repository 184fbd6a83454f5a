/// What reading or writing a file of another program did to its curves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/document/file_text.h"

namespace batten::exchange {

/// How true a copy is.
struct Report {
    /// No point of a curve is farther from its copy; 0: the copy is exact; infinite: that is not known.
    double largest_error = 0.0;
    std::vector<std::string> left_out{};  ///< whole sentences: what is missing in the copy or other there, and why
    /// Whole sentences: what is lost of the look of a drawing, since curves have a color alone.
    std::vector<std::string> looks{};
    bool holds_samples = false;  ///< a table of points of the curves, not the curves: it has no such error
};

/// Curves that were read.
struct Imported {
    core::Document document;
    Report report{};
};

/// A file that is to be written.
struct Exported {
    std::string text;
    Report report{};
};

struct WriteOptions {
    /// How far a curve may be from its copy where the format cannot hold it as it is, in coordinates (> 0); none: a
    /// millionth of the larger side of the box of all curves.
    std::optional<double> tolerance{};
    std::size_t samples = 101;  ///< of each curve in a table of samples (>= 2)
};

/// Reads the whole content of a file. The error names the place ("line 12") and what is allowed.
using Reader = core::FileResult<Imported> (*)(std::string_view text);

/// Writes the visible curves, or says why they cannot be written in this format.
using Writer = core::FileResult<Exported> (*)(const core::Document& document, const WriteOptions& options);

}  // namespace batten::exchange
