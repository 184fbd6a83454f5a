/// A lesson: a document, and steps that show something in it or ask for it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/lesson/check.h"
#include "app/editor/state/notation.h"
#include "app/editor/state/shape_view.h"
#include "core/document/document.h"

namespace batten::editor {

/// How the document is looked at from a step on.
struct LessonView {
    std::optional<std::vector<Overlay>> overlays{};  ///< all that are shown; none: as before
    std::optional<double> parameter{};
    std::optional<int> level{};  ///< of the construction; as high as the degree: all of it
};

struct LessonStep {
    std::string text;                          ///< in the notation of render::Label; what is to be seen
    std::string task{};                        ///< what is to be done; may be empty
    std::vector<std::string> acts{};           ///< lines of a session, run when the step begins
    std::optional<core::Document> document{};  ///< that takes the place of the one before
    LessonView view{};
    std::vector<LessonCheck> checks{};    ///< all of them hold when the task is done
    std::vector<std::string> solution{};  ///< acts that do the task
};

struct Lesson {
    std::string name;  ///< of its file, without the ending
    std::string title;
    std::string text;  ///< what it is about
    std::optional<Notation> notation{};
    core::Document document;
    LessonView view{};
    std::vector<LessonStep> steps;  ///< at least one
};

/// What stood when a step began, to come back to it.
struct LessonPlace {
    core::Document document;
    Overlays overlays;
    double parameter = 0.0;
    std::optional<int> level{};
    ShapeView shape{};  ///< the line of variation diminishing among it
};

/// What was shown before a lesson was opened, to be shown again when it is closed.
struct ViewsBefore {
    Overlays overlays;
    Notation notation;
    std::optional<int> level{};
};

/// A lesson that is being taken.
struct LessonRun {
    std::shared_ptr<const Lesson> lesson;  ///< not null
    ViewsBefore before{};                  ///< the first one of lessons that follow one another
    std::size_t step = 0;
    std::vector<LessonPlace> begun{};  ///< the steps up to this one as they began

    const LessonStep& present() const { return lesson->steps[step]; }
    bool is_last() const { return step + 1 == lesson->steps.size(); }
};

/// A lesson that is made from what is done.
struct LessonRecording {
    Lesson lesson;
    std::vector<LessonStep> undone{};  ///< steps that undo took back, the last one first
    LessonPlace last{};                ///< what stands after the last step
};

/// What stands now.
LessonPlace place_of(const EditorState& state);

/// The results of the checks of the present step, in order; none where it has none.
std::vector<CheckResult> results_of(const LessonRun& run, const EditorState& state);

/// Whether the present step has a task that is done.
bool is_done(const LessonRun& run, const EditorState& state);

}  // namespace batten::editor
