#include "exchange/file_advice.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/sentence.h"

namespace batten::exchange {

namespace {

struct FormatSign {
    Format format;
    std::string_view text;  // that only such files have near their beginning
};

constexpr std::array<FormatSign, 7> format_signs{{{Format::nurbs_python, "\"knotvector\""},
                                                  {Format::tinyspline, "\"dimension\""},
                                                  {Format::opencascade, "\"multiplicities\""},
                                                  {Format::rhino, "\"rhino\""},
                                                  {Format::svg, "<svg"},
                                                  {Format::step, "ISO-10303-21"},
                                                  {Format::dxf, "\nSECTION"}}};

struct ForeignSign {
    std::string_view beginning;
    const char* advice;                            // in which {what} is why it is not read
    std::optional<Format> told_by = std::nullopt;  // whose reader says so itself
};

constexpr std::array<ForeignSign, 9> foreign_signs{{
    {"\x1f\x8b", "{what}; it is compressed, and can be read when it is unpacked, or saved as plain SVG"},
    {"%PDF", "{what}; it looks like a PDF file, which programs that draw, such as Inkscape, can write as SVG"},
    {"%!PS", "{what}; it looks like a PostScript file, which programs that draw, such as Inkscape, can write as SVG"},
    {"\x89PNG", "{what}; it looks like a picture, which can be added below the curves and traced (add-picture)"},
    {"\xff\xd8\xff", "{what}; it looks like a picture, which can be added below the curves and traced (add-picture)"},
    {"AC10", "{what}; it looks like a DWG file, which programs that made it can write as DXF", Format::dxf},
    {"AutoCAD Binary DXF", "{what}; it looks like a binary DXF file, which programs that made it can write as text",
     Format::dxf},
    {"3D Geometry File Format", "{what}; it looks like a file of Rhino, which can write it as STEP, IGES or DXF"},
    {"PK\x03\x04", "{what}; it looks like a compressed folder, whose files can be read when it is unpacked"},
}};

std::string beginning_of(const std::filesystem::path& path) {
    constexpr std::streamsize enough = 4096;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return {};
    std::string text(enough, ' ');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), enough);
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

}  // namespace

core::FileError with_advice(core::FileError error, const std::filesystem::path& path, std::optional<Format> read) {
    const std::string text = beginning_of(path);
    if (text.find("\"batten\"") != std::string::npos) return error;
    const auto* const foreign =
        std::ranges::find_if(foreign_signs, [&](const ForeignSign& each) { return text.starts_with(each.beginning); });
    if (foreign != foreign_signs.end()) {
        if (read && foreign->told_by == read) return error;
        error.what = core::sentence(foreign->advice, {{"what", error.what}});
        return error;
    }
    const auto* const sign = std::ranges::find_if(
        format_signs, [&](const FormatSign& each) { return text.find(each.text) != std::string::npos; });
    if (sign == format_signs.end() || sign->format == read) return error;
    error.what = core::sentence("{what}; it looks like a file in the format {format}, which has to be chosen",
                                {{"what", error.what}, {"format", core::title_of(sign->format)}});
    return error;
}

}  // namespace batten::exchange
