// What is typed in the palette.

#include "app/editor/typed_command.h"

#include "app/editor/session.h"
#include "tests/fuzz/sample_state.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const editor::Editor editor = sample_editor();
    const auto command = editor::parse_typed_command(std::string(bytes), editor.state());
    if (!command) return require(!command.error().empty(), "a refusal says why");
    const std::string line = editor::format_command(*command);
    require(editor::parse_command(line, editor.state()).has_value(), "what was typed can be logged");
}

}  // namespace batten::fuzz
