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
    constexpr Reader from_iges = has_opencascade ? read_iges : nullptr;
    constexpr Reader from_step = has_opencascade ? read_step : nullptr;
    constexpr Writer to_iges = has_opencascade ? write_iges : nullptr;
    constexpr Writer to_step = has_opencascade ? write_step : nullptr;
    using enum Format;
    static const std::vector<FormatSpec> formats{
        {svg,
         {".svg"},
         "paths as Bézier pieces, within a millionth of the size where they are not cubic",
         read_svg,
         write_svg},
        {dxf, {".dxf"}, "curves as splines, with all their knots and weights", read_dxf, write_dxf},
        {nurbs_python,
         {".nurbs-python.json"},
         "n + p + 1 knots, weights apart from the points",
         read_nurbs_python,
         write_nurbs_python},
        {tinyspline,
         {".tinyspline.json"},
         "homogeneous control points (xw, yw, w) where weights differ",
         read_tinyspline,
         write_tinyspline},
        {rhino, {".rhino.json"}, "n + p − 1 knots: one fewer at each end", read_rhino, write_rhino},
        {opencascade,
         {".opencascade.json"},
         "distinct knots with their multiplicities",
         read_opencascade,
         write_opencascade},
        {iges, {".igs", ".iges"}, "plane curves of type 126", from_iges, to_iges},
        {step, {".step", ".stp"}, "plane curves with distinct knots and multiplicities", from_step, to_step},
        {csv, {".csv"}, "samples with u, x, y, derivatives and curvature", nullptr, write_csv}};
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
