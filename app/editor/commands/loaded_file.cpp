#include "app/editor/commands/loaded_file.h"

#include <cmath>

#include "app/editor/state/view_forms.h"
#include "core/base/sentence.h"
#include "exchange/curve_file.h"
#include "exchange/file_advice.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

using core::sentence;

// What of a file could not be kept.
void tell_lost_fits(LoadedFile& file) {
    if (file.document.lost_fits == 0) return;
    file.remarks.push_back(
        sentence({.one = "one curve does not go through its fit points, so that it is an ordinary curve now",
                  .many = "{count} curves do not go through their fit points, so that they are ordinary curves now"},
                 file.document.lost_fits));
}

Outcome<LoadedFile> load_native(const fs::path& path, const LoadingTold& told) {
    core::FileResult<core::Document> document = core::load_document(path, told.progress, told.points_read);
    if (!document) return tl::unexpected(file_refusal(path, exchange::with_advice(document.error(), path)));
    const Outcome<ViewForms> forms = read_forms(document->view.unknown_members);
    if (!forms) return tl::unexpected(file_refusal(path, {"", forms.error()}));
    LoadedFile file{*std::move(document)};
    tell_lost_fits(file);
    return file;
}

Outcome<LoadedFile> load_foreign(const fs::path& path, exchange::Format format) {
    if (format == exchange::Format::csv)
        return tl::unexpected(file_refusal(path, {"", "a table of points is opened by File > Open table…"}));
    core::FileResult<exchange::Imported> imported = exchange::load_curves(path, format);
    if (!imported) return tl::unexpected(file_refusal(path, imported.error()));
    const exchange::Report& report = imported->report;
    std::vector<std::string> remarks = report_words(imported->document.units, report);
    const bool has_more = !report.left_out.empty() || !report.looks.empty();
    return LoadedFile{std::move(imported->document), true, std::move(remarks), has_more};
}

std::string error_words(const Units& units, const exchange::Report& report) {
    if (report.largest_error == 0.0)
        return report.left_out.empty() ? "its curves are exact" : "its curves are exact apart from what follows";
    if (!std::isfinite(report.largest_error)) return "how far its curves are off is not known";
    return sentence("its curves are off by at most {error}", {{"error", length_words(units, report.largest_error)}});
}

}  // namespace

Refusal file_refusal(const fs::path& path, const core::FileError& error) {
    return sentence("{file}: {what}", {{"file", path.filename().string()},
                                       {"what", error.where == path.string() ? error.what : error.sentence()}});
}

std::vector<std::string> report_words(const Units& units, const exchange::Report& report) {
    std::vector<std::string> words{
        report.holds_samples
            ? "it holds samples of the curves, from which points can be read again, but not the curves themselves"
            : error_words(units, report)};
    words.insert(words.end(), report.left_out.begin(), report.left_out.end());
    words.insert(words.end(), report.looks.begin(), report.looks.end());
    return words;
}

Outcome<LoadedFile> load_file(const fs::path& path, std::optional<exchange::Format> format, const LoadingTold& told) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
        return tl::unexpected(
            file_refusal(path, {path.string(), "this is not an ordinary file, so it cannot be opened"}));
    if (!format) format = exchange::format_of(path);
    return format ? load_foreign(path, *format) : load_native(path, told);
}

}  // namespace batten::editor
