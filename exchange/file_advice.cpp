#include "exchange/file_advice.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "core/base/ascii.h"
#include "core/base/sentence.h"
#include "exchange/json/json_dialects_reader.h"

namespace batten::exchange {

namespace {

using namespace std::string_view_literals;

struct FormatSign {
    Format format;
    std::string_view text;          // that only such files have near their beginning
    std::string_view other_text{};  // that stands there, too
};

constexpr std::array<FormatSign, 6> json_signs{{{Format::nurbs_python, "\"knotvector\""},
                                                {Format::nurbs_python, "\"shape\"", "\"control_points\""},
                                                {Format::opencascade, "\"multiplicities\""},
                                                {Format::opencascade, "\"poles\""},
                                                {Format::tinyspline, "\"control_points\""},
                                                {Format::rhino, "\"rhino\""}}};

constexpr std::array<FormatSign, 3> other_signs{
    {{Format::svg, "<svg"}, {Format::step, "ISO-10303-21"}, {Format::dxf, "\nSECTION"}}};

struct ForeignSign {
    std::string_view beginning;
    const char* advice;                            // in which {what} is why it is not read
    std::optional<Format> told_by = std::nullopt;  // whose reader says so itself
    std::string_view content{};                    // that stands behind the beginning
};

constexpr const char* font_advice = "{what}; it looks like a font, of whose letters 'text-outlines' makes curves";

// Of fonts, TrueType and OpenType, collections of them, those of web pages, and Type 1. Of spreadsheets, .xlsx and
// .ods.
constexpr std::array<ForeignSign, 20> foreign_signs{{
    {"\0\1\0\0"sv, font_advice},
    {"true\0"sv, font_advice},
    {"OTTO\0"sv, font_advice},
    {"ttcf\0"sv, font_advice},
    {"wOFF", font_advice},
    {"wOF2", font_advice},
    {"\x80\x01", font_advice},
    {"%!PS-AdobeFont", font_advice},
    {"%!FontType1", font_advice},
    {"\x1f\x8b", "{what}; it is compressed, and can be read when it is unpacked, or saved as plain SVG"},
    {"%PDF", "{what}; it looks like a PDF file, which programs that draw, such as Inkscape, can write as SVG"},
    {"%!PS", "{what}; it looks like a PostScript file, which programs that draw, such as Inkscape, can write as SVG"},
    {"\x89PNG", "{what}; it looks like a picture, which can be added below the curves and traced (add-picture)"},
    {"\xff\xd8\xff", "{what}; it looks like a picture, which can be added below the curves and traced (add-picture)"},
    {"AC10", "{what}; it looks like a DWG file, which programs that made it can write as DXF", Format::dxf},
    {"AutoCAD Binary DXF", "{what}; it looks like a binary DXF file, which programs that made it can write as text",
     Format::dxf},
    {"3D Geometry File Format", "{what}; it looks like a file of Rhino, which can write it as STEP, IGES or DXF"},
    {"PK\x03\x04", "{what}; it looks like a spreadsheet, which has to be saved as CSV", std::nullopt, "xl/"},
    {"PK\x03\x04", "{what}; it looks like a spreadsheet, which has to be saved as CSV", std::nullopt,
     "opendocument.spreadsheet"},
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

bool is_json(std::string_view beginning) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (beginning.starts_with(byte_order_mark)) beginning.remove_prefix(byte_order_mark.size());
    const std::string_view text = core::trimmed(beginning);
    return text.starts_with('{') || text.starts_with('[');
}

bool is_native(std::string_view beginning) {
    return is_json(beginning) && beginning.find("\"format\"") != std::string_view::npos &&
           beginning.find("\"batten\"") != std::string_view::npos;
}

// Whether the file, which is not too large to be tried, has the knots of Rhino-style: its members have the names of
// others, too.
bool is_rhino_style(const std::filesystem::path& path, std::string_view beginning) {
    constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 22U;
    std::error_code error;
    if (beginning.find("\"knots\"") == std::string_view::npos) return false;
    if (const auto size = std::filesystem::file_size(path, error); error || size > most_bytes) return false;
    return core::read_text(path).and_then(read_rhino).has_value();
}

std::optional<Format> format_with_sign(std::span<const FormatSign> signs, std::string_view beginning) {
    const auto sign = std::ranges::find_if(signs, [&](const FormatSign& each) {
        return beginning.find(each.text) != std::string_view::npos &&
               beginning.find(each.other_text) != std::string_view::npos;
    });
    return sign == signs.end() ? std::nullopt : std::optional(sign->format);
}

std::optional<Format> format_that_fits(const std::filesystem::path& path, std::string_view beginning) {
    if (!is_json(beginning)) return format_with_sign(other_signs, beginning);
    if (const auto format = format_with_sign(json_signs, beginning)) return format;
    return is_rhino_style(path, beginning) ? std::optional(Format::rhino) : std::nullopt;
}

core::FileError advised(const char* advice, core::FileError error) {
    error.what = core::sentence(advice, {{"what", error.what}});
    return error;
}

}  // namespace

core::FileError with_advice(core::FileError error, const std::filesystem::path& path, std::optional<Format> read) {
    const std::string text = beginning_of(path);
    if (is_native(text)) {
        if (!read) return error;
        return advised(
            "{what}; it looks like a file of Batten itself: choose no format, and let its name end in .json alone",
            std::move(error));
    }
    const auto* const foreign = std::ranges::find_if(foreign_signs, [&](const ForeignSign& each) {
        return text.starts_with(each.beginning) && text.find(each.content) != std::string::npos;
    });
    if (foreign != foreign_signs.end())
        return read && foreign->told_by == read ? error : advised(foreign->advice, std::move(error));
    const std::optional<Format> format = format_that_fits(path, text);
    if (!format || format == read) return error;
    error.what = core::sentence("{what}; it looks like a file in the format {format}, which has to be chosen",
                                {{"what", error.what}, {"format", core::title_of(*format)}});
    return error;
}

}  // namespace batten::exchange
