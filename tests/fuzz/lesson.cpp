// What can be read is written and read again to the same text.

#include "app/editor/lesson/lesson_file.h"
#include "tests/fuzz/target.h"

namespace batten::fuzz {

void run(std::string_view bytes) {
    const auto lesson = editor::parse_lesson(bytes, "lesson");
    if (!lesson) return require(!lesson.error().empty(), "a refusal says why");
    const std::string text = editor::format_lesson(*lesson);
    const auto again = editor::parse_lesson(text, "lesson");
    require(again.has_value(), "what was written can be read");
    require(editor::format_lesson(*again) == text, "what was read again is the same");
}

}  // namespace batten::fuzz
