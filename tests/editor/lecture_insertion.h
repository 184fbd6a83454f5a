/// The knot insertion of the lecture: u = 1/2 gives alpha = 5/6, 1/2, 1/6.
#pragma once

#include "app/editor/commands/construction_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor::test {

inline const char* lecture_insertion_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "lecture", "degree": 3, "knots": [0,0,0,0,0.2,0.4,0.6,0.8,1,1,1,1],
    "points": [[0,0],[0,6],[6,6],[6,0],[12,0],[12,6],[18,6],[18,0]] } ] })";

/// An editor with it at u = 1/2.
inline void open_lecture_insertion(Editor& editor) {
    open_text(editor, lecture_insertion_text);
    ASSERT_TRUE(editor.run(SetParameter{.u = 0.5}));
}

}  // namespace batten::editor::test
