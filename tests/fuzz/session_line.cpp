// A line of a log is a command, which is written and read again to the same line.

#include "app/editor/session.h"
#include "tests/fuzz/sample_state.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const editor::Editor editor = sample_editor();
    const auto command = editor::parse_command(std::string(bytes), editor.state());
    if (!command) return require(!command.error().empty(), "a refusal says why");
    const std::string line = editor::format_command(*command);
    const auto again = editor::parse_command(line, editor.state());
    require(again.has_value(), "what was written can be read");
    require(editor::format_command(*again) == line, "what was read again is the same");
}

}  // namespace batten::fuzz
