/// Going through a lesson.
#pragma once

#include "app/editor/state/state.h"

namespace batten::editor {

/// Opens the lesson called `name` in the folder of lessons, or in the file of that path, at its first step.
Outcome<void> open_lesson(EditorState& state, const std::string& name);

/// Begins `lesson`, which has steps, at its first one. Errors: what an act of that step is refused for.
Outcome<void> begin_lesson(EditorState& state, std::shared_ptr<const Lesson> lesson);

/// Goes on with the next step of the lesson, which there is, from what stands now. Errors: what an act of the step is
/// refused for; the step is begun all the same.
Outcome<void> begin_next_step(EditorState& state);

/// Does the task of the present step as the lesson does it. Errors: what an act is refused for.
Outcome<void> do_task(EditorState& state);

/// Goes back to the step before, which there is, as it began.
void go_back_a_step(EditorState& state);

/// Ends the lesson: its document stays with its history, and the overlays, the notation and the level are again as they
/// were before it was opened.
void close_lesson(EditorState& state);

}  // namespace batten::editor
