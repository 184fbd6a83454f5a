#include "exchange/curve_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "core/base/sentence.h"

namespace batten::exchange {

namespace {

core::FileResult<Imported> read_curves(core::FileResult<std::string> text, Format format) {
    if (!text) return tl::unexpected(std::move(text.error()));
    return spec_of(format).read(*text);
}

// What is to be said where the format has no reader, or no writer.
core::FileError refusal_of(const char* pattern, Format format) {
    return {"", core::sentence(pattern, {{"format", core::title_of(format)}})};
}

core::FileError unread(Format format) {
    return refusal_of("this build of Batten does not read {format} files", format);
}

struct Sign {
    Format format;
    const char* text;  // that only such files have near their beginning
};

constexpr std::array<Sign, 4> signs{{{Format::nurbs_python, "\"knotvector\""},
                                     {Format::tinyspline, "\"dimension\""},
                                     {Format::opencascade, "\"multiplicities\""},
                                     {Format::rhino, "\"rhino\""}}};

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
    const auto* const sign =
        std::ranges::find_if(signs, [&](const Sign& each) { return text.find(each.text) != std::string::npos; });
    if (sign == signs.end() || sign->format == read) return error;
    error.what = core::sentence("{what}; it looks like a {format} file, a format that has to be chosen",
                                {{"what", error.what}, {"format", core::title_of(sign->format)}});
    return error;
}

core::FileResult<Imported> load_curves(const std::filesystem::path& path, Format format) {
    if (spec_of(format).read == nullptr) return tl::unexpected(unread(format));
    return read_curves(core::read_text(path), format).map_error([&](core::FileError error) {
        return with_advice(std::move(error), path, format);
    });
}

core::FileResult<Imported> load_curves(int descriptor, const std::string& name, Format format) {
    if (spec_of(format).read == nullptr) return tl::unexpected(unread(format));
    return read_curves(core::read_text(descriptor, name), format);
}

core::FileResult<Exported> write_curves(const core::Document& document, Format format, const WriteOptions& options) {
    const Writer write = spec_of(format).write;
    if (write == nullptr)
        return tl::unexpected(refusal_of("this build of Batten does not write {format} files", format));
    return write(document, options);
}

core::FileResult<Report> save_curves(const core::Document& document, const std::filesystem::path& path, Format format,
                                     const WriteOptions& options, const core::Progress& progress) {
    return write_curves(document, format, options).and_then([&](const Exported& exported) -> core::FileResult<Report> {
        core::tell(progress, 1, 1);
        if (auto replaced = core::replace_text(path, exported.text); !replaced)
            return tl::unexpected(std::move(replaced.error()));
        return exported.report;
    });
}

}  // namespace batten::exchange
