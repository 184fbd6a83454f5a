#include "app/editor/typed_command.h"

#include "app/editor/command_reader.h"
#include "app/editor/command_table.h"
#include "app/editor/commands/knot_question_commands.h"
#include "app/editor/fields/expression.h"
#include "app/editor/words/knot_text.h"

namespace batten::editor {

namespace {

constexpr const char* blanks_between_words = " \t\r\n";

// Takes the next word off the front of `rest`, which begins with it; in quotation marks it is a text.
Outcome<Argument> take_word(std::string_view& rest) {
    const bool is_quoted = rest.front() == '"';
    if (is_quoted) rest.remove_prefix(1);
    const std::size_t end =
        is_quoted ? rest.find('"') : std::min(find_outside_parentheses(rest, blanks_between_words), rest.size());
    if (end == std::string_view::npos) return tl::unexpected(Refusal("a quotation mark \" is not closed"));
    std::string text(rest.substr(0, end));
    rest.remove_prefix(end + (is_quoted ? 1 : 0));
    return is_quoted ? Argument(std::move(text)) : Argument(Word{std::move(text)});
}

void skip_blanks(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks_between_words), rest.size()));
}

}  // namespace

Outcome<Command> parse_typed_command(const std::string& typed, const EditorState& state) {
    std::string_view rest = typed;
    skip_blanks(rest);
    if (rest.empty()) return tl::unexpected(Refusal("nothing was typed; a command is needed, like insert-knot 0.5"));
    if (is_typed_vector(typed)) return Command(SampleCurve{.knots = typed, .degree = std::nullopt, .periodic = false});
    const std::size_t name_end = std::min(rest.find_first_of(blanks_between_words), rest.size());
    const Outcome<const CommandSpec*> spec = command_named(rest.substr(0, name_end));
    if (!spec) return tl::unexpected(spec.error());
    rest.remove_prefix(name_end);
    std::vector<Argument> arguments;
    for (skip_blanks(rest); !rest.empty(); skip_blanks(rest)) {
        Outcome<Argument> word = take_word(rest);
        if (!word) return tl::unexpected(word.error());
        if (const auto* plain = std::get_if<Word>(&*word))
            for (Argument& argument : arguments_of_word(**spec, arguments.size(), plain->text))
                arguments.push_back(std::move(argument));
        else
            arguments.push_back(*std::move(word));
    }
    return read_command(**spec, state, arguments);
}

}  // namespace batten::editor
