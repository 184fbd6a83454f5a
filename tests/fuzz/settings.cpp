// Settings come from whatever there is, and are kept as they were read.

#include "app/editor/state/settings.h"

#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const editor::Settings settings = editor::parse_settings(std::string(bytes));
    require(editor::parse_settings(editor::format_settings(settings)) == settings, "settings come back");
}

}  // namespace batten::fuzz
