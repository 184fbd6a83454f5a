/// Makes a lesson from what is done in the editor.
#pragma once

#include "app/editor/state/state.h"

namespace batten::editor {

/// Begins a recording with what stands now: the description of the document tells what the lesson is about, and the
/// first step has its title, or says that it is the first.
void begin_recording(EditorState& state, const std::string& title);

/// Adds what the committed `command` has done to the recording, if there is one: an edit is a step that does it again;
/// other curves are a step with their document; other overlays a step that shows them; another parameter belongs to the
/// last step. What is undone is no step any more, whatever was shown since then.
void record(EditorState& state, const Command& command);

/// Gives the last step of the recording, which there is, its text.
void describe_step(EditorState& state, const std::string& text);

/// The recorded lesson; its first step shows what it began with.
Lesson recorded_lesson(const EditorState& state);

}  // namespace batten::editor
