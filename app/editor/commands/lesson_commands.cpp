#include "app/editor/commands/lesson_commands.h"

#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/lesson/lesson_file.h"
#include "app/editor/lesson/lesson_steps.h"
#include "app/editor/lesson/recording.h"
#include "app/editor/words/native_name.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr const char* lesson_menu = "Lessons";

// What a student has done in a lesson ends with it.
Outcome<void> open_one(EditorState& state, const OpenLesson& command) {
    return state.lesson ? proceed(state, command) : ask_or_proceed(state, command);
}

Outcome<void> go_on(EditorState& state, const NextStep&) {
    return begin_next_step(state);
}

Outcome<void> go_back(EditorState& state, const PreviousStep&) {
    go_back_a_step(state);
    return {};
}

Outcome<void> solve(EditorState& state, const SolveTask&) {
    return do_task(state);
}

Outcome<void> close(EditorState& state, const CloseLesson&) {
    close_lesson(state);
    return {};
}

Outcome<void> begin(EditorState& state, const RecordLesson& command) {
    begin_recording(state, command.title);
    state.message = {"Recording a lesson: what is done now becomes its steps", false};
    return {};
}

Outcome<void> describe(EditorState& state, const DescribeStep& command) {
    describe_step(state, command.text);
    state.message = {
        core::sentence("Step {step} of the lesson has its text now", {{"step", state.recording->lesson.steps.size()}}),
        false};
    return {};
}

Outcome<void> save(EditorState& state, const SaveLesson& command) {
    return native_path(command.path).and_then([&](const std::filesystem::path& path) -> Outcome<void> {
        Outcome<void> saved = save_lesson(recorded_lesson(state), absolute_path(path));
        if (!saved) return saved;
        state.message = {core::sentence({.one = "Saved {file}, a lesson of one step",
                                         .many = "Saved {file}, a lesson of {count} steps"},
                                        state.recording->lesson.steps.size(), {{"file", path.filename().string()}}),
                         false};
        state.recording.reset();
        return {};
    });
}

Outcome<void> drop(EditorState& state, const DropRecording&) {
    state.recording.reset();
    state.message = {"Dropped the recording", false};
    return {};
}

std::optional<Refusal> no_lesson(const EditorState& state) {
    if (state.lesson) return std::nullopt;
    return "no lesson is open";
}

std::optional<Refusal> no_next_step(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_lesson(state)) return refusal;
    if (!state.lesson->is_last()) return std::nullopt;
    return "this is the last step of the lesson";
}

std::optional<Refusal> no_previous_step(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_lesson(state)) return refusal;
    if (state.lesson->step > 0) return std::nullopt;
    return "this is the first step of the lesson";
}

std::optional<Refusal> no_solution(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_lesson(state)) return refusal;
    if (!state.lesson->present().solution.empty()) return std::nullopt;
    return "this step of the lesson has no task that could be shown";
}

std::optional<Refusal> is_recording(const EditorState& state) {
    if (!state.recording) return std::nullopt;
    return "a lesson is being recorded already";
}

std::optional<Refusal> no_recording(const EditorState& state) {
    if (state.recording) return std::nullopt;
    return "no lesson is being recorded";
}

// Nothing is wrong where a presenter presses once too often.
bool is_at_an_end(const EditorState& state) {
    return state.lesson.has_value();
}

}  // namespace

const CommandSpec& OpenLesson::spec() {
    static const CommandSpec spec{
        .name = "open-lesson",
        .title = "Open lesson",
        .explanation = "Opens a lesson at its first step.",
        .synonyms = "course tutorial teach",
        .group = CommandGroup::help,
        .submenu = lesson_menu,
        .offered = in_the_window,
        .fields = {field::text<&OpenLesson::name>("name", "the name of a lesson, or the path of its file")},
        .run = body_of<open_one>};
    return spec;
}

