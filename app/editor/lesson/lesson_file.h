/// Reads and writes lessons; assets/lessons/README.md describes the format.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "app/editor/fields/field.h"
#include "app/editor/lesson/lesson.h"

namespace batten::editor {

/// The lesson in `text`, checked completely but for the acts of its steps, which only running tells. The error says
/// what is wrong and where, by a JSON pointer.
Outcome<Lesson> parse_lesson(std::string_view text, const std::string& name);

/// The text that parse_lesson reads back.
std::string format_lesson(const Lesson& lesson);

Outcome<Lesson> load_lesson(const std::filesystem::path& path);
Outcome<void> save_lesson(const Lesson& lesson, const std::filesystem::path& path);

}  // namespace batten::editor
