#include "app/editor/lesson/lesson_steps.h"

#include "app/editor/commands/file_acts.h"
#include "app/editor/lesson/lesson_file.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/run_command.h"
#include "app/editor/session.h"
#include "app/editor/state/view_forms.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

void take_view(View& view, const LessonView& wanted) {
    if (wanted.overlays) {
        for (std::size_t i = 0; i < overlay_count; ++i) view.overlays.show(static_cast<Overlay>(i), false);
        for (const Overlay overlay : *wanted.overlays) view.overlays.show(overlay, true);
    }
    if (wanted.parameter) view.parameter = *wanted.parameter;
    if (wanted.level) view.level = wanted.level;
}

/// Another document in the same lesson; the view stays.
void replace_document(EditorState& state, const core::Document& document) {
    const View view = state.view;
    const std::optional<LessonRun> run = state.lesson;
    show_document(state, document, {});
    state.lesson = run;
    state.view.overlays = view.overlays;
    state.view.parameter = view.parameter;
    state.view.level = view.level;
    state.view.notation = view.notation;
    take_forms(state.view, forms_of(view));
}

Outcome<void> run_acts(EditorState& state, const std::vector<std::string>& acts) {
    for (const std::string& line : acts) {
        const Outcome<Command> command = parse_command(line, state);
        if (!command) return tl::unexpected(command.error());
        const std::optional<LessonRun> run = state.lesson;
        const bool is_done = run_checked(state, *command, Phase::commit);
        state.lesson = run;
        if (!is_done) return tl::unexpected(state.message.text);
    }
    return {};
}

/// Makes the present step of the lesson be seen.
Outcome<void> begin_step(EditorState& state) {
    const std::shared_ptr<const Lesson> lesson = state.lesson->lesson;
    const LessonStep& step = lesson->steps[state.lesson->step];
    if (step.document) replace_document(state, *step.document);
    take_view(state.view, step.view);
    Outcome<void> outcome = run_acts(state, step.acts);
    // An act may move the parameter, which the step has a word about.
    take_view(state.view, step.view);
    state.history.mark_saved();
    if (state.lesson->begun.size() == state.lesson->step) state.lesson->begun.push_back(place_of(state));
    state.message = {
        core::sentence("Step {step} of {count}", {{"step", state.lesson->step + 1}, {"count", lesson->steps.size()}}),
        false};
    return outcome;
}

fs::path path_of(const EditorState& state, const std::string& name) {
    const fs::path path(name);
    const bool is_name = !path.has_parent_path() && !path.has_extension();
    return is_name ? (state.desktop.lessons / path).concat(".json") : absolute_path(path);
}

}  // namespace

Outcome<void> open_lesson(EditorState& state, const std::string& name) {
    Outcome<Lesson> lesson = load_lesson(path_of(state, name));
    if (!lesson) return tl::unexpected(lesson.error());
    return begin_lesson(state, std::make_shared<const Lesson>(*std::move(lesson)));
}

Outcome<void> begin_lesson(EditorState& state, std::shared_ptr<const Lesson> lesson) {
    const View& view = state.view;
    const ViewsBefore before =
        state.lesson ? state.lesson->before : ViewsBefore{view.overlays, view.notation, view.level};
    show_document(state, lesson->document, {});
    if (lesson->notation) state.view.notation = *lesson->notation;
    take_view(state.view, lesson->view);
    state.lesson = LessonRun{std::move(lesson), before};
    return begin_step(state);
}

Outcome<void> begin_next_step(EditorState& state) {
    ++state.lesson->step;
    return begin_step(state);
}

Outcome<void> do_task(EditorState& state) {
    const std::shared_ptr<const Lesson> lesson = state.lesson->lesson;
    return run_acts(state, state.lesson->present().solution);
}

void go_back_a_step(EditorState& state) {
    LessonRun& run = *state.lesson;
    run.begun.resize(run.step);
    --run.step;
    const LessonPlace place = run.begun.back();
    replace_document(state, place.document);
    state.view.overlays = place.overlays;
    state.view.parameter = place.parameter;
    state.view.level = place.level;
    state.view.shape = place.shape;
}

void close_lesson(EditorState& state) {
    const ViewsBefore before = state.lesson->before;
    state.lesson.reset();
    state.view.overlays = before.overlays;
    state.view.notation = before.notation;
    state.view.level = before.level;
}

}  // namespace batten::editor
