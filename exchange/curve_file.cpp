#include "exchange/curve_file.h"

#include "core/base/sentence.h"
#include "exchange/file_advice.h"

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

}  // namespace

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
