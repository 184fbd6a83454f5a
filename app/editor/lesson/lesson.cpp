#include "app/editor/lesson/lesson.h"

#include <algorithm>

#include "app/editor/state/state.h"

namespace batten::editor {

LessonPlace place_of(const EditorState& state) {
    return {state.history.present(), state.view.overlays, state.view.parameter, state.view.level, state.view.shape};
}

std::vector<CheckResult> results_of(const LessonRun& run, const EditorState& state) {
    std::vector<CheckResult> results;
    for (const LessonCheck& check : run.present().checks) results.push_back(result_of(check, state));
    return results;
}

bool is_done(const LessonRun& run, const EditorState& state) {
    const std::vector<LessonCheck>& checks = run.present().checks;
    return !checks.empty() && std::all_of(checks.begin(), checks.end(),
                                          [&](const LessonCheck& check) { return result_of(check, state).holds; });
}

}  // namespace batten::editor
