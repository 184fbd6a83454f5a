#include "app/cli/input.h"

#include <ostream>

#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/editor/words/unknown_curve.h"
#include "core/base/sentence.h"
#include "exchange/curve_file.h"
#include "exchange/file_advice.h"

namespace batten::cli {

void say_error(Output output, const std::filesystem::path& file, const std::string& where, const std::string& what) {
    say(output, core::sentence("{file}: {problem}",
                               {{"file", shown_name(file)}, {"problem", core::FileError{where, what}.sentence()}}));
}

void say_error(Output output, const std::filesystem::path& file, const core::FileError& error) {
    say_error(output, file, error.where == shown_name(file) ? "" : error.where, error.what);
}

std::optional<exchange::Format> format_meant(const std::filesystem::path& file, std::optional<FileKind> kind) {
    if (!kind) return exchange::format_of(file);
    const auto* const format = std::get_if<exchange::Format>(&*kind);
    return format == nullptr ? std::nullopt : std::optional(*format);
}

core::FileResult<exchange::Imported> read_curves(const std::filesystem::path& file, std::optional<FileKind> kind) {
    const std::optional<exchange::Format> format = format_meant(file, kind);
    if (format == exchange::Format::csv)
        return tl::unexpected(core::FileError{
            "",
            core::sentence("a table holds points, of which 'batten new interpolate @{file}' or 'batten new polyline "
                           "@{file}' makes a curve",
                           {{"file", shown_name(file)}})});
    if (format)
        return is_standard(file) ? exchange::load_curves(standard_input, shown_name(file), *format)
                                 : exchange::load_curves(file, *format);
    core::FileResult<core::Document> document = is_standard(file)
                                                    ? core::load_document(standard_input, shown_name(file))
                                                    : core::load_document(file).map_error([&](core::FileError error) {
                                                          return exchange::with_advice(std::move(error), file);
                                                      });
    return std::move(document).map([](core::Document read) { return exchange::Imported{std::move(read)}; });
}

core::FileResult<core::Document> read_document(Output output, const std::filesystem::path& file) {
    return read_curves(file).map([&](exchange::Imported read) {
        for (const std::string& left_out : read.report.left_out) say_error(output, file, "", left_out);
        return std::move(read.document);
    });
}

std::optional<core::Document> load(Output output, const std::filesystem::path& file) {
    core::FileResult<core::Document> document = read_document(output, file);
    if (document) return *std::move(document);
    say_error(output, file, document.error());
    return std::nullopt;
}

std::optional<std::size_t> find_curve(Output output, const std::filesystem::path& file, const core::Document& document,
                                      const std::string& name) {
    if (document.curves.empty()) {
        say_error(output, file, "curves", "there is none; at least one is needed");
        return std::nullopt;
    }
    if (name.empty()) return document.active;
    if (const auto index = core::curve_meant_by(document, name)) return index;
    say_error(output, file, "curves", editor::unknown_curve(document, name));
    return std::nullopt;
}

}  // namespace batten::cli
