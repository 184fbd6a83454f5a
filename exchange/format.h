/// The file formats that curves are read from and written to, by their names and the endings of files.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/names.h"
#include "exchange/report.h"

namespace batten::exchange {

enum class Format { svg, dxf, nurbs_python, tinyspline, rhino, opencascade, iges, step, csv };

/// What is known of a format.
struct FormatSpec {
    Format format;
    std::vector<std::string> endings;  ///< in small letters, the one that is written first: ".step", ".stp"
    const char* note;                  ///< how it differs from what is usual here, as a clause: "n + p − 1 knots"
    Reader read = nullptr;             ///< null: it is not read
    Writer write = nullptr;            ///< null: it is not written
};

/// All formats, in the order of Format. Those whose libraries are missing in this build are neither read nor written.
std::span<const FormatSpec> all_formats();

const FormatSpec& spec_of(Format format);

/// The format of the longest ending that the name of `path` has, in any case: ".tinyspline.json" before ".json". None
/// for native files and unknown endings.
std::optional<Format> format_of(const std::filesystem::path& path);

}  // namespace batten::exchange

namespace batten::core {

template <>
struct Names<exchange::Format> {
    using enum exchange::Format;
    static constexpr std::array table{Named{svg, "svg", "SVG"},
                                      Named{dxf, "dxf", "DXF"},
                                      Named{nurbs_python, "nurbs-python", "NURBS-Python"},
                                      Named{tinyspline, "tinyspline", "tinyspline"},
                                      Named{rhino, "rhino", "Rhino-style"},
                                      Named{opencascade, "opencascade", "OpenCASCADE-style"},
                                      Named{iges, "iges", "IGES"},
                                      Named{step, "step", "STEP"},
                                      Named{csv, "csv", "CSV"}};
};

}  // namespace batten::core
