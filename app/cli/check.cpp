#include <ostream>

#include "app/cli/finding_output.h"
#include "app/cli/input.h"
#include "app/cli/json_output.h"
#include "app/cli/standard_streams.h"
#include "app/editor/commands/joint_rows.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

std::string verdict(const std::filesystem::path& file, const core::Document& document) {
    return core::sentence({.one = "{file}: valid, 1 curve", .many = "{file}: valid, {count} curves"},
                          document.curves.size(), {{"file", shown_name(file)}});
}

std::vector<core::Joint> joints_in(const core::Document& document, const CheckOptions& options) {
    return editor::joints_of_document(document, options.within.value_or(editor::usual_joint_tolerance(document)));
}

void say_joints(Output output, const core::Document& document, const CheckOptions& options) {
    const std::vector<core::Joint> joints = joints_in(document, options);
    output.results << editor::joints_summary(joints) << '\n';
    for (const core::Joint& joint : joints) print(output.results, editor::joint_row(document, joint));
}

Json json_of_joint(const core::Document& document, const core::Joint& joint) {
    Json result = json_of(editor::joint_row(document, joint));
    result["curves"] = {document.curves[joint.first.curve].name, document.curves[joint.second.curve].name};
    result["parameters"] = {joint.first.u, joint.second.u};
    result["at_ends"] = joint.first.is_end;
    return result;
}

Json json_of_file(const std::filesystem::path& file, const core::FileResult<core::Document>& document,
                  const CheckOptions& options) {
    Json result{{"file", file.string()}, {"valid", document.has_value()}};
    if (document && options.joints) {
        Json joints = Json::array();
        for (const core::Joint& joint : joints_in(*document, options))
            joints.push_back(json_of_joint(*document, joint));
        result["joints"] = std::move(joints);
    }
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
        const core::FileResult<core::Document> document = read_document(output, file);
        if (!document) {
            status = ExitStatus::wrong_input;
            say_error(output, file, document.error());
        } else if (!options.as_json) {
            output.results << verdict(file, *document) << '\n';
            if (options.joints) say_joints(output, *document, options);
        }
        if (options.as_json) results.push_back(json_of_file(file, document, options));
    }
    if (options.as_json) print(output.results, results);
    return status;
}

}  // namespace batten::cli