const CommandSpec& NextStep::spec() {
    static const CommandSpec spec{
        .name = "next-step",
        .title = "Next step",
        .explanation = "Goes on with the next step of the lesson: Page Down while one is open.",
        .synonyms = "lesson forward",
        .group = CommandGroup::help,
        .submenu = lesson_menu,
        .offered = in_the_window,
        .refusal = no_next_step,
        .is_idle = is_at_an_end,
        .run = body_of<go_on>};
    return spec;
}

const CommandSpec& PreviousStep::spec() {
    static const CommandSpec spec{
        .name = "previous-step",
        .title = "Previous step",
        .explanation = "Goes back to the step before, as it began: Page Up while a lesson is open.",
        .synonyms = "lesson backward",
        .group = CommandGroup::help,
        .submenu = lesson_menu,
        .offered = in_the_window,
        .refusal = no_previous_step,
        .is_idle = is_at_an_end,
        .run = body_of<go_back>};
    return spec;
}

const CommandSpec& SolveTask::spec() {
    static const CommandSpec spec{.name = "solve-task",
                                  .title = "Show solution",
                                  .explanation = "Does the task of the step.",
                                  .synonyms = "lesson answer",
                                  .group = CommandGroup::help,
                                  .submenu = lesson_menu,
                                  .offered = in_the_window,
                                  .refusal = no_solution,
                                  .run = body_of<solve>};
    return spec;
}

const CommandSpec& CloseLesson::spec() {
    static const CommandSpec spec{
        .name = "close-lesson",
        .title = "Close lesson",
        .explanation = "Leaves the lesson: its curves stay, and what was shown before is shown again.",
        .synonyms = "end",
        .group = CommandGroup::help,
        .submenu = lesson_menu,
        .offered = in_the_window,
        .refusal = no_lesson,
        .run = body_of<close>};
    return spec;
}

const CommandSpec& RecordLesson::spec() {
    static const CommandSpec spec{.name = "record-lesson",
                                  .title = "Record lesson",
                                  .explanation = "Makes a lesson of what is done from now on.",
                                  .synonyms = "macro steps",
                                  .group = CommandGroup::help,
                                  .submenu = lesson_menu,
                                  .offered = in_the_window,
                                  .fields = {field::text<&RecordLesson::title>("title", "what the lesson is called")},
                                  .refusal = is_recording,
                                  .run = body_of<begin>};
    return spec;
}

const CommandSpec& DescribeStep::spec() {
    static const CommandSpec spec{
        .name = "describe-step",
        .title = "Describe the step",
        .explanation = "Gives the last step of the lesson that is recorded its text.",
        .synonyms = "record write explain",
        .group = CommandGroup::help,
        .submenu = lesson_menu,
        .offered = in_the_window,
        .fields = {field::text<&DescribeStep::text>("text", "what is to be seen in the step")},
        .refusal = no_recording,
        .run = body_of<describe>};
    return spec;
}

const CommandSpec& SaveLesson::spec() {
    static const CommandSpec spec{.name = "save-lesson",
                                  .title = "Save lesson",
                                  .explanation = "Ends the recording and saves it as a lesson.",
                                  .synonyms = "record stop",
                                  .group = CommandGroup::help,
                                  .submenu = lesson_menu,
                                  .offered = in_the_window,
                                  .fields = {field::file<&SaveLesson::path>("path", "the file")},
                                  .refusal = no_recording,
                                  .run = body_of<save>};
    return spec;
}

const CommandSpec& DropRecording::spec() {
    static const CommandSpec spec{.name = "drop-recording",
                                  .title = "Drop recording",
                                  .explanation = "Ends the recording without a lesson.",
                                  .synonyms = "record stop cancel",
                                  .group = CommandGroup::help,
                                  .submenu = lesson_menu,
                                  .offered = in_the_window,
                                  .refusal = no_recording,
                                  .run = body_of<drop>};
    return spec;
}

void add_lesson_commands(CommandTable& table) {
    add_all<OpenLesson, NextStep, PreviousStep, SolveTask, CloseLesson, RecordLesson, DescribeStep, SaveLesson,
            DropRecording>(table);
}

}  // namespace batten::editor
