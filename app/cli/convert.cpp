#include <ostream>

#include "app/cli/input.h"
#include "app/cli/json_output.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/editor/commands/loaded_file.h"
#include "app/editor/words/native_name.h"
#include "core/base/sentence.h"
#include "exchange/curve_file.h"

namespace batten::cli {

namespace {

Json json_of_report(const std::filesystem::path& file, const exchange::Report& report) {
    return {{"file", shown_name(file)},
            {"largest_error", report.holds_samples ? Json(nullptr) : json_of(report.largest_error)},
            {"left_out", report.left_out},
            {"looks", report.looks}};
}

void print_report(std::ostream& out, const core::Document& document, const std::string& file,
                  const exchange::Report& report) {
    for (const std::string& told : editor::report_words(document.units, report))
        out << core::sentence("{file}: {told}", {{"file", file}, {"told", told}}) << '\n';
}

core::FileResult<exchange::Exported> text_of(const core::Document& document, const ConvertOptions& options) {
    const auto format = format_meant(options.result, options.to);
    if (format) return exchange::write_curves(document, *format, options.write);
    return exchange::Exported{core::format_document(document)};
}

core::FileResult<void> write(const ConvertOptions& options, const std::string& text, Output output) {
    if (!is_standard(options.result)) return core::replace_text(options.result, text);
    output.results << text;
    return {};
}

}  // namespace

ExitStatus convert(const ConvertOptions& options, Output output) {
    if (const auto refusal = options.to ? std::nullopt : editor::foreign_result(options.result))
        return say_wrong_usage(output, core::sentence("batten convert: {refusal}", {{"refusal", *refusal}}));
    const core::FileResult<exchange::Imported> read = read_curves(options.file, options.from);
    if (!read) {
        say_error(output, options.file, read.error());
        return ExitStatus::wrong_input;
    }
    const core::FileResult<exchange::Exported> written = text_of(read->document, options);
    const core::FileResult<void> saved =
        written.and_then([&](const exchange::Exported& exported) { return write(options, exported.text, output); });
    if (!saved) {
        say_error(output, result_name(options.result), saved.error());
        return ExitStatus::wrong_input;
    }
    std::ostream& told = is_standard(options.result) ? output.errors : output.results;
    if (options.as_json) {
        print(told, Json::array({json_of_report(shown_name(options.file), read->report),
                                 json_of_report(result_name(options.result), written->report)}));
    } else {
        print_report(told, read->document, shown_name(options.file), read->report);
        print_report(told, read->document, result_name(options.result), written->report);
    }
    return ExitStatus::done;
}

}  // namespace batten::cli
