#include <ostream>

#include "app/cli/input.h"
#include "app/cli/json_output.h"
#include "app/cli/standard_streams.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

std::string verdict(const std::filesystem::path& file, const core::Document& document) {
    return core::sentence({.one = "{file}: valid, 1 curve", .many = "{file}: valid, {count} curves"},
                          document.curves.size(), {{"file", shown_name(file)}});
}

Json json_of(const std::filesystem::path& file, const core::FileResult<core::Document>& document) {
    Json result{{"file", file.string()}, {"valid", document.has_value()}};
    if (document) return result;
    result["where"] = document.error().where;
    result["what"] = document.error().what;
    return result;
}

}  // namespace

ExitStatus check(const CheckOptions& options, Output output) {
    ExitStatus status = ExitStatus::done;
    Json results = Json::array();
    for (const std::filesystem::path& file : options.files) {
        const core::FileResult<core::Document> document = read_document(file);
        if (!document) {
            status = ExitStatus::wrong_input;
            say_error(output, file, document.error());
        } else if (!options.as_json) {
            output.results << verdict(file, *document) << '\n';
        }
        if (options.as_json) results.push_back(json_of(file, document));
    }
    if (options.as_json) print(output.results, results);
    return status;
}

}  // namespace batten::cli
