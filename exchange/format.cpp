#include "exchange/format.h"

#include "core/base/ascii.h"
#include "exchange/cad/cad_files.h"
#include "exchange/csv_writer.h"
#include "exchange/dxf/dxf_reader.h"
#include "exchange/dxf/dxf_writer.h"
#include "exchange/json/json_dialects_reader.h"
#include "exchange/json/json_dialects_writer.h"
#include "exchange/svg/svg_reader.h"
#include "exchange/svg/svg_writer.h"

namespace batten::exchange {

namespace {

#ifdef BATTEN_HAS_OPENCASCADE
constexpr bool has_opencascade = true;
#else
constexpr bool has_opencascade = false;
#endif

}  // namespace

std::span<const FormatSpec> all_formats() {
    static const std::vector<FormatSpec> formats{
        {
            .format = Format::svg,
            .endings = {".svg"},
            .note = "paths as Bézier pieces, within a millionth of the size where they are not cubic",
            .read = read_svg,
            .write = write_svg,
        },
        {
            .format = Format::dxf,
            .endings = {".dxf"},
            .note = "curves as splines, with all their knots and weights",
            .read = read_dxf,
            .write = write_dxf,
        },
        {
            .format = Format::nurbs_python,
            .endings = {".nurbs-python.json"},
            .note = "n + p + 1 knots, weights apart from the points",
            .read = read_nurbs_python,
            .write = write_nurbs_python,
        },
        {
            .format = Format::tinyspline,
            .endings = {".tinyspline.json"},
            .note = "homogeneous control points (xw, yw, w) where weights differ",
            .read = read_tinyspline,
            .write = write_tinyspline,
        },
        {
            .format = Format::rhino,
            .endings = {".rhino.json"},
            .note = "n + p − 1 knots: one fewer at each end",
            .read = read_rhino,
            .write = write_rhino,
        },
        {
            .format = Format::opencascade,
            .endings = {".opencascade.json"},
            .note = "distinct knots with their multiplicities",
            .read = read_opencascade,
            .write = write_opencascade,
        },
        {
            .format = Format::iges,
            .endings = {".igs", ".iges"},
            .note = "plane curves of type 126",
            .read = has_opencascade ? read_iges : nullptr,
            .write = has_opencascade ? write_iges : nullptr,
        },
        {
            .format = Format::step,
            .endings = {".step", ".stp"},
            .note = "plane curves with distinct knots and multiplicities",
            .read = has_opencascade ? read_step : nullptr,
            .write = has_opencascade ? write_step : nullptr,
        },
        {
            .format = Format::csv,
            .endings = {".csv"},
            .note = "samples with u, x, y, derivatives and curvature",
            .write = write_csv,
        }};
    return formats;
}

const FormatSpec& spec_of(Format format) {
    return all_formats()[static_cast<std::size_t>(format)];
}

std::optional<Format> format_of(const std::filesystem::path& path) {
    const std::string name = core::in_small_letters(path.filename().string());
    std::optional<Format> found;
    std::size_t longest = 0;
    for (const FormatSpec& spec : all_formats()) {
        for (const std::string& ending : spec.endings) {
            if (ending.size() <= longest || ending.size() >= name.size() || !name.ends_with(ending)) continue;
            found = spec.format;
            longest = ending.size();
        }
    }
    return found;
}

}  // namespace batten::exchange
