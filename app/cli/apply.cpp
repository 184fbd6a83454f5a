#include <ostream>
#include <sstream>
#include <utility>

#include "app/cli/finding_output.h"
#include "app/cli/input.h"
#include "app/cli/json_output.h"
#include "app/cli/operation.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/cli/table_argument.h"
#include "app/editor/command_reader.h"
#include "app/editor/commands/loaded_file.h"
#include "app/editor/editor.h"
#include "app/editor/words/native_name.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "exchange/curve_file.h"

namespace batten::cli {

namespace {

std::string message_of(const editor::EditorState& state, const editor::CommandSpec& spec) {
    const std::string& text = state.message.text;
    const bool is_unchanged = text.empty() || text == editor::nothing_changed_sentence();
    return is_unchanged && spec.run.edit != nullptr ? "nothing had to be changed" : text;
}

// Adds an argument to a list, as it stands in a log.
struct AddTo {
    Json& list;

    void operator()(std::monostate) const { list.push_back(nullptr); }
    void operator()(const editor::Word& word) const { list.push_back(word.text); }
    template <class Value>
    void operator()(const Value& value) const {
        list.push_back(value);
    }
};

// What is printed about an operation that has just run.
Json json_of_operation(const editor::Editor& editor, const Operation& operation) {
    const editor::EditorState& state = editor.state();
    const editor::CommandSpec& spec = *operation.spec;
    Json arguments = Json::array();
    for (const editor::Argument& argument : editor::arguments_of(editor.log().back()))
        std::visit(AddTo{arguments}, argument);
    Json result{{"operation", spec.name},
                {"arguments", std::move(arguments)},
                {"message", message_of(state, spec)},
                {"effect", core::name_of(spec.effect)}};
    if (spec.run.edit != nullptr && state.ghost) result["deviation"] = json_of(state.ghost->deviation);
    if (spec.group != editor::CommandGroup::analyze || !state.findings) return result;
    result["findings"] = Json::array();
    for (const editor::Finding& finding : state.findings->rows) result["findings"].push_back(json_of(finding));
    return result;
}

void print_operation(std::ostream& out, const editor::EditorState& state, const Operation& operation) {
    const editor::CommandSpec& spec = *operation.spec;
    const std::string message = message_of(state, spec);
    out << printable(operation.text) << (message.empty() ? "" : ": ") << message << '\n';
    if (spec.group != editor::CommandGroup::analyze || !state.findings) return;
    for (const editor::Finding& finding : state.findings->rows) print(out, finding);
}

ExitStatus say_wrong_words(Output output, const ApplyOptions& options, const editor::Refusal& refusal) {
    return say_wrong_usage(output,
                           core::sentence("batten {subcommand}: {refusal}",
                                          {{"subcommand", options.file ? "apply" : "new"}, {"refusal", refusal}}));
}

std::string place_of(std::size_t index, const Operation& operation) {
    return core::sentence("operation {number}, {text}", {{"number", index + 1}, {"text", operation.text}});
}

// Why the operation could not be run, if it could not.
std::optional<editor::Refusal> run(editor::Editor& editor, Operation& operation, Output output) {
    const auto told = read_tables(operation, editor.state().history.present().units);
    if (!told) return told.error();
    for (const std::string& sentence : *told) say(output, sentence);
    const auto command = editor::read_command(*operation.spec, editor.state(), operation.arguments);
    if (!command) return command.error();
    if (!editor.run(*command)) return editor.state().message.text;
    return std::nullopt;
}

// How refusals name what the operations work on.
std::filesystem::path name_of_input(const ApplyOptions& options) {
    return options.file.value_or("new document");
}

// Whether the operation reads standard input although that is read already; notes in `is_read` where it reads it.
bool reads_input_again(const Operation& operation, bool& is_read) {
    for (const std::string& word : table_words(operation))
        if (names_standard_input(word) && std::exchange(is_read, true)) return true;
    return false;
}

// Runs the operations; says which one was refused and why.
ExitStatus run(editor::Editor& editor, const ApplyOptions& options, Output output) {
    Json results = Json::array();
    OperationReader reader(options.operations);
    bool is_input_read = options.file && is_standard(*options.file);
    for (std::size_t i = 0; !reader.is_at_end(); ++i) {
        editor::Outcome<Operation> operation = reader.take(editor.state().history.present());
        if (!operation) return say_wrong_words(output, options, operation.error());
        if (reads_input_again(*operation, is_input_read))
            return say_wrong_words(output, options, "standard input, -, can be read only once");
        if (const auto refusal = run(editor, *operation, output)) {
            say_error(output, name_of_input(options), place_of(i, *operation), *refusal);
            return ExitStatus::wrong_input;
        }
        if (options.as_json) {
            results.push_back(json_of_operation(editor, *operation));
        } else {
            print_operation(output.results, editor.state(), *operation);
        }
    }
    if (options.as_json) print(output.results, results);
    return ExitStatus::done;
}

// The document to begin with; none after saying why not.
std::optional<core::Document> first_document(const ApplyOptions& options, Output output) {
    if (!options.file) return core::Document{};
    std::optional<core::Document> document = load(output, *options.file);
    if (!document || options.curve.empty()) return document;
    const std::optional<std::size_t> index = find_curve(output, *options.file, *document, options.curve);
    if (!index) return std::nullopt;
    document->active = *index;
    return document;
}

ExitStatus save(const core::Document& document, const std::filesystem::path& file, Output output) {
    if (is_standard(file)) {
        output.results << core::format_document(document);
        return ExitStatus::done;
    }
    const auto format = exchange::format_of(file);
    const core::FileResult<exchange::Report> saved =
        format ? exchange::save_curves(document, file, *format)
               : core::save_document(document, file).map([](const auto&) { return exchange::Report{}; });
    if (!saved) {
        say_error(output, file, saved.error());
        return ExitStatus::wrong_input;
    }
    if (format)
        for (const std::string& told : editor::report_words(document.units, *saved)) say_error(output, file, "", told);
    return ExitStatus::done;
}

}  // namespace

ExitStatus apply(const ApplyOptions& options, Output output) {
    if (const auto refusal = editor::foreign_result(options.result)) return say_wrong_words(output, options, *refusal);
    std::optional<core::Document> document = first_document(options, output);
    if (!document) return ExitStatus::wrong_input;
    editor::Editor editor(*std::move(document));
    // Where the command line is wrong nothing is printed, however far it was right.
    std::ostringstream found;
    const ExitStatus status = run(editor, options, {found, output.errors});
    if (status != ExitStatus::wrong_usage)
        (is_standard(options.result) ? output.errors : output.results) << found.view();
    if (status != ExitStatus::done || options.result.empty()) return status;
    return save(editor.state().history.present(), options.result, output);
}

}  // namespace batten::cli
