/// The checks of lessons in JSON: {"check": "multiplicity", "knot": 0.5, "is": 3}.
#pragma once

#include "app/editor/lesson/check.h"
#include "app/editor/lesson/json_members.h"

namespace batten::editor {

/// The check that `json` describes; errors name its place by `pointer`.
Outcome<LessonCheck> read_check(const LessonJson& json, const std::string& pointer);

LessonJson json_of(const LessonCheck& check);

/// What a check is called.
const char* name_of(const LessonCheck& check);

}  // namespace batten::editor
