// Operations of the command line, one word a line, on a document. Nothing else is read: words that name files are left
// out.

#include <algorithm>
#include <vector>

#include "app/cli/operation.h"
#include "app/cli/table_argument.h"
#include "app/editor/command_reader.h"
#include "app/editor/editor.h"
#include "tests/fuzz/sample_state.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

namespace {

constexpr std::size_t most_words = 40;

std::vector<std::string> words_of(std::string_view bytes) {
    std::vector<std::string> words;
    while (!bytes.empty() && words.size() < most_words) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        std::string word(bytes.substr(0, end));
        word.erase(std::remove(word.begin(), word.end(), '\0'), word.end());
        if (!cli::names_table(word)) words.push_back(std::move(word));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    return words;
}

bool names_a_file(const editor::CommandSpec& spec) {
    return std::any_of(spec.fields.begin(), spec.fields.end(),
                       [](const editor::Field& field) { return field.kind == editor::FieldKind::file; });
}

// A curve of so many points that what is tried next would take long is no use here.
bool is_small(const core::Document& document) {
    std::size_t points = 0;
    for (const core::DocumentCurve& entry : document.curves) points += entry.curve->control_points().size();
    return points < 300 && document.curves.size() < 30;
}

}  // namespace

void run(std::string_view bytes) {
    const std::vector<std::string> words = words_of(bytes);
    editor::Editor editor = sample_editor();
    cli::OperationReader reader(words);
    while (!reader.is_at_end() && is_small(editor.state().history.present())) {
        const auto operation = reader.take(editor.state().history.present());
        if (!operation) return require(!operation.error().empty(), "a refusal says why");
        if (names_a_file(*operation->spec)) return;
        require(cli::table_words(*operation).empty(), "words that name files are left out");
        const auto command = editor::read_command(*operation->spec, editor.state(), operation->arguments);
        if (!command) return require(!command.error().empty(), "a refusal says why");
        if (!editor.run(*command)) return require(!editor.state().message.text.empty(), "a refusal says why");
        require_sound(editor.state().history.present());
    }
}

}  // namespace batten::fuzz
