#include "app/editor/lesson/recording.h"

#include "app/editor/command_spec.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/session.h"
#include "app/editor/state/same_document.h"
#include "app/editor/words/reading_text.h"

namespace batten::editor {

namespace {

std::vector<Overlay> shown_overlays(const Overlays& overlays) {
    std::vector<Overlay> shown;
    for (std::size_t i = 0; i < overlay_count; ++i)
        if (overlays.is_shown(static_cast<Overlay>(i))) shown.push_back(static_cast<Overlay>(i));
    return shown;
}

LessonView view_of(const LessonPlace& place) {
    return {.overlays = shown_overlays(place.overlays), .parameter = place.parameter, .level = place.level};
}

/// What the step changes about the view that the steps before it left.
LessonView changed_view(const LessonPlace& before, const LessonPlace& after) {
    LessonView view = view_of(after);
    if (before.overlays == after.overlays) view.overlays.reset();
    if (before.parameter == after.parameter) view.parameter.reset();
    if (before.level == after.level) view.level.reset();
    return view;
}

void merge(LessonView& view, const LessonView& later) {
    if (later.overlays) view.overlays = later.overlays;
    if (later.parameter) view.parameter = later.parameter;
    if (later.level) view.level = later.level;
}

void record_edit(EditorState& state, const Command& command, const LessonPlace& now) {
    LessonRecording& recording = *state.recording;
    std::vector<LessonStep>& steps = recording.lesson.steps;
    const std::string line = format_command(command);
    const bool extends = state.burst && state.burst->count > 1 && steps.size() > 1;
    if (!extends) steps.push_back({.text = reading_text(state.message.text)});
    steps.back().acts.push_back(line);
    if (extends) steps.back().text = reading_text(state.message.text);
    merge(steps.back().view, changed_view(recording.last, now));
    recording.undone.clear();
}

void record_act(EditorState& state, const Command& command, const LessonPlace& now) {
    LessonRecording& recording = *state.recording;
    std::vector<LessonStep>& steps = recording.lesson.steps;
    if (!has_same_content(now.document, recording.last.document)) {
        steps.push_back({.text = now.document.title.empty() ? command.spec().title : now.document.title,
                         .document = now.document,
                         .view = view_of(now)});
        recording.undone.clear();
    } else if (now.overlays != recording.last.overlays) {
        steps.push_back({.text = command.spec().explanation, .view = changed_view(recording.last, now)});
    } else {
        merge(steps.back().view, changed_view(recording.last, now));
    }
}

/// The step that undo takes back: the last edit, whatever was shown since then. Never the first step.
std::size_t undone_step(const std::vector<LessonStep>& steps) {
    std::size_t k = steps.size() - 1;
    while (k > 0 && steps[k].acts.empty() && !steps[k].document) --k;
    return steps[k].acts.empty() ? 0 : k;
}

/// False where there is no such step.
bool take_back(LessonRecording& recording) {
    std::vector<LessonStep>& steps = recording.lesson.steps;
    const std::size_t k = undone_step(steps);
    if (k == 0) return false;
    // What it showed stays.
    merge(steps[k - 1].view, steps[k].view);
    recording.undone.push_back(std::move(steps[k]));
    steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
}

void record_done(EditorState& state, const Command& command, const LessonPlace& now) {
    LessonRecording& recording = *state.recording;
    if (command.as<Redo>() != nullptr && !recording.undone.empty()) {
        recording.lesson.steps.push_back(std::move(recording.undone.back()));
        recording.undone.pop_back();
    } else if (command.spec().run.edit != nullptr) {
        if (!has_same_content(now.document, recording.last.document)) record_edit(state, command, now);
    } else {
        record_act(state, command, now);
    }
}

// The sentence of the document says what the whole lesson is about.
std::string first_text(const core::Document& document) {
    return document.title.empty() ? "This is what it begins with." : document.title;
}

}  // namespace

void begin_recording(EditorState& state, const std::string& title) {
    const LessonPlace now = place_of(state);
    Lesson lesson;
    lesson.title = title;
    lesson.text = now.document.description;
    if (state.view.notation != Notation{}) lesson.notation = state.view.notation;
    lesson.document = now.document;
    lesson.view = view_of(now);
    lesson.steps.push_back({.text = first_text(now.document)});
    state.recording = LessonRecording{.lesson = std::move(lesson), .last = now};
}

void record(EditorState& state, const Command& command) {
    if (!state.recording) return;
    LessonRecording& recording = *state.recording;
    const LessonPlace now = place_of(state);
    const bool is_changed = !has_same_content(now.document, recording.last.document);
    const bool is_taken_back = command.as<Undo>() != nullptr && is_changed && take_back(recording);
    if (!is_taken_back) record_done(state, command, now);
    recording.last = now;
}

void describe_step(EditorState& state, const std::string& text) {
    state.recording->lesson.steps.back().text = text;
}

Lesson recorded_lesson(const EditorState& state) {
    return state.recording->lesson;
}

}  // namespace batten::editor
